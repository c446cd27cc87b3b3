import { fill, placeColor } from '../color/paint';
import type { Arrays } from '../data/arrays';
import { decodeDistances, decodeFaces, decodePoints } from '../data/decode';
import { inColorBox, place, placingOf } from '../data/placing';
import type { Shape } from '../data/shape';
import { vertexNormals } from '../geometry/normals';
import type { GroupManifest, PlacedEntry } from './manifest';
import { Model } from './model';

/** The faces whose corners are all there. */
export function facesPresent(faces: Uint32Array, isThere: (point: number) => boolean): Uint32Array {
  const kept: number[] = [];
  for (let f = 0; f < faces.length; f += 3) {
    const face = faces.subarray(f, f + 3);
    if (face.every(isThere)) kept.push(...face);
  }
  return Uint32Array.from(kept);
}

/** Root mean square of each point's values; NaN where there are none. */
export function rootMeanSquares(count: number, rows: Float32Array[]): Float32Array {
  const means = new Float32Array(count);
  for (let p = 0; p < count; ++p) {
    let sum = 0;
    let known = 0;
    for (const row of rows) {
      if (Number.isNaN(row[p]!)) continue;
      sum += row[p]! ** 2;
      ++known;
    }
    means[p] = Math.sqrt(sum / known);
  }
  return means;
}

/** Everything that the page shows. Shapes are decoded when they are first asked for; their points
 * are those of the template. */
export class Collection {
  readonly template: Shape;
  readonly model: Model | null;
  /** Of each point, the same on all shapes. */
  readonly mapColors: Float32Array;
  private readonly shapes = new Map<number, Shape>();
  private readonly spreads = new Map<number, Float32Array>();

  constructor(
    readonly manifest: GroupManifest,
    private readonly arrays: Arrays,
  ) {
    const { template, model, colors } = manifest;
    const faces = decodeFaces(arrays, 'template');
    const points = decodePoints(arrays('template/position'), template);
    this.template = this.placed(points, template, faces);
    const places = inColorBox(points, colors);
    this.template.place = places;
    this.mapColors = fill(template.vertices, (v) => placeColor(places, v));
    this.model = model && new Model(model, arrays, this.template);
  }

  get count(): number {
    return this.manifest.members.length;
  }

  get numPoints(): number {
    return this.template.count;
  }

  get knowsSpread(): boolean {
    return this.manifest.spread_max !== null;
  }

  shape(member: number): Shape {
    let shape = this.shapes.get(member);
    if (!shape) this.shapes.set(member, (shape = this.decodeShape(member)));
    return shape;
  }

  /** How far apart pairs say that each point lies, over the square root of the area; NaN where it is
   * missing. */
  spread(member: number): Float32Array {
    let spread = this.spreads.get(member);
    if (!spread) {
      const steps = this.arrays(`members/${member}/spread`);
      this.spreads.set(member, (spread = decodeDistances(steps, this.manifest.spread_max ?? 0)));
    }
    return spread;
  }

  /** Of all members. */
  meanSpread(): Float32Array {
    const rows = this.manifest.members.map((_, k) => this.spread(k));
    return rootMeanSquares(this.numPoints, rows);
  }

  isThere(member: number, point: number): boolean {
    return !Number.isNaN(this.spread(member)[point]!);
  }

  private decodeShape(member: number): Shape {
    const entry = this.manifest.members[member]!;
    const points = decodePoints(this.arrays(`members/${member}/position`), entry);
    const { faces } = this.template;
    const own = entry.missing ? facesPresent(faces, (p) => this.isThere(member, p)) : faces;
    return this.placed(points, entry, own);
  }

  private placed(points: Float32Array, entry: PlacedEntry, faces: Uint32Array): Shape {
    const position = place(placingOf(points, entry.view, entry.area), points);
    return {
      count: this.manifest.template.vertices,
      position,
      normal: vertexNormals(position, faces),
      faces,
      numbers: this.template?.numbers ?? this.arrays('template/numbers'),
    };
  }
}
