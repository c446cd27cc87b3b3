import type { Shape } from '../data/shape';
import { neighbours } from './graph';

/**
 * Mean curvature of each vertex times the square root of the surface's area, positive where the
 * surface bulges out: the change of the normal along each edge, averaged over edges and smoothed
 * `rounds` times over neighbours.
 */
export function meanCurvature(shape: Shape, rounds = 3): Float32Array {
  const { position, normal, count } = shape;
  const graph = neighbours(shape);
  let curvature = new Float32Array(count);
  for (let v = 0; v < count; ++v) {
    let sum = 0;
    for (let e = graph.start[v]!; e < graph.start[v + 1]!; ++e) {
      const w = graph.vertex[e]!;
      let along = 0;
      for (let k = 0; k < 3; ++k)
        along +=
          (normal[3 * w + k]! - normal[3 * v + k]!) * (position[3 * w + k]! - position[3 * v + k]!);
      sum += along / (graph.length[e]! ** 2 || 1);
    }
    curvature[v] = sum / (graph.start[v + 1]! - graph.start[v]! || 1);
  }
  for (let round = 0; round < rounds; ++round) {
    const smooth = new Float32Array(count);
    for (let v = 0; v < count; ++v) {
      let sum = curvature[v]!;
      for (let e = graph.start[v]!; e < graph.start[v + 1]!; ++e)
        sum += curvature[graph.vertex[e]!]!;
      smooth[v] = sum / (graph.start[v + 1]! - graph.start[v]! + 1);
    }
    curvature = smooth;
  }
  return curvature;
}
