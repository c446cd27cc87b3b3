import type { Arrays } from '../data/arrays';
import { decodePoints } from '../data/decode';
import { place, placingOf, rotate } from '../data/placing';
import type { Shape } from '../data/shape';
import { vertexNormals } from '../geometry/normals';
import type { ModelEntry } from './manifest';

/** `mean` moved so many standard deviations along each mode. */
export function shapeAt(
  mean: Float32Array,
  modes: Float32Array[],
  deviations: readonly number[],
): Float32Array {
  const moved = mean.slice();
  modes.forEach((mode, k) => {
    const share = deviations[k] ?? 0;
    if (share === 0) return;
    for (let i = 0; i < moved.length; ++i) moved[i]! += share * mode[i]!;
  });
  return moved;
}

/** The mean shape and what its principal modes make of it. */
export class Model {
  /** As it was moved last. */
  readonly shape: Shape;
  private readonly mean: Float32Array;
  /** What a standard deviation adds to each coordinate. */
  private readonly modes: Float32Array[];

  constructor(
    readonly entry: ModelEntry,
    arrays: Arrays,
    template: Shape,
  ) {
    const points = decodePoints(arrays('model/mean'), entry);
    const placing = placingOf(points, entry.view, entry.area);
    this.mean = place(placing, points);
    this.modes = entry.modes.map((mode, k) => {
      const moves = decodePoints(arrays(`model/modes/${k}`), mode);
      return rotate(placing.rotation, moves).map((x) => x * placing.scale);
    });
    this.shape = {
      ...template,
      position: this.mean.slice(),
      normal: vertexNormals(this.mean, template.faces),
    };
  }

  get numModes(): number {
    return this.modes.length;
  }

  move(deviations: readonly number[]): void {
    const { position, normal, faces } = this.shape;
    position.set(shapeAt(this.mean, this.modes, deviations));
    normal.set(vertexNormals(position, faces));
  }

  /** A shape's place along the modes, as far as sliders reach. */
  scores(member: number, reach: number): number[] {
    return this.entry.modes.map(({ scores }) =>
      Math.min(reach, Math.max(-reach, scores[member] ?? 0)),
    );
  }
}
