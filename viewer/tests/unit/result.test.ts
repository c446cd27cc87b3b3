import { describe, expect, it } from 'vitest';
import { colorsOf, Patches } from '../../src/color/coloring';
import { GREY, viridis } from '../../src/color/scales';
import type { Manifest, Report } from '../../src/data/manifest';
import { sampledLines, worstByIso, worstByTruth } from '../../src/data/matches';
import { Result } from '../../src/data/result';
import { NONE } from '../../src/data/shape';
import { extentOf } from '../../src/scene/pair_extent';
import { FIELD_OF_VIEW } from '../../src/scene/orbit';
import type { State } from '../../src/state';
import { remarks, warnings } from '../../src/ui/summary';
import { commandLine } from '../../src/ui/numbers';
import { describePoint, hint } from '../../src/ui/point_panel';
import { fitOf } from '../../src/ui/verdict';

const UNIT = { low: [0, 0, 0], size: [1, 1, 1] } as const;
const IDENTITY = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** A triangle mapped to a triangle; the third vertex has no match. */
function sample(): Result {
  const shape = { ...UNIT, vertices: 3, faces: 1, vertices_given: 3, area: 0.25, view: IDENTITY };
  const manifest = {
    format: 1,
    folder: 'out',
    source: { ...shape, simplified: false },
    target: { ...shape, simplified: true, vertices_given: 300000 },
    colors: { axes: IDENTITY, low: [0, 0, 0], size: [1, 1, 1] },
    truth: null,
    maps: [{ folder: '', image: UNIT, d_iso_max: 0.5, error_max: 2, confidence: true }],
    levels: [],
    arrays: [],
    report: {
      command: ['isomatch', 'match', 'my cat.off', 'b.off'],
      working_folder: '/data',
      options: { method: 'tracked' },
      ambiguity: 0.98,
      ambiguous: true,
      contradicted_landmarks: [[5, 60]],
      source: { file: 'my cat.off', vertices: 3, faces: 1, warnings: ['2 components'] },
      target: { file: 'b.off', vertices: 300000, faces: 1 },
    },
  } as unknown as Manifest;
  const full = 65535;
  const arrays: Record<string, number[]> = {
    'source/position': [0, full, 0, 0, 0, full, 0, 0, 0],
    'target/position': [0, full, 0, 0, 0, full, 0, 0, 0],
    'source/numbers': [5, 6, 7],
    'target/numbers': [50, 60, 70],
    'source/corner0': [0],
    'source/corner1': [2],
    'source/corner2': [4],
    'target/corner0': [0],
    'target/corner1': [2],
    'target/corner2': [4],
    'maps/0/image': [full, 0, 0, 0, 0, 0, 0, 0, 0],
    'maps/0/partner': [2, 1, 0],
    'maps/0/back': [2, 1, 0],
    'maps/0/d_iso': [65534, 0, full],
    'maps/0/error': [0, 65534, full],
    'maps/0/source_confidence': [254, 127, 255],
    'maps/0/target_confidence': [0, 254, 255],
  };
  return new Result(manifest, (name) => Uint32Array.from(arrays[name]!));
}

const state = { map: 0, level: 0, lines: 9, hovered: null, selected: null } as unknown as State;

describe('what has to be in sight', () => {
  it('is within the view at every width, near parts too', () => {
    const shape = (position: number[]) => ({ position: Float32Array.from(position) });
    const result = {
      source: shape([0, 1, 0, 0, -1, 0]),
      target: shape([0.5, 0, 2]),
      numMaps: 1,
      map: () => ({ registered: Float32Array.from([3, 0, 0]) }),
    } as unknown as Result;
    const extent = extentOf(result);
    const tangent = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
    for (const aspect of [0.4, 1, 2.5]) {
      const distance = extent.distance(aspect);
      expect(1 / distance).toBeLessThan(tangent);
      expect(0.5 / (distance - 2)).toBeLessThan(tangent * aspect);
      expect(3 / distance).toBeLessThan(tangent * aspect);
    }
    expect(extent.distance(0.4)).toBeGreaterThan(extent.distance(2.5));
  });
});

describe('the fit', () => {
  it('is that of the map that is shown, and missing in older results', () => {
    const good = { grade: 'good', reasons: [] };
    const poor = { grade: 'poor', reasons: ['it is torn'] };
    const report = { fit: good, alternatives: [{ fit: poor }] } as unknown as Report;
    expect(fitOf(report, 0)).toBe(good);
    expect(fitOf(report, 1)).toBe(poor);
    expect(fitOf({} as Report, 0)).toBeUndefined();
    expect(fitOf({} as Report, 1)).toBeUndefined();
  });
});

describe('the hint', () => {
  it('speaks of fingers only on touch screens', () => {
    expect(hint(true)).not.toMatch(/click|wheel|Shift|key|Escape/);
    expect(hint(false)).toMatch(/wheel zooms after a click/);
  });
});

describe('a result', () => {
  it('is decoded', () => {
    const result = sample();
    expect([...result.source.faces]).toEqual([0, 1, 2]);
    // Scaled to unit area and centred.
    expect([...result.source.position.slice(0, 6)]).toEqual([-1, -1, 0, 1, -1, 0]);
    const map = result.map(0);
    expect([...map.partner]).toEqual([1, 0, NONE]);
    expect([...map.dIso]).toEqual([0.5, 0, NaN]);
    expect([...map.image.slice(0, 3)]).toEqual([1, -1, 0]);
    expect([...map.confidence!.source]).toEqual([1, 0.5, NaN]);
    expect([...map.confidence!.target]).toEqual([0, 1, NaN]);
    expect(map.isRegistered).toBe(false);
    expect(result.map(0)).toBe(map);
  });

  it('is coloured by confidence, and grey where it has no match', () => {
    const result = sample();
    const coloring = { ...state, coloring: 'confidence' } as State;
    const { source, target, range } = colorsOf(result, coloring, new Patches(result));
    expect(range).toMatchObject({ low: 0, high: 1, open: false });
    const of = (shares: (number | null)[]) =>
      Float32Array.from(shares.flatMap((share) => (share === null ? GREY : viridis(share))));
    expect(source).toEqual(of([1, 0.5, null]));
    expect(target).toEqual(of([0, 1, null]));
  });

  it('has lines where it has matches, and worst ones', () => {
    const result = sample();
    expect(sampledLines(result, state)).toEqual([
      { source: 0, target: 1 },
      { source: 1, target: 0 },
    ]);
    expect(worstByIso(result, state)).toEqual({ source: 0, target: 1 });
    expect(worstByTruth(result, state)).toEqual({ source: 1, target: 0 });
  });

  it('is told in words', () => {
    const result = sample();
    const bad = remarks(result, 0).filter(({ kind }) => kind === 'bad');
    expect(bad.map(({ text }) => text).join(' ')).toContain('Look for a flip');
    expect(bad.map(({ text }) => text).join(' ')).toContain('1 of 3 vertices');
    expect(bad.map(({ text }) => text).join(' ')).toContain('contradict the shapes: 5 → 60');
    expect(warnings(result)).toEqual([
      'Source: 2 components',
      'Target: simplified for display from 300,000 to 3 vertices. The match itself used all of them.',
    ]);
    expect(commandLine(result)).toBe("cd /data\nisomatch match 'my cat.off' b.off");
  });

  it('names vertices by the numbers of the files', () => {
    const at = (side: 'source' | 'target', vertex: number) =>
      describePoint(sample(), state, { side, vertex });
    expect(at('source', 0)).toBe(
      'source vertex 5 ↔ target vertex 60  ·  d_iso 0.5  ·  confidence 1  ·  ground-truth error 0 of √area',
    );
    expect(at('target', 0)).toContain('target vertex 50 ↔ source vertex 6');
    expect(at('target', 0)).toContain('confidence 0  ·');
    expect(at('source', 2)).toBe('source vertex 7 has no match.');
  });
});
