import type { Quaternion } from 'three';
import { Extent } from '../scene/extent';
import type { Place } from '../scene/pointer';
import { Surface } from '../scene/surface';
import { View } from '../scene/view';
import type { Collection } from './collection';
import type { Coloring } from './coloring';
import type { Painter } from './painter';
import type { GroupStore } from './state';
import { Turntable } from './turntable';

interface Side {
  view: View;
  surface: Surface;
}

/** The template and the selected shape, large, side by side. */
export class Detail {
  private readonly template: Side;
  private readonly shape: Side;
  private extent: Extent;
  private readonly table: Turntable;

  constructor(
    private readonly box: HTMLElement,
    private readonly collection: Collection,
    private readonly coloring: Coloring,
    painter: Painter,
    private readonly store: GroupStore,
    turned: (rotation: Quaternion) => void,
  ) {
    this.template = { view: new View(), surface: new Surface(collection.template) };
    this.template.view.scene.add(this.template.surface.mesh);
    this.shape = this.sideOf(store.state.selected, new View());
    this.extent = this.extentOf(store.state.selected);
    this.paint();
    const views = [this.template.view, this.shape.view];
    this.table = new Turntable(box, painter, views, () => this.extent, {
      turned,
      hover: (view, place) => this.hover(this.pointAt(view, place)),
      click: (view, place) => store.set({ kept: this.pointAt(view, place) }),
      letGo: () => store.set({ kept: null }),
      annotate: (context) => this.mark(context),
    });
    store.listen((state, changed) => {
      if (changed.has('selected')) this.show(state.selected);
      if (changed.has('selected') || changed.has('coloring')) this.paint();
      this.table.redraw();
    });
  }

  turnTo(rotation: Quaternion): void {
    this.table.turnTo(rotation);
  }

  reset(): void {
    this.table.reset();
    this.store.set({ kept: null });
  }

  redraw(): void {
    this.table.redraw();
  }

  private sideOf(member: number, view: View): Side {
    const surface = new Surface(this.collection.shape(member));
    view.scene.clear();
    view.scene.add(surface.mesh);
    return { view, surface };
  }

  private extentOf(member: number): Extent {
    const { template } = this.collection;
    return new Extent([template.position, this.collection.shape(member).position]);
  }

  private show(member: number): void {
    this.shape.surface = this.sideOf(member, this.shape.view).surface;
    this.extent = this.extentOf(member);
  }

  private paint(): void {
    const { selected, coloring } = this.store.state;
    this.template.surface.setColors(this.coloring.ofTemplate(selected, coloring));
    this.shape.surface.setColors(this.coloring.ofMember(selected, coloring));
  }

  private hover(point: number | null): void {
    if (point !== this.store.state.hovered) this.store.set({ hovered: point });
  }

  private pointAt(view: View | null, place: Place | null): number | null {
    if (!view || !place) return null;
    const { surface } = view === this.template.view ? this.template : this.shape;
    const point = view.pick(surface, place.x, place.y);
    return point < 0 ? null : point;
  }

  /** The point that is pointed at, on both shapes. */
  private mark(context: CanvasRenderingContext2D): void {
    const { hovered, kept, selected } = this.store.state;
    const point = hovered ?? kept;
    if (point === null) return;
    const sides = [this.template];
    if (this.collection.isThere(selected, point)) sides.push(this.shape);
    context.fillStyle = getComputedStyle(this.box).getPropertyValue('--accent') || '#06c';
    context.strokeStyle = '#fff';
    context.lineWidth = 2;
    for (const { view, surface } of sides) {
      const { x, y, facing } = view.project(surface, point);
      context.globalAlpha = facing ? 1 : 0.4;
      context.beginPath();
      context.arc(x, y, 6, 0, 2 * Math.PI);
      context.fill();
      context.stroke();
    }
    context.globalAlpha = 1;
  }
}
