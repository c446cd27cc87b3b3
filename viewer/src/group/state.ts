import type { Store } from '../store';

export type GroupColoring = 'map' | 'spread';

/** 'mode0' is the score along the first mode. */
export type Sort = 'quality' | 'name' | `mode${number}`;

/** What the page of a collection shows. */
export interface GroupState {
  coloring: GroupColoring;
  sort: Sort;
  /** The shape beside the template. */
  selected: number;
  /** The point under the pointer, and one clicked on, which stays. */
  hovered: number | null;
  kept: number | null;
  /** Of the mean shape along each mode, in standard deviations. */
  deviations: readonly number[];
}

export type GroupStore = Store<GroupState>;
