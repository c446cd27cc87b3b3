import type { ArrayEntry, Box, ColorBox, Triple } from '../data/manifest';
import type { Grade } from '../ui/grades';

/** What results/page/group_page.cpp writes into the page. */

/** A shape in the file's units, and how it is shown. */
export interface PlacedEntry extends Box {
  /** Of the surface, or what it would be if nothing were missing. */
  area: number;
  /** Rows point right, up and towards the viewer. */
  view: [Triple, Triple, Triple];
}

export interface TemplateEntry extends PlacedEntry {
  /** Which of the members it is. */
  member: number;
  vertices: number;
  vertices_given: number;
  simplified: boolean;
}

export interface MemberEntry extends PlacedEntry {
  name: string;
  grade: Grade;
  reasons: string[];
  /** Mean over its pairs, over the square root of the area. */
  cycle_error: number;
  /** How many of the points it lacks. */
  missing: number;
}

export type Use = 'agrees' | 'runner-up' | 'composed';

export interface PairEntry {
  source: number;
  target: number;
  cost: number;
  cycle_error: number;
  use: Use;
}

export interface ModeEntry extends Box {
  /** Of the variance. */
  share: number;
  /** Of each member, in standard deviations. */
  scores: number[];
}

export interface ModelEntry extends PlacedEntry {
  modes: ModeEntry[];
}

/** For 1, 2, ... modes; null is not a number. */
export interface Quality {
  compactness: (number | null)[];
  generalisation: (number | null)[];
  specificity: (number | null)[];
}

export interface GroupManifest {
  format: number;
  kind: 'group';
  title: string;
  command: string[];
  template: TemplateEntry;
  colors: ColorBox;
  /** Null if it is not known how far pairs lie apart. */
  spread_max: number | null;
  members: MemberEntry[];
  pairs: PairEntry[];
  model: ModelEntry | null;
  quality: Quality | null;
  arrays: ArrayEntry[];
}
