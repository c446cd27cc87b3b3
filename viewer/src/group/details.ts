import { statistics } from '../data/statistics';
import { h } from '../ui/dom';
import { deviation, number, percent } from '../ui/format';
import { BADGES, sentence } from '../ui/grades';
import type { Collection } from './collection';
import type { PairEntry } from './manifest';
import { orderOf } from './order';
import type { GroupStore } from './state';

/** The pairs of a shape, the worst first. */
export const pairsOf = (pairs: PairEntry[], member: number): PairEntry[] =>
  pairs
    .filter(({ source, target }) => source === member || target === member)
    .sort((a, b) => b.cycle_error - a.cycle_error);

/** The next shape in the order of the wall, or the one before it. */
export function neighbourOf(order: number[], member: number, step: number): number {
  const place = order.indexOf(member) + step;
  return order[(place + order.length) % order.length]!;
}

function numbersOf(collection: Collection, member: number): [string, string][] {
  const { manifest } = collection;
  const entry = manifest.members[member]!;
  const rows: [string, string][] = [['Cycle error', `${number(entry.cycle_error)} of √area`]];
  if (collection.knowsSpread) {
    const { mean, p95, max } = statistics(collection.spread(member));
    rows.push(['Spread', `mean ${number(mean)}, 95 % below ${number(p95)}, worst ${number(max)}`]);
  }
  if (entry.missing)
    rows.push(['Missing', `${percent(entry.missing / collection.numPoints)} of the points`]);
  const scores = manifest.model?.modes.map(({ scores: all }) => deviation(all[member] ?? 0));
  if (scores?.length) rows.push(['Scores', `${scores.join(', ')} sd`]);
  return rows;
}

function pairList(collection: Collection, store: GroupStore, member: number): HTMLElement {
  const { members, pairs } = collection.manifest;
  const list = h('ul', { class: 'pairs' });
  for (const { source, target, cycle_error, use } of pairsOf(pairs, member)) {
    const other = source === member ? target : source;
    list.append(
      h(
        'li',
        { class: use },
        h(
          'button',
          { type: 'button', click: () => store.set({ selected: other }) },
          members[other]!.name,
        ),
        h('span', {}, number(cycle_error)),
        h('span', {}, use),
      ),
    );
  }
  return list;
}

/** What is known of a shape. */
function described(collection: Collection, store: GroupStore, member: number): HTMLElement {
  const entry = collection.manifest.members[member]!;
  const { icon, word } = BADGES[entry.grade];
  const reasons = h('ul', { class: 'reasons' });
  for (const reason of entry.reasons) reasons.append(h('li', {}, sentence(reason)));
  const table = h('table', { class: 'numbers' });
  for (const [name, value] of numbersOf(collection, member))
    table.append(h('tr', {}, h('th', { scope: 'row' }, name), h('td', {}, value)));
  return h(
    'div',
    { class: 'described' },
    h(
      'div',
      {},
      h(
        'p',
        { class: `grade-line ${entry.grade}` },
        h('span', { class: 'badge', 'aria-hidden': 'true' }, icon),
        h('b', {}, word),
      ),
      reasons,
      table,
    ),
    h('div', {}, h('h3', {}, 'Its pairs: cycle error, use'), pairList(collection, store, member)),
  );
}

/** What is known of the selected shape, and buttons that select the next one. */
export function details(collection: Collection, store: GroupStore): HTMLElement {
  const name = h('h2', { 'aria-live': 'polite' });
  const content = h('div');
  const step = (by: number) => () => {
    const { selected, sort } = store.state;
    store.set({ selected: neighbourOf(orderOf(collection.manifest, sort), selected, by) });
  };
  const arrow = (id: string, label: string, text: string, by: number) =>
    h('button', { type: 'button', id, 'aria-label': label, click: step(by) }, text);
  const show = () => {
    const { selected } = store.state;
    name.textContent = collection.manifest.members[selected]!.name;
    content.replaceChildren(described(collection, store, selected));
  };
  store.listen((_, changed) => changed.has('selected') && show());
  show();
  const arrows = h(
    'span',
    { class: 'arrows' },
    arrow('previous', 'Previous shape', '←', -1),
    arrow('next', 'Next shape', '→', 1),
  );
  return h(
    'section',
    { class: 'panel details', id: 'details' },
    h('div', { class: 'row' }, name, arrows),
    content,
  );
}
