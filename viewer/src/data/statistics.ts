/** Of the values that are numbers. */
export interface Statistics {
  count: number;
  mean: number;
  median: number;
  p95: number;
  max: number;
}

export const sorted = (values: Iterable<number>): Float64Array =>
  Float64Array.from(Array.from(values).filter((x) => !Number.isNaN(x))).sort();

export function quantile(ascending: ArrayLike<number>, share: number): number {
  if (ascending.length === 0) return NaN;
  const place = share * (ascending.length - 1);
  const below = Math.floor(place);
  const above = Math.min(below + 1, ascending.length - 1);
  return ascending[below]! + (place - below) * (ascending[above]! - ascending[below]!);
}

export function statistics(values: Iterable<number>): Statistics {
  const ascending = sorted(values);
  return {
    count: ascending.length,
    mean: ascending.reduce((sum, x) => sum + x, 0) / ascending.length,
    median: quantile(ascending, 0.5),
    p95: quantile(ascending, 0.95),
    max: quantile(ascending, 1),
  };
}

/** Place of the largest number, -1 if there is none; the first of equal ones. */
export function worst(values: ArrayLike<number>): number {
  let place = -1;
  for (let i = 0; i < values.length; ++i)
    if (!Number.isNaN(values[i]!) && (place < 0 || values[i]! > values[place]!)) place = i;
  return place;
}

/** Counts of `bins` equal parts of [0, top]; what is above counts in the last. */
export function histogram(values: Iterable<number>, top: number, bins: number): number[] {
  const counts = new Array<number>(bins).fill(0);
  for (const value of values) {
    if (Number.isNaN(value)) continue;
    counts[Math.min(bins - 1, Math.floor((value / (top || 1)) * bins))]! += 1;
  }
  return counts;
}
