import { h } from '../ui/dom';
import { number } from '../ui/format';
import { BADGES, sentence } from '../ui/grades';
import type { Collection } from './collection';
import type { MemberEntry } from './manifest';
import { orderOf, sorts } from './order';
import type { GroupStore, Sort } from './state';
import type { Thumbnails } from './thumbnails';

function card(entry: MemberEntry, isTemplate: boolean, select: () => void): HTMLElement {
  const { icon, word } = BADGES[entry.grade];
  const reasons = entry.reasons.map(sentence).join(' ');
  return h(
    'button',
    { type: 'button', class: `card ${entry.grade}`, click: select, title: reasons || word },
    h('canvas', { 'aria-hidden': 'true' }),
    h(
      'span',
      { class: 'card-name' },
      h('span', { class: 'badge', role: 'img', 'aria-label': word }, icon),
      h('b', {}, entry.name),
    ),
    h(
      'small',
      {},
      h('span', {}, isTemplate ? 'template' : `cycle error ${number(entry.cycle_error)}`),
      h('span', { class: 'reason' }, entry.reasons[0] ?? ''),
    ),
  );
}

function sortMenu(collection: Collection, store: GroupStore): HTMLElement {
  const menu = h('select', { id: 'sort' });
  for (const { value, name } of sorts(collection.manifest))
    menu.append(h('option', { value }, name));
  menu.value = store.state.sort;
  menu.addEventListener('change', () => store.set({ sort: menu.value as Sort }));
  return h('label', { class: 'sort' }, 'Sort by ', menu);
}

/** All shapes, as buttons. */
export function wall(
  collection: Collection,
  store: GroupStore,
  thumbnails: Thumbnails | null,
): HTMLElement {
  const { members, template } = collection.manifest;
  const list = h('div', { class: 'cards', id: 'wall' });
  const cards = members.map((entry, k) =>
    card(entry, k === template.member, () => store.set({ selected: k })),
  );
  cards.forEach((element, k) => {
    const canvas = element.querySelector('canvas')!;
    if (thumbnails) thumbnails.add(k, canvas);
    else canvas.remove();
  });
  const arrange = () =>
    list.replaceChildren(...orderOf(collection.manifest, store.state.sort).map((k) => cards[k]!));
  const mark = () =>
    cards.forEach((element, k) =>
      element.setAttribute('aria-pressed', String(k === store.state.selected)),
    );
  store.listen(({ selected }, changed) => {
    if (changed.has('sort')) arrange();
    if (!changed.has('selected')) return;
    mark();
    cards[selected]!.scrollIntoView({ block: 'nearest' });
  });
  arrange();
  mark();
  return h(
    'section',
    { class: 'panel wall', 'aria-label': 'All shapes' },
    h('div', { class: 'row' }, h('h2', {}, 'Shapes'), sortMenu(collection, store)),
    list,
  );
}
