import { describe, expect, it } from 'vitest';
import { css, fromOklab, positionColor, toLinear, toSrgb } from '../../src/color/oklab';
import { diverging, viridis } from '../../src/color/scales';

const lightness = ([r, g, b]: number[]): number => 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;

describe('colours', () => {
  it('of Oklab are those of the standard', () => {
    expect(css(fromOklab(1, 0, 0))).toBe('rgb(255 255 255)');
    expect(css(fromOklab(0.62796, 0.22486, 0.12585))).toBe('rgb(255 0 0)');
  });

  it('survive the way to sRGB and back', () => {
    for (const x of [0, 0.001, 0.2, 0.7, 1]) expect(toLinear(toSrgb(x))).toBeCloseTo(x, 9);
  });

  it('of places differ in every direction and stop at the box', () => {
    const middle = css(positionColor(0.5, 0.5, 0.5));
    for (const [x, y, z] of [
      [0.9, 0.5, 0.5],
      [0.5, 0.9, 0.5],
      [0.5, 0.5, 0.9],
    ] as const)
      expect(css(positionColor(x, y, z))).not.toBe(middle);
    expect(positionColor(7, 0.5, 0.5)).toEqual(positionColor(1, 0.5, 0.5));
  });
});

describe('scales', () => {
  it('viridis has the ends of matplotlib and gets lighter all along', () => {
    expect(css(viridis(0))).toMatch(/^rgb\((6|7)\d 1? ?\d? ?8\d\)$/);
    for (let i = 0; i < 50; ++i)
      expect(lightness(viridis((i + 1) / 50))).toBeGreaterThan(lightness(viridis(i / 50)));
    expect(viridis(-1)).toEqual(viridis(0));
  });

  it('diverging is lightest in the middle, blue below and orange above', () => {
    const middle = lightness(diverging(0.5));
    expect(middle).toBeGreaterThan(lightness(diverging(0)));
    expect(middle).toBeGreaterThan(lightness(diverging(1)));
    expect(diverging(0)[2]).toBeGreaterThan(diverging(0)[0]);
    expect(diverging(1)[0]).toBeGreaterThan(diverging(1)[2]);
  });
});
