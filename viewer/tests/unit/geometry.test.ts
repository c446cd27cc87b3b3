import { describe, expect, it } from 'vitest';
import { NONE } from '../../src/data/shape';
import { meanCurvature } from '../../src/geometry/curvature';
import { vertexNormals } from '../../src/geometry/normals';
import { nearestBase } from '../../src/geometry/patches';
import { band, shapeOf, sheet } from './shapes';

describe('normals', () => {
  it('of a sheet point up', () => {
    const { normal } = sheet(3, 2);
    for (let v = 0; v < normal.length; v += 3)
      expect([...normal.slice(v, v + 3)]).toEqual([0, 0, 1]);
  });

  it('are zero without a face', () => {
    const normals = vertexNormals(Float32Array.from([1, 2, 3]), new Uint32Array());
    expect([...normals]).toEqual([0, 0, 0]);
  });
});

describe('curvature', () => {
  it('of a sheet is zero', () => {
    for (const c of meanCurvature(sheet(5, 5))) expect(c).toBeCloseTo(0, 6);
  });

  it('of a sphere is one over the radius, and negative from inside', () => {
    const sphere = band(30, 2);
    const middle = 14 * 60 + 7;
    expect(meanCurvature(sphere)[middle]).toBeCloseTo(0.5, 2);
    const inside = shapeOf([...sphere.position], [...sphere.faces].reverse());
    expect(meanCurvature(inside)[middle]).toBeCloseTo(-0.5, 2);
  });
});

describe('patches', () => {
  it('take the nearest base along the mesh', () => {
    const nearest = nearestBase(sheet(10, 2), [0, 10]);
    expect(nearest[2]).toBe(0);
    expect(nearest[9]).toBe(10);
    expect(nearest[11]).toBe(0);
    expect([...nearest].every((base) => base === 0 || base === 10)).toBe(true);
  });

  it('agree with a search over all bases', () => {
    const shape = band(12, 1);
    const bases = [0, 40, 77, 133, 200];
    const nearest = nearestBase(shape, bases);
    const fields = bases.map((base) => distances(shape, base));
    for (let v = 0; v < shape.count; ++v) {
      const best = Math.min(...fields.map((field) => field[v]!));
      expect(fields[bases.indexOf(nearest[v]!)]![v]).toBeCloseTo(best, 6);
    }
  });

  it('leave out what is not connected, and bear repetition', () => {
    const shape = shapeOf([0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 9], [0, 1, 2]);
    expect([...nearestBase(shape, [1, 1])]).toEqual([1, 1, 1, NONE]);
  });
});

/** Distances along edges by relaxing them until nothing changes. */
function distances(shape: ReturnType<typeof band>, from: number): number[] {
  const field = new Array<number>(shape.count).fill(Infinity);
  field[from] = 0;
  const length = (v: number, w: number) =>
    Math.hypot(...[0, 1, 2].map((k) => shape.position[3 * v + k]! - shape.position[3 * w + k]!));
  for (let changed = true; changed;) {
    changed = false;
    for (let f = 0; f < shape.faces.length; ++f) {
      const v = shape.faces[f]!;
      const w = shape.faces[f % 3 === 2 ? f - 2 : f + 1]!;
      for (const [a, b] of [
        [v, w],
        [w, v],
      ] as const) {
        const through = field[a]! + length(a, b);
        if (through < field[b]! - 1e-12) {
          field[b] = through;
          changed = true;
        }
      }
    }
  }
  return field;
}
