import type { Quaternion } from 'three';
import { Extent } from '../scene/extent';
import { Surface } from '../scene/surface';
import { View } from '../scene/view';
import { h } from '../ui/dom';
import { deviation, percent } from '../ui/format';
import { sliderOf } from '../ui/inputs';
import type { Coloring } from './coloring';
import type { Model } from './model';
import type { Painter } from './painter';
import type { GroupStore } from './state';
import { Turntable } from './turntable';

/** Of the sliders, in standard deviations. */
export const REACH = 3;

/** The mean shape as the sliders deform it. */
export class MeanShape {
  private readonly surface: Surface;
  private readonly view = new View();
  private readonly table: Turntable;

  constructor(
    box: HTMLElement,
    private readonly model: Model,
    coloring: Coloring,
    painter: Painter,
    store: GroupStore,
    turned: (rotation: Quaternion) => void,
  ) {
    this.surface = new Surface(model.shape);
    this.view.scene.add(this.surface.mesh);
    this.surface.setColors(coloring.ofAll(store.state.coloring));
    const extent = new Extent(this.extremes());
    this.table = new Turntable(box, painter, [this.view], () => extent, { turned });
    store.listen((state, changed) => {
      if (changed.has('coloring')) this.surface.setColors(coloring.ofAll(state.coloring));
      if (changed.has('deviations')) {
        model.move(state.deviations);
        this.surface.shapeChanged();
      }
      if (changed.has('coloring') || changed.has('deviations')) this.table.redraw();
    });
  }

  turnTo(rotation: Quaternion): void {
    this.table.turnTo(rotation);
  }

  reset(): void {
    this.table.reset();
  }

  /** The mean, and how far the first mode takes most shapes: the others move less. */
  private extremes(): Float32Array[] {
    const all = [0, 2, -2].map((deviation) => {
      this.model.move([deviation]);
      return this.model.shape.position.slice();
    });
    this.model.move([]);
    return all;
  }
}

/** A slider for each mode, what else to do with them, and where the selected shape lies. */
export function modeSliders(model: Model, store: GroupStore): HTMLElement {
  const box = h('div', { class: 'modes' });
  const set = (mode: number, value: number) => {
    const deviations = model.entry.modes.map((_, k) => store.state.deviations[k] ?? 0);
    deviations[mode] = value;
    store.set({ deviations });
  };
  const sliders = model.entry.modes.map(({ share }, k) =>
    sliderOf({
      id: `mode${k}`,
      label: `Mode ${k + 1}: ${percent(share)}`,
      min: -REACH,
      max: REACH,
      step: 0.1,
      describe: (value) => `${deviation(value)} sd`,
      change: (value) => set(k, value),
    }),
  );
  const show = () => sliders.forEach((slider, k) => slider.show(store.state.deviations[k] ?? 0));
  store.listen((_, changed) => changed.has('deviations') && show());
  show();
  const toMean = () => store.set({ deviations: [] });
  const toSelected = () => store.set({ deviations: model.scores(store.state.selected, REACH) });
  box.append(
    ...sliders.map(({ element }) => element),
    h(
      'div',
      { class: 'row' },
      h('button', { type: 'button', id: 'to-mean', click: toMean }, 'Mean shape'),
      h('button', { type: 'button', id: 'to-selected', click: toSelected }, 'Like the selected'),
    ),
  );
  return box;
}
