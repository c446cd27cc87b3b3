import type { Side } from './data/result';
import type { Store } from './store';

export type Coloring =
  'map' | 'checker' | 'confidence' | 'd_iso' | 'error' | 'curvature' | 'patches';
export type Layout = 'pair' | 'overlay';

export interface Point {
  side: Side;
  vertex: number;
}

/** What the page shows. */
export interface State {
  coloring: Coloring;
  /** 0 is the best map, then the alternatives. */
  map: number;
  /** Of the paper's method; its last level is the final map. */
  level: number;
  layout: Layout;
  linked: boolean;
  /** 0: the source as it is, 1: in the target's pose. */
  morph: number;
  lines: number;
  worstIso: boolean;
  worstTruth: boolean;
  /** Under the pointer, and clicked on, which stays. */
  hovered: Point | null;
  selected: Point | null;
}

export type PairStore = Store<State>;
