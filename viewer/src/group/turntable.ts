import type { Quaternion } from 'three';
import type { Extent } from '../scene/extent';
import { listenToPointer, type Place, type Turnable } from '../scene/pointer';
import type { View } from '../scene/view';
import type { Painter } from './painter';

export interface TurntableEvents {
  /** The shapes were turned by hand. */
  turned: (rotation: Quaternion) => void;
  hover?: (view: View | null, place: Place | null) => void;
  click?: (view: View | null, place: Place) => void;
  letGo?: () => void;
  /** Draws over the shapes, in CSS pixels. */
  annotate?: (context: CanvasRenderingContext2D) => void;
}

/** A canvas with views side by side, or above each other where it is narrow, that move together. */
export class Turntable implements Turnable {
  private readonly context: CanvasRenderingContext2D;
  private width = 1;
  private height = 1;
  private ratio = 1;
  private scheduled = false;
  private seen = true;
  private outdated = false;

  constructor(
    private readonly box: HTMLElement,
    private readonly painter: Painter,
    private readonly views: readonly View[],
    private readonly extent: (view: View) => Extent,
    private readonly events: TurntableEvents,
  ) {
    const canvas = document.createElement('canvas');
    this.context = canvas.getContext('2d')!;
    box.append(canvas);
    new ResizeObserver(() => this.resize()).observe(box);
    new IntersectionObserver((entries) => this.notice(entries)).observe(box);
    listenToPointer(box, this);
    this.resize();
  }

  redraw(): void {
    this.outdated = true;
    if (this.scheduled || !this.seen) return;
    this.scheduled = true;
    requestAnimationFrame(() => this.render());
  }

  reset(): void {
    for (const { orbit } of this.views) orbit.reset();
    this.redraw();
  }

  turnTo(rotation: Quaternion): void {
    for (const { orbit } of this.views) orbit.rotation.copy(rotation);
    this.redraw();
  }

  viewAt(x: number, y: number): View | null {
    return this.views.find((view) => view.contains(x, y)) ?? null;
  }

  visibleView(view: View | null): View {
    return view ?? this.views[0]!;
  }

  moveView(view: View, move: (view: View) => void): void {
    move(view);
    for (const other of this.views) if (other !== view) other.orbit.copy(view.orbit);
    this.redraw();
    this.events.turned(view.orbit.rotation);
  }

  hoverAt(place: Place | null): void {
    this.events.hover?.(place && this.viewAt(place.x, place.y), place);
  }

  clickAt(place: Place): void {
    this.events.click?.(this.viewAt(place.x, place.y), place);
  }

  letGo(): void {
    this.events.letGo?.();
  }

  /** What is out of sight is drawn when it comes back. */
  private notice(entries: IntersectionObserverEntry[]): void {
    this.seen = entries.at(-1)!.isIntersecting;
    if (this.outdated) this.redraw();
  }

  private resize(): void {
    const { canvas } = this.context;
    this.width = Math.max(1, this.box.clientWidth);
    this.height = Math.max(1, this.box.clientHeight);
    this.ratio = Math.min(2, window.devicePixelRatio);
    canvas.width = Math.round(this.width * this.ratio);
    canvas.height = Math.round(this.height * this.ratio);
    this.layOut();
    this.render();
  }

  private layOut(): void {
    const count = this.views.length;
    const wide = this.width > 0.9 * this.height;
    const width = wide ? this.width / count : this.width;
    const height = wide ? this.height : this.height / count;
    this.views.forEach((view, k) => {
      view.rectangle = { x: wide ? k * width : 0, y: wide ? 0 : k * height, width, height };
    });
  }

  private render(): void {
    this.scheduled = false;
    this.outdated = false;
    const views = this.views.map((view): [View, Extent] => [view, this.extent(view)]);
    this.painter.paint([{ context: this.context, views, ratio: this.ratio }]);
    this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.events.annotate?.(this.context);
  }
}
