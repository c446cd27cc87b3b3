type Listener<State> = (state: State, changed: Set<keyof State>) => void;

/** Tells listeners what changed, in the order in which they came. */
export class Store<State> {
  private readonly listeners: Listener<State>[] = [];

  constructor(private current: State) {}

  get state(): Readonly<State> {
    return this.current;
  }

  set(change: Partial<State>): void {
    const keys = (Object.keys(change) as (keyof State)[]).filter(
      (key) => this.current[key] !== change[key],
    );
    if (keys.length === 0) return;
    this.current = { ...this.current, ...change };
    const changed = new Set(keys);
    for (const listener of this.listeners) listener(this.current, changed);
  }

  listen(listener: Listener<State>): void {
    this.listeners.push(listener);
  }
}
