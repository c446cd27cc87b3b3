import type { State } from '../state';
import type { Result } from './result';
import { NONE } from './shape';
import { worst } from './statistics';

/** A source vertex and where it goes. */
export interface Line {
  source: number;
  target: number;
}

/** At most `count` of 0 ... `total` - 1, evenly spaced. */
export function evenly(total: number, count: number): number[] {
  const taken = Math.min(total, Math.round(count));
  return Array.from({ length: taken }, (_, i) => Math.floor(((i + 0.5) * total) / taken));
}

/** Whether the paper's method is shown at a level before its last. */
export const isCoarse = (result: Result, state: State): boolean =>
  result.numLevels > 0 && state.level < result.numLevels - 1;

/** The matches that are drawn, evenly spaced: neighbours in number are neighbours in space. */
export function sampledLines(result: Result, state: State): Line[] {
  if (isCoarse(result, state)) {
    const level = result.level(state.level);
    return evenly(level.source.length, state.lines).map((m) => ({
      source: level.source[m]!,
      target: level.target[m]!,
    }));
  }
  const map = result.map(state.map);
  return evenly(map.partner.length, state.lines)
    .filter((source) => map.partner[source] !== NONE)
    .map((source) => ({ source, target: map.partner[source]! }));
}

/** The match of largest isometric distortion. */
export function worstByIso(result: Result, state: State): Line | null {
  if (isCoarse(result, state)) {
    const level = result.level(state.level);
    const m = worst(level.dIso);
    return m < 0 ? null : { source: level.source[m]!, target: level.target[m]! };
  }
  const map = result.map(state.map);
  const source = worst(map.dIso);
  return source < 0 || map.partner[source] === NONE
    ? null
    : { source, target: map.partner[source]! };
}

/** The match of largest ground-truth error; that of the final map. */
export function worstByTruth(result: Result, state: State): Line | null {
  const map = result.map(state.map);
  if (!map.error || isCoarse(result, state)) return null;
  const source = worst(map.error);
  return source < 0 || map.partner[source] === NONE
    ? null
    : { source, target: map.partner[source]! };
}
