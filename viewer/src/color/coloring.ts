import { meanCurvature } from '../geometry/curvature';
import { nearestBase } from '../geometry/patches';
import type { Result, Side } from '../data/result';
import { NONE, type Shape } from '../data/shape';
import { quantile, sorted } from '../data/statistics';
import type { State } from '../state';
import type { Rgb } from './oklab';
import { fill, openRange, paint, placeColor, type Range } from './paint';
import { diverging, GREY, viridis } from './scales';

export interface Colors {
  source: Float32Array;
  target: Float32Array;
  /** Of values; none where colours stand for places. */
  range: Range | null;
}

function byMap(result: Result, state: State): Colors {
  const map = result.map(state.map);
  const place = result.target.place!;
  return {
    source: fill(result.source.count, (v) =>
      map.partner[v] === NONE ? GREY : placeColor(map.place, v),
    ),
    target: fill(result.target.count, (v) => (map.back[v] === NONE ? GREY : placeColor(place, v))),
    range: null,
  };
}

/** The values of the source on both sides: those of a target vertex are its partner's. */
function bySourceValue(result: Result, state: State, values: Float32Array): Colors {
  const range = openRange(values);
  const { back } = result.map(state.map);
  const carried = Float32Array.from(back, (v) => (v === NONE ? NaN : values[v]!));
  return { source: paint(values, range), target: paint(carried, range), range };
}

function byConfidence({ source, target }: Record<Side, Float32Array>): Colors {
  const range = { scale: viridis, low: 0, high: 1, open: false };
  return { source: paint(source, range), target: paint(target, range), range };
}

const curvatures = new WeakMap<Shape, Float32Array>();

function curvatureOf(shape: Shape): Float32Array {
  let curvature = curvatures.get(shape);
  if (!curvature) curvatures.set(shape, (curvature = meanCurvature(shape)));
  return curvature;
}

function byCurvature(result: Result): Colors {
  const source = curvatureOf(result.source);
  const target = curvatureOf(result.target);
  const high = quantile(sorted(source).map(Math.abs).sort(), 0.8) || 1;
  const range = { scale: diverging, low: -high, high, open: false };
  return { source: paint(source, range), target: paint(target, range), range };
}

/** A patch's colour: that of its target base, a shade lighter or darker than its neighbours. */
function patchColor(result: Result, targetBase: number): Rgb {
  const color = placeColor(result.target.place!, targetBase);
  // Scatters the numbers of neighbours over [0, 1).
  const shade = 0.65 + 0.7 * ((targetBase * 0.6180339887) % 1);
  return color.map((x) => Math.min(1, x * shade)) as Rgb;
}

/** Nearest base of each vertex at the state's level; cached, since it takes a while. */
export class Patches {
  private key = '';
  private value: Record<Side, Int32Array> | null = null;

  constructor(private readonly result: Result) {}

  at(index: number): Record<Side, Int32Array> {
    if (this.value && this.key === String(index)) return this.value;
    const level = this.result.level(index);
    this.key = String(index);
    this.value = {
      source: nearestBase(this.result.source, level.source),
      target: nearestBase(this.result.target, level.target),
    };
    return this.value;
  }
}

function byPatches(result: Result, state: State, patches: Patches): Colors {
  const level = result.level(state.level);
  const partner = new Map<number, number>();
  level.source.forEach((s, m) => {
    if (!partner.has(s)) partner.set(s, level.target[m]!);
  });
  const bases = patches.at(state.level);
  const color = (base: number | undefined): Rgb =>
    base === undefined || base === NONE ? GREY : patchColor(result, base);
  return {
    source: fill(result.source.count, (v) => color(partner.get(bases.source[v]!))),
    target: fill(result.target.count, (v) => color(bases.target[v])),
    range: null,
  };
}

export function colorsOf(result: Result, state: State, patches: Patches): Colors {
  const map = result.map(state.map);
  switch (state.coloring) {
    case 'confidence':
      return map.confidence ? byConfidence(map.confidence) : byMap(result, state);
    case 'd_iso':
      return bySourceValue(result, state, map.dIso);
    case 'error':
      return bySourceValue(result, state, map.error ?? map.dIso);
    case 'curvature':
      return byCurvature(result);
    case 'patches':
      return byPatches(result, state, patches);
    default:
      return byMap(result, state);
  }
}
