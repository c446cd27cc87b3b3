import { fromOklab, type Rgb, toLinear } from './oklab';

/** What has no value or no partner. */
export const GREY: Rgb = [0.3, 0.3, 0.3];

export type Scale = (share: number) => Rgb;

// A polynomial through matplotlib's viridis: even steps look even, also without red and green.
const VIRIDIS: readonly Rgb[] = [
  [0.2777273272, 0.0054073445, 0.3340998053],
  [0.1050930431, 1.4046135299, 1.3845901626],
  [-0.3308618287, 0.2148475595, 0.095095163],
  [-4.634230499, -5.7991009734, -19.3324409563],
  [6.2282699363, 14.1799333668, 56.6905526007],
  [4.7763849977, -13.7451453777, -65.3530326334],
  [-5.4354558559, 4.6458526122, 26.3124352496],
];

const clamp = (x: number): number => Math.min(1, Math.max(0, x));

export const viridis: Scale = (share) => {
  const t = clamp(share);
  const channel = (k: number) =>
    toLinear(clamp(VIRIDIS.reduceRight((sum, coefficient) => sum * t + coefficient[k]!, 0)));
  return [channel(0), channel(1), channel(2)];
};

/** From blue through near white, at one half, to orange. */
export const diverging: Scale = (share) => {
  const t = 2 * clamp(share) - 1;
  const s = Math.abs(t);
  return t < 0
    ? fromOklab(0.93 - 0.48 * s, -0.03 * s, -0.15 * s)
    : fromOklab(0.93 - 0.33 * s, 0.11 * s, 0.13 * s);
};
