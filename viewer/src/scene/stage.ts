import { WebGLRenderer } from 'three';
import { colorsOf, type Colors, Patches } from '../color/coloring';
import type { Result, Side } from '../data/result';
import type { Point, State, PairStore } from '../state';
import { drawAnnotations } from './annotations';
import type { Extent } from './extent';
import { extentOf } from './pair_extent';
import { listenToPointer, type Place, type Turnable } from './pointer';
import { Surface } from './surface';
import { View } from './view';

const CHECKER_SQUARES = 14;

/** The canvas on which both shapes are seen, and the drawing of matches over it. */
export class Stage implements Turnable {
  readonly views: Record<Side, View> = { source: new View(), target: new View() };
  readonly surfaces: Record<Side, Surface>;
  readonly patches: Patches;
  colors: Colors | null = null;
  /** Called when colours have changed. */
  onColors: (colors: Colors) => void = () => {};

  private readonly renderer: WebGLRenderer;
  private readonly overlay: CanvasRenderingContext2D;
  private readonly extent: Extent;
  private width = 1;
  private height = 1;
  private scheduled = false;

  constructor(
    private readonly box: HTMLElement,
    private readonly result: Result,
    private readonly store: PairStore,
  ) {
    this.surfaces = { source: new Surface(result.source), target: new Surface(result.target) };
    this.patches = new Patches(result);
    this.extent = extentOf(result);
    this.renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setScissorTest(true);
    const canvas = document.createElement('canvas');
    canvas.className = 'overlay';
    this.overlay = canvas.getContext('2d')!;
    box.append(this.renderer.domElement, canvas);
    this.update(store.state, new Set(Object.keys(store.state) as (keyof State)[]));
    store.listen((state, changed) => this.update(state, changed));
    new ResizeObserver(() => this.resize()).observe(box);
    listenToPointer(box, this);
    this.resize();
    this.render();
  }

  /** Draws at the next opportunity. */
  redraw(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => this.render());
  }

  viewAt(x: number, y: number): View | null {
    return this.visibleViews().find((view) => view.contains(x, y)) ?? null;
  }

  /** `view` if it is on the canvas, otherwise the first that is. */
  visibleView(view: View | null): View {
    const views = this.visibleViews();
    return view && views.includes(view) ? view : views[0]!;
  }

  /** Changes what is seen in `view`, or in both if they are linked. */
  moveView(view: View, move: (view: View) => void): void {
    move(view);
    const { linked, layout } = this.store.state;
    if (linked && layout === 'pair') {
      for (const other of Object.values(this.views)) other.orbit.copy(view.orbit);
    }
    this.redraw();
  }

  /** As the page was at first, without a vertex that was clicked on. */
  resetViews(): void {
    for (const view of Object.values(this.views)) view.orbit.reset();
    this.select(null);
    this.redraw();
  }

  hoverAt(place: Place | null): void {
    this.hover(place && this.pointAt(place.x, place.y));
  }

  clickAt(place: Place): void {
    this.select(this.pointAt(place.x, place.y));
  }

  letGo(): void {
    this.select(null);
  }

  /** What lies at a place on the canvas. */
  private pointAt(x: number, y: number): Point | null {
    const view = this.viewAt(x, y);
    if (!view) return null;
    const overlay = this.store.state.layout === 'overlay';
    const side = overlay || view === this.views.source ? 'source' : 'target';
    const vertex = view.pick(this.surfaces[side], x, y);
    return vertex < 0 ? null : { side, vertex };
  }

  private hover(point: Point | null): void {
    const { hovered } = this.store.state;
    if (hovered?.side === point?.side && hovered?.vertex === point?.vertex) return;
    this.store.set({ hovered: point });
  }

  private select(point: Point | null): void {
    this.store.set({ selected: point });
  }

  private visibleViews(): View[] {
    const { source, target } = this.views;
    return this.store.state.layout === 'overlay' ? [target] : [source, target];
  }

  private update(state: State, changed: Set<keyof State>): void {
    const any = (...keys: (keyof State)[]) => keys.some((key) => changed.has(key));
    if (any('map')) {
      const map = this.result.map(state.map);
      this.surfaces.source.setMoved(map.registered, map.registeredNormal);
    }
    if (any('coloring', 'map') || (any('level') && state.coloring === 'patches')) this.paint(state);
    if (any('layout')) this.arrange(state);
    if (any('linked') && state.linked) this.views.target.orbit.copy(this.views.source.orbit);
    this.surfaces.source.setMorph(state.morph);
    this.redraw();
  }

  private paint(state: State): void {
    const colors = colorsOf(this.result, state, this.patches);
    const squares = state.coloring === 'checker' ? CHECKER_SQUARES : 0;
    this.colors = colors;
    const { place, partner, back } = this.result.map(state.map);
    this.surfaces.source.setColors(colors.source);
    this.surfaces.target.setColors(colors.target);
    this.surfaces.source.setPlaces(place, partner);
    this.surfaces.target.setPlaces(this.result.target.place!, back);
    for (const surface of Object.values(this.surfaces)) surface.setChecker(squares);
    this.onColors(colors);
  }

  /** Puts the shapes into the views. */
  private arrange(state: State): void {
    const overlay = state.layout === 'overlay';
    for (const view of Object.values(this.views)) view.scene.clear();
    this.views.target.scene.add(this.surfaces.target.mesh);
    (overlay ? this.views.target : this.views.source).scene.add(this.surfaces.source.mesh);
    this.surfaces.target.setGhost(overlay);
    this.layOut();
  }

  private layOut(): void {
    const { source, target } = this.views;
    const whole = { x: 0, y: 0, width: this.width, height: this.height };
    if (this.store.state.layout === 'overlay') {
      target.rectangle = whole;
    } else if (this.width > 0.9 * this.height) {
      source.rectangle = { ...whole, width: this.width / 2 };
      target.rectangle = { ...source.rectangle, x: this.width / 2 };
    } else {
      source.rectangle = { ...whole, height: this.height / 2 };
      target.rectangle = { ...source.rectangle, y: this.height / 2 };
    }
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.box;
    this.width = Math.max(1, clientWidth);
    this.height = Math.max(1, clientHeight);
    const ratio = Math.min(2, window.devicePixelRatio);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.width, this.height);
    const { canvas } = this.overlay;
    canvas.width = this.width * ratio;
    canvas.height = this.height * ratio;
    this.overlay.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.layOut();
    this.redraw();
  }

  private render(): void {
    this.scheduled = false;
    this.renderer.setScissor(0, 0, this.width, this.height);
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
    for (const view of this.visibleViews()) {
      const { x, y, width, height } = view.rectangle;
      view.aim(view.orbit, this.extent);
      const bottom = this.height - y - height;
      this.renderer.setViewport(x, bottom, width, height);
      this.renderer.setScissor(x, bottom, width, height);
      this.renderer.render(view.scene, view.camera);
    }
    this.overlay.clearRect(0, 0, this.width, this.height);
    drawAnnotations(this.overlay, this, this.result, this.store.state);
  }

  /** The view in which a side is seen. */
  viewOf(side: Side): View {
    return this.store.state.layout === 'overlay' ? this.views.target : this.views[side];
  }
}
