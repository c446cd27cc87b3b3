import type { ColorBox, Triple } from './manifest';

/** Takes points of a file to the viewer's coordinates. */
export interface Placing {
  rotation: number[];
  centre: Triple;
  scale: number;
}

export function rotate(rotation: number[], points: Float32Array): Float32Array {
  const rotated = new Float32Array(points.length);
  for (let i = 0; i < points.length; i += 3) {
    for (let k = 0; k < 3; ++k)
      rotated[i + k] =
        rotation[3 * k]! * points[i]! +
        rotation[3 * k + 1]! * points[i + 1]! +
        rotation[3 * k + 2]! * points[i + 2]!;
  }
  return rotated;
}

function middle(points: Float32Array): Triple {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; ++i) {
    low[i % 3] = Math.min(low[i % 3]!, points[i]!);
    high[i % 3] = Math.max(high[i % 3]!, points[i]!);
  }
  return [0, 1, 2].map((k) => (low[k]! + high[k]!) / 2) as Triple;
}

export function place(placing: Placing, points: Float32Array): Float32Array {
  const placed = rotate(placing.rotation, points);
  for (let i = 0; i < placed.length; ++i)
    placed[i] = (placed[i]! - placing.centre[i % 3]!) * placing.scale;
  return placed;
}

/** In the middle of the view, turned by `view`, a surface of this area having area 1. */
export function placingOf(points: Float32Array, view: Triple[], area: number): Placing {
  const rotation = view.flat();
  const centre = middle(rotate(rotation, points));
  return { rotation, centre, scale: 1 / Math.sqrt(area || 1) };
}

/** Where points lie in the colour box, [0, 1] in each direction. */
export function inColorBox(points: Float32Array, { axes, low, size }: ColorBox): Float32Array {
  const places = rotate(axes.flat(), points);
  for (let i = 0; i < places.length; ++i) places[i] = (places[i]! - low[i % 3]!) / size[i % 3]!;
  return places;
}
