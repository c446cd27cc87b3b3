import { number } from '../ui/format';
import type { Collection } from './collection';
import type { GroupState } from './state';

/** The point that is pointed at, or how to point at one. */
export function describePoint(
  collection: Collection,
  averages: Float32Array | null,
  { hovered, kept, selected }: GroupState,
  hint: string,
): string {
  const point = hovered ?? kept;
  if (point === null) return hint;
  const parts = [`template vertex ${collection.template.numbers[point]}`];
  const { name } = collection.manifest.members[selected]!;
  if (!collection.isThere(selected, point)) parts.push(`missing on ${name}`);
  else if (averages)
    parts.push(
      `spread ${number(collection.spread(selected)[point]!)} of √area on ${name}`,
      `${number(averages[point]!)} over all shapes`,
    );
  return parts.join('  ·  ');
}
