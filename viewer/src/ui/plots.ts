import type { Result } from '../data/result';
import { histogram, quantile, sorted, statistics } from '../data/statistics';
import type { State, PairStore } from '../state';
import { Chart } from './chart';
import { h } from './dom';
import { number, percent, seconds } from './format';

/** A plot that shows the state; null if there is nothing to plot. */
type Plot = (state: Readonly<State>) => Element | null;

/** Figure 8 of the paper. */
function distortionByLevel(result: Result, store: PairStore): Plot {
  const means = Array.from(
    { length: result.numLevels },
    (_, k) => statistics(result.level(k).dIso).mean,
  );
  return ({ level }) => {
    const chart = new Chart(
      'Mean isometric distortion of each level',
      { label: 'level k', low: 0, high: Math.max(1, means.length - 1), whole: true },
      { label: 'D_iso', low: 0, high: Math.max(...means) * 1.1 || 1 },
    );
    chart.line(means.map((mean, k) => [k, mean]));
    means.forEach((mean, k) => {
      const dot = chart.dot(k, mean, `level ${k}: ${number(mean)}`, k === level);
      dot.addEventListener('click', () => store.set({ level: k }));
    });
    return chart.element;
  };
}

function hypotheses(result: Result): Plot {
  const all = result.manifest.report.hypotheses ?? [];
  return () => {
    if (all.length === 0) return null;
    const chart = new Chart(
      'Hypotheses: distortion against elastic energy',
      { label: 'distortion', low: 0, high: Math.max(...all.map((x) => x.distortion)) * 1.1 || 1 },
      {
        label: 'energy, coarse',
        low: 0,
        high: Math.max(...all.map((x) => x.coarse_energy)) * 1.1 || 1,
      },
    );
    // The best last, so that it lies on top.
    for (let k = all.length - 1; k >= 0; --k) {
      const { distortion, orientation, coarse_energy } = all[k]!;
      const text = `${k === 0 ? 'the best' : `number ${k + 1}`}: distortion ${number(distortion)}, orientation ${number(orientation)}, energy ${number(coarse_energy)}`;
      chart.dot(distortion, coarse_energy, text, k === 0);
    }
    return chart.element;
  };
}

const errorCurve: (result: Result) => Plot = (result) => (state) => {
  const { error } = result.map(state.map);
  if (!error) return null;
  const ascending = sorted(error);
  const high = Math.max(quantile(ascending, 0.99), 0.05);
  const chart = new Chart(
    'Share of vertices whose error is at most a value',
    { label: 'error / √area', low: 0, high },
    { label: 'share of vertices', low: 0, high: 1, format: percent },
  );
  const STEPS = 120;
  let below = 0;
  const points: [number, number][] = [];
  for (let i = 0; i <= STEPS; ++i) {
    const limit = (i / STEPS) * high;
    while (below < ascending.length && ascending[below]! <= limit) ++below;
    points.push([limit, below / ascending.length]);
  }
  chart.line(points);
  const { mean } = statistics(error);
  if (mean < high) chart.mark(mean, `mean ${number(mean)}`);
  return chart.element;
};

const distortionHistogram: (result: Result) => Plot = (result) => (state) => {
  const { dIso } = result.map(state.map);
  const ascending = sorted(dIso);
  const high = quantile(ascending, 0.995) || 1;
  const BINS = 40;
  const counts = histogram(dIso, high, BINS);
  const chart = new Chart(
    'Vertices by isometric distortion',
    { label: 'd_iso (the last bar: and more)', low: 0, high },
    { label: 'vertices', low: 0, high: Math.max(...counts) * 1.05 },
  );
  counts.forEach((count, i) => {
    const [from, to] = [(i / BINS) * high, ((i + 1) / BINS) * high];
    chart.bar(from, to, count, `${number(from)} to ${number(to)}: ${number(count)} vertices`);
  });
  const { mean } = statistics(dIso);
  chart.mark(mean, `D_iso ${number(mean)}`);
  return chart.element;
};

function stageTimes(result: Result): Plot {
  const times = Object.entries(result.manifest.report.seconds ?? {});
  return () => {
    if (times.length === 0) return null;
    const longest = Math.max(...times.map(([, time]) => time)) || 1;
    const list = h('ul', { class: 'times' });
    for (const [stage, time] of times) {
      const bar = h('i', { style: `width:${(100 * time) / longest}%` });
      list.append(h('li', {}, h('span', {}, stage), h('div', {}, bar), h('b', {}, seconds(time))));
    }
    return list;
  };
}

interface PlotEntry {
  title: string;
  plot: Plot;
  /** What it has to be drawn again for. */
  keys: (keyof State)[];
}

function entries(result: Result, store: PairStore): PlotEntry[] {
  const all: PlotEntry[] = [];
  if (result.map(0).error)
    all.push({ title: 'Ground-truth error', plot: errorCurve(result), keys: ['map'] });
  if (result.numLevels > 0)
    all.push({
      title: 'Distortion by level',
      plot: distortionByLevel(result, store),
      keys: ['level'],
    });
  all.push({ title: 'Distortion of vertices', plot: distortionHistogram(result), keys: ['map'] });
  if (result.manifest.report.hypotheses?.length)
    all.push({ title: 'Hypotheses that were judged', plot: hypotheses(result), keys: [] });
  all.push({ title: 'Time per stage', plot: stageTimes(result), keys: [] });
  return all;
}

export function plots(result: Result, store: PairStore): HTMLElement {
  const box = h('div', { class: 'plots' });
  for (const { title, plot, keys } of entries(result, store)) {
    const place = h('div');
    const show = () => place.replaceChildren(...[plot(store.state)].filter((x) => x !== null));
    show();
    store.listen((_, changed) => {
      if (keys.some((key) => changed.has(key))) show();
    });
    box.append(h('section', { class: 'panel' }, h('h2', {}, title), place));
  }
  return box;
}
