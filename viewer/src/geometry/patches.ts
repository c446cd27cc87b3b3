import { NONE, type Shape } from '../data/shape';
import { neighbours } from './graph';

/** A binary heap of vertices by distance; an entry that was improved later is passed over. */
class Queue {
  private readonly keys: number[] = [];
  private readonly vertices: number[] = [];

  get empty(): boolean {
    return this.keys.length === 0;
  }

  push(key: number, vertex: number): void {
    let i = this.keys.length;
    while (i > 0) {
      const parent = (i - 1) >> 1;
      if (this.keys[parent]! <= key) break;
      this.keys[i] = this.keys[parent]!;
      this.vertices[i] = this.vertices[parent]!;
      i = parent;
    }
    this.keys[i] = key;
    this.vertices[i] = vertex;
  }

  pop(): { key: number; vertex: number } {
    const top = { key: this.keys[0]!, vertex: this.vertices[0]! };
    const key = this.keys.pop()!;
    const vertex = this.vertices.pop()!;
    const size = this.keys.length;
    if (size === 0) return top;
    let i = 0;
    for (let child = 1; child < size; child = 2 * i + 1) {
      if (child + 1 < size && this.keys[child + 1]! < this.keys[child]!) ++child;
      if (this.keys[child]! >= key) break;
      this.keys[i] = this.keys[child]!;
      this.vertices[i] = this.vertices[child]!;
      i = child;
    }
    this.keys[i] = key;
    this.vertices[i] = vertex;
    return top;
  }
}

/** For each vertex the nearest of `bases` along the mesh's edges, `NONE` if none is connected. */
export function nearestBase(shape: Shape, bases: Iterable<number>): Int32Array {
  const graph = neighbours(shape);
  const nearest = new Int32Array(shape.count).fill(NONE);
  const distance = new Float64Array(shape.count).fill(Infinity);
  const queue = new Queue();
  for (const base of bases) {
    if (distance[base] === 0) continue;
    distance[base] = 0;
    nearest[base] = base;
    queue.push(0, base);
  }
  while (!queue.empty) {
    const { key, vertex } = queue.pop();
    if (key > distance[vertex]!) continue;
    for (let e = graph.start[vertex]!; e < graph.start[vertex + 1]!; ++e) {
      const to = graph.vertex[e]!;
      const through = key + graph.length[e]!;
      if (through >= distance[to]!) continue;
      distance[to] = through;
      nearest[to] = nearest[vertex]!;
      queue.push(through, to);
    }
  }
  return nearest;
}
