import { quantile, sorted } from '../data/statistics';
import { positionColor, type Rgb } from './oklab';
import { GREY, type Scale, viridis } from './scales';

/** A colour scale and the values at its ends. */
export interface Range {
  scale: Scale;
  low: number;
  high: number;
  /** What is above `high` has its colour. */
  open: boolean;
}

export function fill(count: number, color: (vertex: number) => Rgb): Float32Array {
  const colors = new Float32Array(3 * count);
  for (let v = 0; v < count; ++v) colors.set(color(v), 3 * v);
  return colors;
}

/** Paints a shape by values; grey where there is none. */
export function paint(values: Float32Array, { scale, low, high }: Range): Float32Array {
  return fill(values.length, (v) =>
    Number.isNaN(values[v]!) ? GREY : scale((values[v]! - low) / (high - low || 1)),
  );
}

export function placeColor(place: Float32Array, v: number): Rgb {
  return positionColor(place[3 * v]!, place[3 * v + 1]!, place[3 * v + 2]!);
}

/** From 0 to a value that few exceed: a few bad vertices must not make everything else look the
 * same. Bright is large. */
export function openRange(values: Iterable<number>): Range {
  const ascending = sorted(values);
  const high = quantile(ascending, 0.98) || Math.max(0, quantile(ascending, 1)) || 1;
  return { scale: viridis, low: 0, high, open: true };
}
