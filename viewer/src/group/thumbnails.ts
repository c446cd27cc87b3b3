import type { Quaternion } from 'three';
import { Extent } from '../scene/extent';
import { Surface } from '../scene/surface';
import { View } from '../scene/view';
import type { Collection } from './collection';
import type { Coloring } from './coloring';
import type { Painter } from './painter';
import type { GroupColoring } from './state';

/** In CSS pixels. */
export const THUMBNAIL = { width: 150, height: 112 };

/** Of each frame, in milliseconds, so that the page stays smooth. */
const BUDGET = 10;

interface Thumbnail {
  context: CanvasRenderingContext2D;
  surface: Surface;
  view: View;
  extent: Extent;
  painted: Float32Array | null;
}

/** Pictures of all shapes, drawn when they come into sight, a few each frame. */
export class Thumbnails {
  private readonly made = new Map<number, Thumbnail>();
  private readonly outdated = new Set<number>();
  private readonly seen = new Set<number>();
  private readonly canvases: HTMLCanvasElement[] = [];
  private readonly observer: IntersectionObserver;
  private readonly ratio = Math.min(2, window.devicePixelRatio);
  private rotation: Quaternion | null = null;
  private scheduled = false;

  constructor(
    private readonly collection: Collection,
    private readonly coloring: Coloring,
    private readonly painter: Painter,
    private mode: GroupColoring,
  ) {
    this.observer = new IntersectionObserver((entries) => this.notice(entries), {
      rootMargin: '200px',
    });
  }

  /** Draws into `canvas` from now on. */
  add(member: number, canvas: HTMLCanvasElement): void {
    canvas.width = THUMBNAIL.width * this.ratio;
    canvas.height = THUMBNAIL.height * this.ratio;
    this.canvases[member] = canvas;
    this.outdated.add(member);
    this.observer.observe(canvas);
  }

  color(mode: GroupColoring): void {
    this.mode = mode;
    this.redraw();
  }

  turnTo(rotation: Quaternion): void {
    this.rotation = rotation.clone();
    this.redraw();
  }

  private redraw(): void {
    this.canvases.forEach((_, member) => this.outdated.add(member));
    this.schedule();
  }

  private notice(entries: IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of entries) {
      const member = this.canvases.indexOf(target as HTMLCanvasElement);
      if (isIntersecting) this.seen.add(member);
      else this.seen.delete(member);
    }
    this.schedule();
  }

  private schedule(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => this.paintSome());
  }

  private paintSome(): void {
    this.scheduled = false;
    const begun = performance.now();
    for (const member of this.outdated) {
      if (!this.seen.has(member)) continue;
      this.paint(member);
      this.outdated.delete(member);
      if (performance.now() - begun > BUDGET) break;
    }
    if ([...this.outdated].some((member) => this.seen.has(member))) this.schedule();
  }

  private paint(member: number): void {
    const thumbnail = this.thumbnail(member);
    const { context, surface, view, extent } = thumbnail;
    const colors = this.coloring.ofMember(member, this.mode);
    if (thumbnail.painted !== colors) surface.setColors(colors);
    thumbnail.painted = colors;
    if (this.rotation) view.orbit.rotation.copy(this.rotation);
    this.painter.paint(context, [[view, extent]], this.ratio);
  }

  private thumbnail(member: number): Thumbnail {
    let thumbnail = this.made.get(member);
    if (!thumbnail) {
      const shape = this.collection.shape(member);
      const surface = new Surface(shape);
      const view = new View();
      view.rectangle = { x: 0, y: 0, ...THUMBNAIL };
      view.scene.add(surface.mesh);
      const context = this.canvases[member]!.getContext('2d')!;
      thumbnail = { context, surface, view, extent: new Extent([shape.position]), painted: null };
      this.made.set(member, thumbnail);
    }
    return thumbnail;
  }
}
