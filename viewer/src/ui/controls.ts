import type { Result } from '../data/result';
import { statistics } from '../data/statistics';
import type { Coloring, Layout, PairStore, State } from '../state';
import { h } from './dom';
import { number } from './format';
import { choiceOf, sliderOf } from './inputs';
import { playButton } from './player';

interface ColoringChoice {
  value: Coloring;
  name: string;
  /** How to read it. */
  help: string;
}

const COLORINGS: ColoringChoice[] = [
  {
    value: 'map',
    name: 'Map',
    help: 'Same colour, same place: each point of the source has the colour of the target point it is matched to. A tear shows as a sudden change of colour on the source; a flip as sides, front and back, or head and tail with exchanged colours. Grey has no match.',
  },
  {
    value: 'checker',
    name: 'Checkerboard',
    help: 'A checkerboard projected onto the target and carried to the source by the map. Squares that are bent, stretched or broken on the source only are errors of the map or real differences of the shapes.',
  },
  {
    value: 'confidence',
    name: 'Confidence',
    help: 'How sure each point is: about the probability that its match is within .05 of the truth, in the unit of the pair. Bright is sure; grey has no match. What has a near twin may be sure and wrong all the same.',
  },
  {
    value: 'd_iso',
    name: 'Distortion',
    help: 'Isometric distortion d_iso of each vertex: how much its distances along the surface to other matched points differ between the shapes, over the largest distance. Bright is bad.',
  },
  {
    value: 'error',
    name: 'True error',
    help: 'Distance along the target from where a vertex lands to where the ground truth says, over √area. Bright is bad.',
  },
  {
    value: 'curvature',
    name: 'Curvature',
    help: 'Mean curvature of each shape on its own, times √area: orange bulges out, blue dents in. Matching parts should look alike.',
  },
  {
    value: 'patches',
    name: 'Patches',
    help: 'Base vertices (dots) of this level and the patch around each, in the colour of the base that it is matched to.',
  },
];

const available = (result: Result, choice: Coloring): boolean =>
  (choice !== 'confidence' || result.map(0).confidence !== null) &&
  (choice !== 'error' || result.map(0).error !== null) &&
  (choice !== 'patches' || result.numLevels > 0);

export const helpOf = (coloring: Coloring): string =>
  COLORINGS.find(({ value }) => value === coloring)!.help;

function coloringChoice(result: Result, store: PairStore): HTMLElement {
  const choices = COLORINGS.filter((choice) => available(result, choice.value));
  const choose = (coloring: Coloring) => store.set({ coloring });
  const { element, show } = choiceOf('coloring', 'Colours', choices, choose);
  store.listen(({ coloring }) => show(coloring));
  show(store.state.coloring);
  return element;
}

type NumberKey = 'map' | 'level' | 'morph' | 'lines';

interface StateSlider {
  key: NumberKey;
  label: string;
  max: number;
  step?: number;
  describe: (value: number) => string;
  change?: (value: number) => Partial<State>;
}

function slider(store: PairStore, options: StateSlider): HTMLElement {
  const { key, label, max, step, describe, change } = options;
  const set = (value: number) => store.set(change ? change(value) : { [key]: value });
  const { element, show } = sliderOf({ id: key, label, max, step, describe, change: set });
  store.listen((state) => show(state[key]));
  show(store.state[key]);
  return element;
}

function toggle(
  store: PairStore,
  key: 'linked' | 'worstIso' | 'worstTruth',
  ...label: (Node | string)[]
): HTMLElement {
  const input = h('input', { type: 'checkbox', id: key });
  input.addEventListener('change', () => store.set({ [key]: input.checked }));
  store.listen((state) => (input.checked = state[key]));
  input.checked = store.state[key];
  return h('label', { class: 'toggle' }, input, h('span', {}, ...label));
}

/** Levels of the paper's method; coarse ones are looked at in patches. */
function levelSlider(result: Result, store: PairStore): HTMLElement {
  const last = result.numLevels - 1;
  return slider(store, {
    key: 'level',
    label: 'Level k, from coarse to fine',
    max: last,
    describe: (k) => {
      const level = result.level(k);
      const matches = `${number(level.source.length)} matches`;
      return `${k} of ${last}: ${matches}, D_iso ${number(statistics(level.dIso).mean)}`;
    },
    change: (level) => {
      const { coloring, lines } = store.state;
      if (level < last && coloring === 'map')
        return { level, coloring: 'patches', lines: lines || 100 };
      if (level === last && coloring === 'patches') return { level, coloring: 'map' };
      return { level };
    },
  });
}

function mapSlider(result: Result, store: PairStore): HTMLElement {
  const { map, alternatives = [] } = result.manifest.report;
  return slider(store, {
    key: 'map',
    label: 'Map: the best one and its alternatives',
    max: result.numMaps - 1,
    describe: (k) => {
      const entry = k === 0 ? map : alternatives[k - 1];
      const energy = entry ? `, energy ${number(entry.energy)}` : '';
      return (k === 0 ? 'the best' : `alternative ${k}`) + energy;
    },
  });
}

const LAYOUTS = [
  { value: 'pair', name: 'Side by side' },
  { value: 'overlay', name: 'Overlay' },
] as const;

function layoutChoice(store: PairStore): HTMLElement {
  const choose = (layout: Layout) => store.set({ layout });
  const { element, show } = choiceOf('layout', 'View', LAYOUTS, choose);
  store.listen(({ layout }) => show(layout));
  show(store.state.layout);
  return element;
}

function morphControl(result: Result, store: PairStore): HTMLElement {
  const bent = slider(store, {
    key: 'morph',
    label: 'Bend the source into the target’s pose',
    max: 1,
    step: 0.01,
    describe: (share) => `${Math.round(100 * share)} %`,
  });
  bent.append(playButton(store));
  if (!result.map(0).isRegistered)
    bent.append(h('small', {}, 'This method does not register: vertices move to their matches.'));
  return bent;
}

function lineControls(result: Result, store: PairStore): HTMLElement {
  const box = h('fieldset', {}, h('legend', {}, 'Match lines'));
  box.append(
    slider(store, {
      key: 'lines',
      label: 'Samples',
      max: 300,
      step: 10,
      describe: (count) => (count === 0 ? 'none' : String(count)),
    }),
    toggle(store, 'worstIso', h('b', { class: 'red' }, '━ '), 'worst distortion (d_iso)'),
  );
  if (result.map(0).error)
    box.append(
      toggle(store, 'worstTruth', h('b', { class: 'green' }, '╍ '), 'worst ground-truth error'),
    );
  return box;
}

export function controls(result: Result, store: PairStore, resetViews: () => void): HTMLElement {
  const cameras = h(
    'div',
    { class: 'row' },
    toggle(store, 'linked', 'Turn both together'),
    h('button', { type: 'button', id: 'reset', click: resetViews }, 'Reset view'),
  );
  return h(
    'form',
    { class: 'controls', 'aria-label': 'What is shown', submit: (e: Event) => e.preventDefault() },
    coloringChoice(result, store),
    result.numLevels > 1 && levelSlider(result, store),
    result.numMaps > 1 && mapSlider(result, store),
    lineControls(result, store),
    layoutChoice(store),
    morphControl(result, store),
    cameras,
  );
}
