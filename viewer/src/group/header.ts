import { h } from '../ui/dom';
import { number } from '../ui/format';
import { BADGES, type Grade } from '../ui/grades';
import type { Collection } from './collection';
import { countGrades, remarksOf } from './summary';

function gradeCounts({ manifest }: Collection): HTMLElement {
  const counts = countGrades(manifest);
  const box = h('p', { class: 'grade-counts' });
  for (const grade of ['poor', 'doubtful', 'good'] as Grade[]) {
    const { icon } = BADGES[grade];
    box.append(
      h(
        'span',
        { class: `grade-line ${grade}` },
        h('span', { class: 'badge', 'aria-hidden': 'true' }, icon),
        h('b', {}, `${number(counts[grade])} ${grade}`),
      ),
    );
  }
  return box;
}

/** What the page shows, and how it went. */
export function header(collection: Collection, theme: HTMLElement): HTMLElement {
  const { manifest } = collection;
  document.title = `${manifest.title} – isomatch`;
  const remarks = h('ul', { class: 'remarks' });
  for (const text of remarksOf(manifest)) remarks.append(h('li', {}, text));
  return h(
    'header',
    {},
    h('div', { class: 'title' }, h('h1', {}, manifest.title), gradeCounts(collection), theme),
    remarks,
  );
}
