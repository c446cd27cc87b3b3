import type { Fit } from '../data/manifest';

export type Grade = Fit['grade'];

/** By icon and word as well as by colour. */
export const BADGES = {
  good: { icon: '✓', word: 'Good fit' },
  doubtful: { icon: '!', word: 'Doubtful fit' },
  poor: { icon: '✕', word: 'Poor fit' },
} as const;

/** A clause with a capital and a full stop. */
export const sentence = (clause: string): string =>
  `${clause.charAt(0).toUpperCase()}${clause.slice(1)}${clause.endsWith('.') ? '' : '.'}`;
