import { fill, openRange, paint, type Range } from '../color/paint';
import { GREY } from '../color/scales';
import type { Collection } from './collection';
import type { GroupColoring } from './state';

export const COLORINGS = [
  {
    value: 'map',
    name: 'Map',
    help: 'Same colour, same place: each point has the colour of its place on the template. A tear shows as a sudden change of colour; a flip as sides, front and back, or head and tail with exchanged colours.',
  },
  {
    value: 'spread',
    name: 'Spread',
    help: 'How far apart the pairs of a shape say that a point lies, over √area; on the template and the mean, of all shapes. Bright is bad.',
  },
] as const;

export const helpOf = (coloring: GroupColoring): string =>
  COLORINGS.find(({ value }) => value === coloring)!.help;

/** The colours of all shapes, each computed once. */
export class Coloring {
  /** The same for all shapes, so that they can be compared. */
  private known: Range | null = null;
  private readonly bySpread = new Map<number, Float32Array>();
  private average: Float32Array | null = null;

  constructor(private readonly collection: Collection) {}

  range(coloring: GroupColoring): Range | null {
    return coloring === 'map' ? null : this.spreadRange();
  }

  ofMember(member: number, coloring: GroupColoring): Float32Array {
    if (coloring === 'map') return this.collection.mapColors;
    let colors = this.bySpread.get(member);
    if (!colors) {
      colors = paint(this.collection.spread(member), this.spreadRange());
      this.bySpread.set(member, colors);
    }
    return colors;
  }

  /** Of the template beside a member, grey where that lacks points. */
  ofTemplate(member: number, coloring: GroupColoring): Float32Array {
    const { mapColors, manifest, numPoints } = this.collection;
    if (coloring === 'spread') return this.ofAll('spread');
    if (!manifest.members[member]!.missing) return mapColors;
    return fill(numPoints, (p) =>
      this.collection.isThere(member, p)
        ? [mapColors[3 * p]!, mapColors[3 * p + 1]!, mapColors[3 * p + 2]!]
        : GREY,
    );
  }

  ofAll(coloring: GroupColoring): Float32Array {
    if (coloring === 'map') return this.collection.mapColors;
    this.average ??= paint(this.collection.meanSpread(), this.spreadRange());
    return this.average;
  }

  private spreadRange(): Range {
    if (!this.known) {
      const { manifest } = this.collection;
      const all = manifest.members.flatMap((_, k) => Array.from(this.collection.spread(k)));
      this.known = openRange(all);
    }
    return this.known;
  }
}
