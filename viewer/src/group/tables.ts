import { h } from '../ui/dom';
import { number } from '../ui/format';
import type { Collection } from './collection';
import type { GroupManifest } from './manifest';
import { orderOf } from './order';

function table(head: string[], rows: string[][]): HTMLElement {
  const row = (tag: 'th' | 'td', cells: string[]) =>
    h('tr', {}, ...cells.map((cell) => h(tag, {}, cell)));
  const body = h('tbody', {}, ...rows.map((cells) => row('td', cells)));
  return h(
    'div',
    { class: 'scroll' },
    h('table', { class: 'data' }, h('thead', {}, row('th', head)), body),
  );
}

function shapeTable(manifest: GroupManifest): HTMLElement {
  const rows = orderOf(manifest, 'quality').map((k) => {
    const { name, grade, cycle_error, reasons } = manifest.members[k]!;
    return [name, grade, number(cycle_error), reasons.join('; ')];
  });
  return table(['shape', 'grade', 'cycle error', 'reasons'], rows);
}

function pairTable({ members, pairs }: GroupManifest): HTMLElement {
  const rows = [...pairs]
    .sort((a, b) => b.cycle_error - a.cycle_error)
    .map(({ source, target, cost, cycle_error, use }) => [
      members[source]!.name,
      members[target]!.name,
      number(cost),
      number(cycle_error),
      use,
    ]);
  return table(['source', 'target', 'cost', 'cycle error', 'use'], rows);
}

/** Everything that is small, to be read without pictures. */
export function tables({ manifest }: Collection): HTMLElement {
  const folded = (title: string, content: HTMLElement) =>
    h('details', {}, h('summary', {}, title), content);
  return h(
    'section',
    { class: 'panel' },
    h('h2', {}, 'Numbers'),
    folded(`All ${number(manifest.members.length)} shapes, the worst first`, shapeTable(manifest)),
    folded(`All ${number(manifest.pairs.length)} pairs, the worst first`, pairTable(manifest)),
  );
}
