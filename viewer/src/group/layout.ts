import type { PairEntry } from './manifest';

type Matrix = Float64Array[];

const square = (count: number, value: number): Matrix =>
  Array.from({ length: count }, () => new Float64Array(count).fill(value));

/** Lengths of the shortest ways over pairs; longer than all where there is none. */
function waysThrough(count: number, pairs: PairEntry[]): Matrix {
  const way = square(count, Infinity);
  for (let i = 0; i < count; ++i) way[i]![i] = 0;
  for (const { source, target, cost } of pairs) {
    const length = Math.max(cost, 1e-6);
    way[source]![target] = way[target]![source] = Math.min(way[source]![target]!, length);
  }
  for (let k = 0; k < count; ++k)
    for (let i = 0; i < count; ++i)
      for (let j = 0; j < count; ++j) way[i]![j] = Math.min(way[i]![j]!, way[i]![k]! + way[k]![j]!);
  let far = 1e-6;
  for (const row of way) for (const x of row) if (Number.isFinite(x)) far = Math.max(far, x);
  for (const row of way) row.forEach((x, j) => Number.isFinite(x) || (row[j] = 1.2 * far));
  return way;
}

/** One round of stress majorisation (Gansner et al. 2004), which moves each node to where the others
 * would have it. */
function majorise(place: [number, number][], way: Matrix): void {
  for (let i = 0; i < place.length; ++i) {
    let [x, y, total] = [0, 0, 0];
    for (let j = 0; j < place.length; ++j) {
      if (i === j) continue;
      const weight = 1 / way[i]![j]! ** 2;
      const dx = place[i]![0] - place[j]![0];
      const dy = place[i]![1] - place[j]![1];
      const stretch = way[i]![j]! / Math.max(Math.hypot(dx, dy), 1e-9);
      x += weight * (place[j]![0] + dx * stretch);
      y += weight * (place[j]![1] + dy * stretch);
      total += weight;
    }
    if (total > 0) place[i] = [x / total, y / total];
  }
}

/** Moves places into [0, 1] each way, without distortion. */
function fit(place: [number, number][]): [number, number][] {
  const middle = [0, 1].map((k) => {
    const all = place.map((p) => p[k]!);
    return (Math.min(...all) + Math.max(...all)) / 2;
  });
  const reach = Math.max(
    ...place.map((p) => Math.max(Math.abs(p[0] - middle[0]!), Math.abs(p[1] - middle[1]!))),
    1e-9,
  );
  return place.map((p) => [
    0.5 + (p[0] - middle[0]!) / reach / 2,
    0.5 + (p[1] - middle[1]!) / reach / 2,
  ]);
}

const ROUNDS = 150;

/** Where each shape is drawn, in [0, 1] each way: the nearer the better two fit. Always the same. */
export function layOut(count: number, pairs: PairEntry[]): [number, number][] {
  const way = waysThrough(count, pairs);
  const size = way[0]?.reduce((sum, x) => sum + x, 0) ?? 0;
  // The golden angle: no two nodes begin at one place, nor on one line.
  const place = Array.from({ length: count }, (_, i): [number, number] => {
    const radius = (size / count) * Math.sqrt((i + 0.5) / count);
    return [radius * Math.cos(2.39996 * i), radius * Math.sin(2.39996 * i)];
  });
  for (let round = 0; round < ROUNDS; ++round) majorise(place, way);
  return fit(place);
}
