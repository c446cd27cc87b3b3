import type { Colors } from './color/coloring';
import type { Result } from './data/result';
import { Stage } from './scene/stage';
import type { PairStore, State } from './state';
import { Store } from './store';
import { controls, helpOf } from './ui/controls';
import { h } from './ui/dom';
import { fileName } from './ui/format';
import { Legend } from './ui/legend';
import { numbers } from './ui/numbers';
import { plots } from './ui/plots';
import { PointPanel } from './ui/point_panel';
import { remarks, warnings } from './ui/summary';
import { themeButton } from './ui/theme';
import { verdict } from './ui/verdict';
import { withWebgl } from './ui/webgl';

function initialStore(result: Result): PairStore {
  return new Store<State>({
    coloring: 'map',
    map: 0,
    level: Math.max(0, result.numLevels - 1),
    layout: 'pair',
    linked: true,
    morph: 0,
    lines: 0,
    worstIso: false,
    worstTruth: false,
    hovered: null,
    selected: null,
  });
}

function remarkList(result: Result, store: PairStore): HTMLElement {
  const list = h('ul', { class: 'remarks' });
  const show = ({ map }: Readonly<State>) =>
    list.replaceChildren(
      ...remarks(result, map).map(({ kind, text }) => h('li', { class: kind }, text)),
    );
  store.listen((state, changed) => {
    if (changed.has('map')) show(state);
  });
  show(store.state);
  return list;
}

function header(result: Result, store: PairStore, theme: HTMLElement): HTMLElement {
  const { report } = result.manifest;
  const names = `${fileName(report.source.file)} → ${fileName(report.target.file)}`;
  document.title = `${names} – isomatch`;
  return h(
    'header',
    {},
    h('div', { class: 'title' }, h('h1', {}, names), theme),
    verdict(result, store),
    remarkList(result, store),
  );
}

function meshWarnings(result: Result): HTMLElement | null {
  const unusual = warnings(result);
  if (unusual.length === 0) return null;
  const items = h('ul');
  for (const text of unusual) items.append(h('li', {}, text));
  return h('div', { class: 'warnings' }, h('b', {}, 'About the meshes'), items);
}

/** The names of the sides over the canvas. */
function sideLabels(store: PairStore): HTMLElement {
  const source = h('span', {}, 'Source');
  const target = h('span', {}, 'Target');
  const labels = h('div', { class: 'sides' }, source, target);
  const show = () => {
    const overlay = store.state.layout === 'overlay';
    labels.classList.toggle('overlaid', overlay);
    source.textContent = overlay ? 'Source in colour, target grey' : 'Source';
    target.hidden = overlay;
  };
  store.listen(show);
  show();
  return labels;
}

/** Builds the page; the first picture is drawn when this returns. */
export function showPage(root: HTMLElement, result: Result): void {
  const store = initialStore(result);
  const canvasBox = h('div', {
    class: 'canvas',
    id: 'stage',
    tabindex: 0,
    role: 'application',
    'aria-label': 'Source and target in 3D; arrow keys turn, plus and minus zoom, 0 resets',
  });
  const legend = new Legend();
  const point = new PointPanel();
  let stage: Stage | null = null;
  const theme = themeButton(() => stage?.redraw());
  const view = h('div', { class: 'view' }, canvasBox, sideLabels(store));
  root.replaceChildren(
    header(result, store, theme),
    h(
      'main',
      {},
      h('div', { class: 'left' }, view, point.element, legend.element, meshWarnings(result)),
      controls(result, store, () => stage?.resetViews()),
    ),
  );
  stage = withWebgl(canvasBox, () => new Stage(canvasBox, result, store));
  if (stage) {
    const showLegend = (colors: Colors | null) =>
      legend.show(helpOf(store.state.coloring), colors?.range ?? null);
    stage.onColors = showLegend;
    showLegend(stage.colors);
    point.show(result, store.state);
    store.listen((state) => point.show(result, state));
  }
  // What is below the picture can wait until it is seen.
  requestAnimationFrame(() =>
    setTimeout(() => {
      root.append(plots(result, store), numbers(result));
      document.documentElement.dataset.complete = 'true';
    }),
  );
}
