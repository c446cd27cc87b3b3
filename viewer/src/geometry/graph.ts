import type { Shape } from '../data/shape';

/** Neighbours of vertex v are entries [start[v], start[v + 1]); an edge of two faces occurs twice. */
export interface Graph {
  start: Uint32Array;
  vertex: Uint32Array;
  length: Float32Array;
}

const graphs = new WeakMap<Shape, Graph>();

function build({ faces, position, count }: Shape): Graph {
  const start = new Uint32Array(count + 1);
  for (const v of faces) start[v + 1]! += 2;
  for (let v = 0; v < count; ++v) start[v + 1]! += start[v]!;
  const next = start.slice();
  const vertex = new Uint32Array(start[count]!);
  const length = new Float32Array(vertex.length);
  for (let f = 0; f < faces.length; f += 3) {
    for (let k = 0; k < 3; ++k) {
      const v = faces[f + k]!;
      for (const w of [faces[f + ((k + 1) % 3)]!, faces[f + ((k + 2) % 3)]!]) {
        const edge = next[v]!++;
        vertex[edge] = w;
        length[edge] = Math.hypot(
          position[3 * v]! - position[3 * w]!,
          position[3 * v + 1]! - position[3 * w + 1]!,
          position[3 * v + 2]! - position[3 * w + 2]!,
        );
      }
    }
  }
  return { start, vertex, length };
}

export function neighbours(shape: Shape): Graph {
  let graph = graphs.get(shape);
  if (!graph) graphs.set(shape, (graph = build(shape)));
  return graph;
}
