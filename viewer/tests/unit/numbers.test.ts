import { describe, expect, it } from 'vitest';
import { evenly } from '../../src/data/matches';
import { histogram, quantile, sorted, statistics, worst } from '../../src/data/statistics';
import { ticks } from '../../src/ui/chart';
import { fileName, number, percent, quote, seconds } from '../../src/ui/format';

describe('statistics', () => {
  it('pass over what was not measured', () => {
    const { count, mean, median, max } = statistics([3, NaN, 1, 2]);
    expect([count, mean, median, max]).toEqual([3, 2, 2, 3]);
    expect(worst([NaN, 1, 5, 5])).toBe(2);
    expect(worst([NaN])).toBe(-1);
  });

  it('interpolate between neighbours', () => {
    expect(quantile(sorted([4, 1, 2, 3]), 0.5)).toBe(2.5);
    expect(quantile([], 0.5)).toBeNaN();
  });

  it('count what is above the top in the last bin', () => {
    expect(histogram([0, 0.4, 0.6, 9, NaN], 1, 2)).toEqual([2, 2]);
    expect(histogram([0, 0], 0, 2)).toEqual([2, 0]);
  });
});

describe('samples', () => {
  it('are spread over everything', () => {
    expect(evenly(10, 2)).toEqual([2, 7]);
    expect(evenly(3, 10)).toEqual([0, 1, 2]);
    expect(evenly(0, 10)).toEqual([]);
  });
});

describe('ticks', () => {
  it('are round', () => {
    expect(ticks(0, 0.057)).toEqual([0, 0.02, 0.04]);
    expect(ticks(0, 12)).toEqual([0, 5, 10]);
    expect(ticks(1, 1)).toEqual([1]);
  });
});

describe('text', () => {
  it('of numbers is short', () => {
    expect(number(8431)).toBe('8,431');
    expect(number(0.014678)).toBe('0.0147');
    expect(number(0.0000123)).toBe('1.23e-5');
    expect(number(NaN)).toBe('–');
    expect(percent(0.01234)).toBe('1.23 %');
    expect(seconds(0.0123)).toBe('12 ms');
    expect(seconds(3.8123)).toBe('3.81 s');
  });

  it('of a command is what a shell takes', () => {
    expect(quote('cat0.off')).toBe('cat0.off');
    expect(quote("it's here")).toBe(`'it'\\''s here'`);
    expect(quote('')).toBe("''");
    expect(fileName('/a/b.off')).toBe('b.off');
  });
});
