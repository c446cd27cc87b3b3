import type { Grade } from '../ui/grades';
import type { GroupManifest, MemberEntry } from './manifest';
import type { Sort } from './state';

const BADNESS: Record<Grade, number> = { poor: 2, doubtful: 1, good: 0 };

type Compare = (a: MemberEntry, b: MemberEntry) => number;

const worseFirst: Compare = (a, b) =>
  BADNESS[b.grade] - BADNESS[a.grade] || b.cycle_error - a.cycle_error;

const byName: Compare = (a, b) => a.name.localeCompare(b.name, 'en', { numeric: true });

/** The mode of a sort by scores. */
export const modeOf = (sort: Sort): number | null =>
  sort.startsWith('mode') ? Number(sort.slice('mode'.length)) : null;

/** The members in the order in which they are shown; equal ones stay as they came. */
export function orderOf({ members, model }: GroupManifest, sort: Sort): number[] {
  const order = members.map((_, k) => k);
  const mode = modeOf(sort);
  if (mode === null) {
    const compare = sort === 'name' ? byName : worseFirst;
    return order.sort((a, b) => compare(members[a]!, members[b]!));
  }
  const scores = model?.modes[mode]?.scores ?? [];
  return order.sort((a, b) => (scores[a] ?? 0) - (scores[b] ?? 0));
}

/** All ways to sort them, and what they are called. */
export function sorts({ model }: GroupManifest): { value: Sort; name: string }[] {
  const modes = (model?.modes ?? []).map((_, k) => ({
    value: `mode${k}` as const,
    name: `Score along mode ${k + 1}`,
  }));
  return [
    { value: 'quality', name: 'Quality, the worst first' },
    { value: 'name', name: 'Name' },
    ...modes,
  ];
}
