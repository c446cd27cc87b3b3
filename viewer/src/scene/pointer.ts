import type { View } from './view';

const TURN = 0.008;

/** In CSS pixels, from the canvas's top left. */
export interface Place {
  x: number;
  y: number;
}

/** A canvas whose views are turned, and whose shapes are pointed at. */
export interface Turnable {
  viewAt(x: number, y: number): View | null;
  /** `view` if it is on the canvas, otherwise the first that is. */
  visibleView(view: View | null): View;
  moveView(view: View, move: (view: View) => void): void;
  /** Where the pointer is; null once it has left. */
  hoverAt(place: Place | null): void;
  clickAt(place: Place): void;
  /** Escape was pressed. */
  letGo(): void;
}

/** Turns, shifts and zooms with mouse, fingers and keys; hovers and selects. */
class Pointer {
  private readonly fingers = new Map<number, Place>();
  private view: View | null = null;
  private moved = 0;
  private hoverAt: Place | null = null;

  constructor(
    private readonly box: HTMLElement,
    private readonly stage: Turnable,
  ) {}

  private at(event: PointerEvent | WheelEvent | MouseEvent): Place {
    const { left, top } = this.box.getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  }

  down(event: PointerEvent): void {
    const finger = this.at(event);
    this.box.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, finger);
    if (this.fingers.size === 1) {
      this.view = this.stage.viewAt(finger.x, finger.y);
      this.moved = 0;
    }
  }

  move(event: PointerEvent): void {
    const before = this.fingers.get(event.pointerId);
    const now = this.at(event);
    if (!before) {
      this.hoverSoon(now);
      return;
    }
    const dx = now.x - before.x;
    const dy = now.y - before.y;
    this.moved += Math.abs(dx) + Math.abs(dy);
    this.drag(event, before, now, dx, dy);
    this.fingers.set(event.pointerId, now);
  }

  private drag(event: PointerEvent, before: Place, now: Place, dx: number, dy: number): void {
    const { view } = this;
    if (!view) return;
    const { height } = view.rectangle;
    const other = [...this.fingers].find(([id]) => id !== event.pointerId)?.[1];
    this.stage.moveView(view, ({ orbit }) => {
      if (other) {
        const spread = (finger: Place) => Math.hypot(finger.x - other.x, finger.y - other.y) || 1;
        orbit.scale(spread(now) / spread(before));
        orbit.pan(dx / 2 / height, -dy / 2 / height);
      } else if (event.shiftKey || (event.buttons & 6) !== 0) {
        orbit.pan(dx / height, -dy / height);
      } else {
        orbit.turn(dx * TURN, dy * TURN);
      }
    });
  }

  up(event: PointerEvent): void {
    const finger = this.fingers.get(event.pointerId);
    this.fingers.delete(event.pointerId);
    const CLICK = 5;
    if (finger && this.moved < CLICK && event.type === 'pointerup') this.stage.clickAt(finger);
  }

  private hoverSoon(finger: Place): void {
    const waiting = this.hoverAt !== null;
    this.hoverAt = finger;
    if (waiting) return;
    requestAnimationFrame(() => {
      const place = this.hoverAt;
      this.hoverAt = null;
      if (place && this.fingers.size === 0) this.stage.hoverAt(place);
    });
  }

  leave(): void {
    this.hoverAt = null;
    this.stage.hoverAt(null);
  }

  /** Zooms once the shapes were clicked on, or with Ctrl, as pinching a touch pad is told; the page
   * scrolls otherwise. */
  wheel(event: WheelEvent): void {
    const wanted = event.ctrlKey || event.metaKey || document.activeElement === this.box;
    const finger = this.at(event);
    const view = this.stage.viewAt(finger.x, finger.y);
    if (!wanted || !view) return;
    event.preventDefault();
    this.stage.moveView(view, ({ orbit }) => orbit.scale(Math.exp(-event.deltaY * 0.0015)));
  }

  key(event: KeyboardEvent): void {
    const STEP = 0.12;
    const act: Record<string, (view: View) => void> = {
      ArrowLeft: ({ orbit }) => orbit.turn(-STEP, 0),
      ArrowRight: ({ orbit }) => orbit.turn(STEP, 0),
      ArrowUp: ({ orbit }) => orbit.turn(0, -STEP),
      ArrowDown: ({ orbit }) => orbit.turn(0, STEP),
      '+': ({ orbit }) => orbit.scale(1.15),
      '=': ({ orbit }) => orbit.scale(1.15),
      '-': ({ orbit }) => orbit.scale(1 / 1.15),
      '0': ({ orbit }) => orbit.reset(),
    };
    const action = act[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.stage.moveView(this.stage.visibleView(this.view), action);
  }
}

export function listenToPointer(box: HTMLElement, stage: Turnable): void {
  const pointer = new Pointer(box, stage);
  box.addEventListener('pointerdown', (event) => pointer.down(event));
  box.addEventListener('pointermove', (event) => pointer.move(event));
  box.addEventListener('pointerup', (event) => pointer.up(event));
  box.addEventListener('pointercancel', (event) => pointer.up(event));
  box.addEventListener('pointerleave', () => pointer.leave());
  box.addEventListener('wheel', (event) => pointer.wheel(event), { passive: false });
  box.addEventListener('keydown', (event) => pointer.key(event));
  document.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') stage.letGo();
  });
  box.addEventListener('contextmenu', (event) => event.preventDefault());
}
