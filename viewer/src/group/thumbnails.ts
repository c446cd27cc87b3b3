import { Quaternion, Vector3 } from 'three';
import { Extent } from '../scene/extent';
import { Surface } from '../scene/surface';
import { View } from '../scene/view';
import type { Collection } from './collection';
import type { Coloring } from './coloring';
import type { Painter, Picture } from './painter';
import type { GroupColoring } from './state';

/** In CSS pixels. */
export const THUMBNAIL = { width: 150, height: 112 };

/** Of a frame; slower ones draw fewer thumbnails. In milliseconds. */
const FRAME = 34;
const MOST = 12;

interface Thumbnail {
  context: CanvasRenderingContext2D;
  surface: Surface;
  view: View;
  painted: Float32Array | null;
}

function turned(position: Float32Array, rotation: Quaternion): Float32Array {
  const result = new Float32Array(position.length);
  const point = new Vector3();
  for (let i = 0; i < position.length; i += 3)
    point.fromArray(position, i).applyQuaternion(rotation).toArray(result, i);
  return result;
}

/** Pictures of all shapes, drawn when they come into sight, a few each frame. */
export class Thumbnails {
  private readonly made = new Map<number, Thumbnail>();
  private readonly outdated = new Set<number>();
  private readonly seen = new Set<number>();
  private readonly canvases: HTMLCanvasElement[] = [];
  private readonly observer: IntersectionObserver;
  private readonly ratio = Math.min(2, window.devicePixelRatio);
  private rotation = new Quaternion();
  private scheduled = false;
  private perFrame = 4;
  /** When the frame before was drawn; 0 after a pause. */
  private before = 0;

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
    const waiting = [...this.outdated].filter((member) => this.seen.has(member));
    if (waiting.length === 0) {
      this.before = 0;
      return;
    }
    this.adapt();
    const now = waiting.slice(0, this.perFrame);
    this.painter.paint(now.map((member) => this.picture(member)));
    for (const member of now) this.outdated.delete(member);
    this.schedule();
  }

  /** Draws more each frame, or fewer after one that took long. */
  private adapt(): void {
    const now = performance.now();
    if (this.before > 0) {
      const slow = now - this.before > FRAME;
      this.perFrame = slow ? Math.max(1, this.perFrame >> 1) : Math.min(MOST, this.perFrame + 1);
    }
    this.before = now;
  }

  private picture(member: number): Picture {
    const thumbnail = this.thumbnail(member);
    const { context, surface, view } = thumbnail;
    const colors = this.coloring.ofMember(member, this.mode);
    if (thumbnail.painted !== colors) surface.setColors(colors);
    thumbnail.painted = colors;
    view.orbit.rotation.copy(this.rotation);
    // All of a shape is in sight, however it is turned.
    const extent = new Extent([turned(this.collection.shape(member).position, this.rotation)]);
    return { context, views: [[view, extent]], ratio: this.ratio };
  }

  private thumbnail(member: number): Thumbnail {
    let thumbnail = this.made.get(member);
    if (!thumbnail) {
      const surface = new Surface(this.collection.shape(member));
      const view = new View();
      view.rectangle = { x: 0, y: 0, ...THUMBNAIL };
      view.scene.add(surface.mesh);
      const context = this.canvases[member]!.getContext('2d')!;
      thumbnail = { context, surface, view, painted: null };
      this.made.set(member, thumbnail);
    }
    return thumbnail;
  }
}
