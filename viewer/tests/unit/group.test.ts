import { describe, expect, it } from 'vitest';
import type { Triple } from '../../src/data/manifest';
import { Collection, facesPresent, rootMeanSquares } from '../../src/group/collection';
import { Coloring } from '../../src/group/coloring';
import { neighbourOf, pairsOf } from '../../src/group/details';
import { layOut } from '../../src/group/layout';
import type { GroupManifest, MemberEntry, PairEntry } from '../../src/group/manifest';
import { shapeAt } from '../../src/group/model';
import { orderOf, sorts } from '../../src/group/order';
import { badness, describePair } from '../../src/group/pair_graph';
import { describePoint } from '../../src/group/point_text';
import { countGrades, remarksOf } from '../../src/group/summary';
import { GREY } from '../../src/color/scales';

const IDENTITY: [Triple, Triple, Triple] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const BOX = { low: [0, 0, 0] as Triple, size: [2, 2, 2] as Triple };
const PLACED = { ...BOX, area: 4, view: IDENTITY };
const FULL = 65535;

const member = (name: string, other: Partial<MemberEntry> = {}): MemberEntry => ({
  ...PLACED,
  name,
  grade: 'good',
  reasons: [],
  cycle_error: 0.01,
  missing: 0,
  ...other,
});

const pair = (source: number, target: number, cycle_error: number, cost = 1): PairEntry => ({
  source,
  target,
  cost,
  cycle_error,
  use: 'agrees',
});

/** Three squares of two triangles; the last has lost a corner. */
const manifest: GroupManifest = {
  format: 1,
  kind: 'group',
  title: 'squares',
  command: ['isomatch', 'group'],
  template: { ...PLACED, member: 0, vertices: 4, vertices_given: 9, simplified: true },
  colors: { ...BOX, axes: IDENTITY },
  spread_max: 0.4,
  members: [
    member('square 10'),
    member('square 9', { grade: 'doubtful', reasons: ['it is far'], cycle_error: 0.2 }),
    member('square 2', { missing: 1, cycle_error: 0.03 }),
  ],
  pairs: [pair(0, 1, 0.3), { ...pair(0, 2, 0.1), use: 'runner-up' }],
  model: {
    ...PLACED,
    modes: [{ low: [0, 0, 0], size: [1, 0, 0], share: 0.9, scores: [0, 2, -1] }],
  },
  quality: { compactness: [0.9, 1], generalisation: [null, null], specificity: [0.1, 0.2] },
  arrays: [],
};

function sample(): Collection {
  const square = [0, FULL, FULL, 0, 0, 0, FULL, FULL, 0, 0, 0, 0];
  const steps: Record<string, number[]> = {
    'template/position': square,
    'template/numbers': [3, 5, 7, 8],
    'template/corner0': [0, 0],
    // One, two and two, three corners after the first.
    'template/corner1': [2, 4],
    'template/corner2': [4, 6],
    'members/0/position': square,
    'members/1/position': square,
    'members/2/position': square,
    'members/0/spread': [0, 0, 0, 0],
    'members/1/spread': [65534, 0, 0, 32767],
    'members/2/spread': [0, 0, 0, 65535],
    'model/mean': square,
    'model/modes/0': [0, FULL, FULL, 0, 0, 0, 0, 0, 0, 0, 0, 0],
  };
  return new Collection(manifest, (name) => Uint32Array.from(steps[name]!));
}

describe('a collection', () => {
  it('has its shapes in the middle of the view, of unit area', () => {
    expect([...sample().shape(1).position]).toEqual([
      -0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0,
    ]);
  });

  it('has no faces at points that are missing', () => {
    const collection = sample();
    expect([...collection.shape(1).faces]).toEqual([0, 1, 2, 0, 2, 3]);
    expect([...collection.shape(2).faces]).toEqual([0, 1, 2]);
    expect([...facesPresent(Uint32Array.of(0, 1, 2), (p) => p < 2)]).toEqual([]);
  });

  it('knows how far pairs lie apart, and where points are missing', () => {
    const collection = sample();
    expect([...collection.spread(1)].map((x) => Number(x.toFixed(3)))).toEqual([0.4, 0, 0, 0.2]);
    expect(collection.isThere(2, 3)).toBe(false);
    const rows = [Float32Array.of(3, NaN), Float32Array.of(4, NaN)];
    const [both, none] = rootMeanSquares(2, rows);
    expect(both).toBeCloseTo(Math.sqrt(12.5));
    expect(none).toBeNaN();
  });

  it('is coloured alike by map, and grey on the template where a shape lacks a point', () => {
    const collection = sample();
    const coloring = new Coloring(collection);
    expect(coloring.ofMember(0, 'map')).toBe(coloring.ofMember(1, 'map'));
    const template = coloring.ofTemplate(2, 'map');
    GREY.forEach((x, k) => expect(template[9 + k]).toBeCloseTo(x));
    expect([...template.slice(0, 9)]).toEqual([...collection.mapColors.slice(0, 9)]);
    expect(coloring.range('spread')!.high).toBeGreaterThan(0.2);
  });

  it('describes a point', () => {
    const collection = sample();
    const state = {
      coloring: 'map',
      sort: 'name',
      selected: 1,
      hovered: 0,
      kept: null,
      deviations: [],
    } as const;
    const averages = collection.meanSpread();
    expect(describePoint(collection, averages, state, 'hint')).toBe(
      'template vertex 3  ·  spread 0.4 of √area on square 9  ·  0.231 over all shapes',
    );
    const missing = { ...state, selected: 2, hovered: null, kept: 3 };
    expect(describePoint(collection, averages, missing, 'hint')).toBe(
      'template vertex 8  ·  missing on square 2',
    );
    expect(describePoint(collection, null, { ...state, hovered: null }, 'hint')).toBe('hint');
  });

  it('is told in words', () => {
    expect(countGrades(manifest)).toEqual({ good: 2, doubtful: 1, poor: 0 });
    const remarks = remarksOf(manifest);
    expect(remarks[0]).toBe('3 shapes, followed from square 10');
    expect(remarks[1]).toBe('2 pairs: 1 agree, 1 took their runner-up, 0 composed of others');
    expect(remarks[3]).toBe('Shown with 4 of the 9 points');
  });
});

describe('the order of shapes', () => {
  it('is by grade, then by cycle error, the worst first', () => {
    expect(orderOf(manifest, 'quality')).toEqual([1, 2, 0]);
  });

  it('is by name as people count', () => {
    expect(orderOf(manifest, 'name')).toEqual([2, 1, 0]);
  });

  it('is by score, the lowest first', () => {
    expect(orderOf(manifest, 'mode0')).toEqual([2, 0, 1]);
    expect(sorts(manifest).map(({ value }) => value)).toEqual(['quality', 'name', 'mode0']);
    expect(sorts({ ...manifest, model: null })).toHaveLength(2);
  });

  it('has a next one and one before, around', () => {
    expect(neighbourOf([1, 2, 0], 2, 1)).toBe(0);
    expect(neighbourOf([1, 2, 0], 0, 1)).toBe(1);
    expect(neighbourOf([1, 2, 0], 1, -1)).toBe(0);
  });
});

describe('a model', () => {
  it('moves the mean by deviations along modes', () => {
    const mean = Float32Array.of(1, 2, 3);
    const modes = [Float32Array.of(1, 0, 0), Float32Array.of(0, 1, 1)];
    expect([...shapeAt(mean, modes, [2, -1])]).toEqual([3, 1, 2]);
    expect([...shapeAt(mean, modes, [])]).toEqual([1, 2, 3]);
  });

  it('moves in the units in which it is shown', () => {
    const model = sample().model!;
    const before = model.shape.position[3]!;
    model.move([2]);
    // One unit each deviation, half a unit of the view.
    expect(model.shape.position[3]).toBeCloseTo(before + 1);
    model.move([]);
    expect(model.shape.position[3]).toBeCloseTo(before);
  });

  it('knows the scores of shapes as far as sliders reach', () => {
    expect(sample().model!.scores(1, 1.5)).toEqual([1.5]);
    expect(sample().model!.scores(2, 1.5)).toEqual([-1]);
  });
});

describe('the graph of pairs', () => {
  const all = [pair(0, 1, 0, 1), pair(0, 2, 0, 3), pair(1, 2, 0, 3), pair(0, 3, 0, 1)];

  it('has those near each other that fit well, always at the same places', () => {
    const places = layOut(4, all);
    const apart = (i: number, j: number) =>
      Math.hypot(places[i]![0] - places[j]![0], places[i]![1] - places[j]![1]);
    expect(apart(0, 1)).toBeLessThan(apart(0, 2));
    expect(layOut(4, all)).toEqual(places);
    for (const place of places.flat()) {
      expect(place).toBeGreaterThanOrEqual(0);
      expect(place).toBeLessThanOrEqual(1);
    }
  });

  it('has a place for a shape alone and for shapes without pairs', () => {
    expect(layOut(1, [])).toEqual([[0.5, 0.5]]);
    expect(layOut(3, []).flat().every(Number.isFinite)).toBe(true);
  });

  it('stands out where cycles do not close', () => {
    const pairs = [0.01, 0.01, 0.01, 0.5].map((error, k) => pair(0, k + 1, error));
    const bad = badness(pairs);
    expect(bad(pairs[0]!)).toBe(0);
    expect(bad(pairs[3]!)).toBe(1);
  });

  it('tells of a pair, and which pairs a shape has', () => {
    expect(describePair(manifest.members, manifest.pairs[1]!)).toBe(
      'square 10 → square 2: cycle error 0.1, cost 1; its runner-up took the place of its own map',
    );
    expect(pairsOf(manifest.pairs, 0)).toHaveLength(2);
    expect(pairsOf(manifest.pairs, 2)).toEqual([manifest.pairs[1]]);
  });
});
