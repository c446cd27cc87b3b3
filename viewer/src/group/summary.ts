import { statistics } from '../data/statistics';
import { number } from '../ui/format';
import type { Grade } from '../ui/grades';
import type { GroupManifest, Use } from './manifest';

/** How many shapes have each grade. */
export function countGrades({ members }: GroupManifest): Record<Grade, number> {
  const counts = { good: 0, doubtful: 0, poor: 0 };
  for (const { grade } of members) ++counts[grade];
  return counts;
}

function countUses({ pairs }: GroupManifest): Record<Use, number> {
  const counts = { agrees: 0, 'runner-up': 0, composed: 0 };
  for (const { use } of pairs) ++counts[use];
  return counts;
}

/** What is to be known of all shapes, a sentence each. */
export function remarksOf(manifest: GroupManifest): string[] {
  const { members, pairs, template } = manifest;
  const uses = countUses(manifest);
  const remarks = [
    `${number(members.length)} shapes, followed from ${members[template.member]!.name}`,
  ];
  if (pairs.length > 0) {
    const { median, max } = statistics(pairs.map((pair) => pair.cycle_error));
    remarks.push(
      `${number(pairs.length)} pairs: ${number(uses.agrees)} agree, ${number(uses['runner-up'])} took their runner-up, ${number(uses.composed)} composed of others`,
      `Cycle error of a pair: median ${number(median)}, worst ${number(max)} of √area`,
    );
  }
  if (template.simplified)
    remarks.push(
      `Shown with ${number(template.vertices)} of the ${number(template.vertices_given)} points`,
    );
  return remarks;
}
