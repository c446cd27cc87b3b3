import { commandToRepeat } from '../ui/command';
import { h } from '../ui/dom';
import { quote } from '../ui/format';
import { choiceOf } from '../ui/inputs';
import { Legend } from '../ui/legend';
import { hasTouch, hint } from '../ui/point_panel';
import { themeButton } from '../ui/theme';
import { withWebgl } from '../ui/webgl';
import { Store } from '../store';
import { qualityCharts } from './charts';
import type { Collection } from './collection';
import { Coloring, COLORINGS, helpOf } from './coloring';
import { details } from './details';
import { header } from './header';
import type { Model } from './model';
import { modeSliders } from './model_panel';
import { orderOf } from './order';
import { pairGraph } from './pair_graph';
import { describePoint } from './point_text';
import { type Boxes, Scenes } from './scenes';
import type { GroupState, GroupStore } from './state';
import { tables } from './tables';
import { wall } from './wall';

/** The worst shape is looked at first, but not the template itself. */
function initialStore({ manifest }: Collection): GroupStore {
  const order = orderOf(manifest, 'quality');
  return new Store<GroupState>({
    coloring: 'map',
    sort: 'quality',
    selected: order.find((k) => k !== manifest.template.member) ?? 0,
    hovered: null,
    kept: null,
    deviations: [],
  });
}

const canvasBox = (id: string, label: string): HTMLElement =>
  h('div', {
    class: 'canvas',
    id,
    tabindex: 0,
    role: 'application',
    'aria-label': `${label} in 3D; arrow keys turn, plus and minus zoom, 0 resets`,
  });

/** The names over the canvas. */
function sideLabels({ manifest }: Collection, store: GroupStore): HTMLElement {
  const template = `${manifest.members[manifest.template.member]!.name}, the template`;
  const shape = h('span', {});
  const show = () => (shape.textContent = manifest.members[store.state.selected]!.name);
  store.listen((_, changed) => changed.has('selected') && show());
  show();
  return h('div', { class: 'sides' }, h('span', {}, template), shape);
}

function coloringChoice(collection: Collection, store: GroupStore): HTMLElement | null {
  if (!collection.knowsSpread) return null;
  const choice = choiceOf('coloring', 'Colours', COLORINGS, (coloring) => store.set({ coloring }));
  store.listen(({ coloring }) => choice.show(coloring));
  choice.show(store.state.coloring);
  return choice.element;
}

function legendOf(store: GroupStore, coloring: Coloring): HTMLElement {
  const legend = new Legend();
  const show = () =>
    legend.show(helpOf(store.state.coloring), coloring.range(store.state.coloring));
  store.listen((_, changed) => changed.has('coloring') && show());
  show();
  return legend.element;
}

function pointLine(collection: Collection, store: GroupStore): HTMLElement {
  const line = h('p', { class: 'point', id: 'point', role: 'status' });
  let averages: Float32Array | null = null;
  const show = () => {
    const { hovered, kept } = store.state;
    const none = hovered === null && kept === null;
    if (!none && collection.knowsSpread) averages ??= collection.meanSpread();
    line.textContent = describePoint(collection, averages, store.state, hint(hasTouch()));
    line.classList.toggle('hint', none);
  };
  store.listen(show);
  show();
  return line;
}

function beside(collection: Collection, store: GroupStore, parts: Parts): HTMLElement {
  const { boxes, legend, reset } = parts;
  const view = h('div', { class: 'view' }, boxes.detail, sideLabels(collection, store));
  return h(
    'div',
    { class: 'beside' },
    view,
    pointLine(collection, store),
    h('div', { class: 'row colours' }, coloringChoice(collection, store), reset),
    legend,
    details(collection, store),
  );
}

function modelPanel(model: Model, store: GroupStore, box: HTMLElement): HTMLElement {
  return h(
    'section',
    { class: 'panel model' },
    h('h2', {}, 'Mean shape and principal modes'),
    h('div', { class: 'view' }, box),
    h('small', {}, 'Share of the variance; standard deviations from the mean'),
    modeSliders(model, store),
  );
}

interface Parts {
  boxes: Boxes;
  legend: HTMLElement;
  reset: HTMLElement;
}

/** Builds the page of a collection. */
export function showGroup(root: HTMLElement, collection: Collection): void {
  const store = initialStore(collection);
  const coloring = new Coloring(collection);
  const boxes = {
    detail: canvasBox('stage', 'The template and the selected shape'),
    mean: canvasBox('mean', 'The mean shape'),
  };
  const scenes = withWebgl(boxes.detail, () => new Scenes(boxes, collection, coloring, store));
  const theme = themeButton(() => scenes?.redraw());
  const reset = h(
    'button',
    { type: 'button', id: 'reset', click: () => scenes?.reset() },
    'Reset view',
  );
  const legend = legendOf(store, coloring);
  root.classList.add('group');
  root.classList.toggle('flat', !scenes);
  root.replaceChildren(
    header(collection, theme),
    h(
      'main',
      {},
      wall(collection, store, scenes?.thumbnails ?? null),
      beside(collection, store, { boxes, legend, reset }),
    ),
  );
  // What is below can wait until it is seen.
  requestAnimationFrame(() => setTimeout(() => appendRest(root, collection, store, boxes)));
}

function appendRest(
  root: HTMLElement,
  collection: Collection,
  store: GroupStore,
  boxes: Boxes,
): void {
  const { model, manifest } = collection;
  const row = h('div', { class: 'statistics' });
  if (model) row.append(modelPanel(model, store, boxes.mean));
  if (manifest.pairs.length > 0) row.append(pairGraph(collection, store));
  root.append(row);
  if (manifest.quality) root.append(qualityCharts(manifest.quality));
  const numbers = tables(collection);
  if (manifest.command.length > 0)
    numbers.append(...commandToRepeat(manifest.command.map(quote).join(' ')));
  root.append(numbers);
  document.documentElement.dataset.complete = 'true';
}
