import { h } from '../ui/dom';
import { deviation, number } from '../ui/format';
import { BADGES, sentence } from '../ui/grades';
import type { Collection } from './collection';
import type { GroupManifest, MemberEntry } from './manifest';
import { modeOf, orderOf, sorts } from './order';
import type { GroupStore, Sort } from './state';
import type { Thumbnails } from './thumbnails';

/** What a shape is sorted by, as far as it is a number. */
function valueOf({ members, model }: GroupManifest, member: number, sort: Sort): string {
  const mode = modeOf(sort);
  const score = mode === null ? undefined : model?.modes[mode]?.scores[member];
  if (score !== undefined) return `score ${deviation(score)} sd`;
  return `cycle error ${number(members[member]!.cycle_error)}`;
}

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
      h('span', { class: 'value' }),
      h('span', { class: 'reason' }, isTemplate ? 'the template' : (entry.reasons[0] ?? '')),
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
  const arrange = () => {
    const { sort } = store.state;
    cards.forEach((element, k) => {
      element.querySelector('.value')!.textContent = valueOf(collection.manifest, k, sort);
    });
    list.replaceChildren(...orderOf(collection.manifest, sort).map((k) => cards[k]!));
  };
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
