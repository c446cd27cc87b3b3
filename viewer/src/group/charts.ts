import { Chart } from '../ui/chart';
import { h } from '../ui/dom';
import { number, percent } from '../ui/format';
import type { Quality } from './manifest';

interface Curve {
  title: string;
  label: string;
  /** How to read it. */
  help: string;
  values: (number | null)[];
  format: (value: number) => string;
  high?: number;
}

const curves = ({ compactness, generalisation, specificity }: Quality): Curve[] => [
  {
    title: 'Compactness',
    label: 'share of the variance',
    help: 'Variance that the first modes explain. The sooner it is high, the better shapes correspond.',
    values: compactness,
    format: percent,
    high: 1,
  },
  {
    title: 'Generalisation',
    label: 'error',
    help: 'Distance of a shape that was left out from what a model of the others makes of it. Low is good.',
    values: generalisation,
    format: number,
  },
  {
    title: 'Specificity',
    label: 'distance',
    help: 'Distance of random shapes of the model from the nearest real one. Low is good.',
    values: specificity,
    format: number,
  },
];

/** More dots hide the line. */
const MOST_DOTS = 25;

function panel({ title, label, help, values, format, high }: Curve): HTMLElement | null {
  const points = values.flatMap((value, k): [number, number][] =>
    value === null ? [] : [[k + 1, value]],
  );
  if (points.length === 0) return null;
  const top = high ?? (Math.max(...points.map(([, value]) => value)) * 1.1 || 1);
  const chart = new Chart(
    `${title} by number of modes`,
    { label: 'modes', low: 1, high: Math.max(2, values.length), whole: true },
    { label, low: 0, high: top, format },
  );
  chart.line(points);
  if (points.length <= MOST_DOTS)
    for (const [modes, value] of points)
      chart.dot(modes, value, `${modes} modes: ${format(value)}`);
  return h('section', { class: 'panel' }, h('h2', {}, title), chart.element, h('small', {}, help));
}

/** What tells whether the points correspond well. */
export function qualityCharts(quality: Quality): HTMLElement {
  const charts = h('div', { class: 'plots' });
  for (const curve of curves(quality)) {
    const element = panel(curve);
    if (element) charts.append(element);
  }
  return charts;
}
