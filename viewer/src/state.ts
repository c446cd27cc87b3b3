import type { Side } from './data/result';

export type Coloring =
  'map' | 'checker' | 'confidence' | 'd_iso' | 'error' | 'curvature' | 'patches';
export type Layout = 'pair' | 'overlay';

export interface Point {
  side: Side;
  vertex: number;
}

/** What the page shows. */
export interface State {
  coloring: Coloring;
  /** 0 is the best map, then the alternatives. */
  map: number;
  /** Of the paper's method; its last level is the final map. */
  level: number;
  layout: Layout;
  linked: boolean;
  /** 0: the source as it is, 1: in the target's pose. */
  morph: number;
  lines: number;
  worstIso: boolean;
  worstTruth: boolean;
  /** Under the pointer, and clicked on, which stays. */
  hovered: Point | null;
  selected: Point | null;
}

type Listener = (state: State, changed: Set<keyof State>) => void;

/** Tells listeners what changed, in the order in which they came. */
export class Store {
  private readonly listeners: Listener[] = [];

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

  listen(listener: Listener): void {
    this.listeners.push(listener);
  }
}
