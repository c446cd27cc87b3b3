import { vertexNormals } from '../geometry/normals';
import { type Arrays, unzigzag } from './arrays';
import type { Box, Manifest, ShapeEntry, Triple } from './manifest';

export type Side = 'source' | 'target';

/** Coordinates are the viewer's: x right, y up, z towards the viewer, surfaces of unit area. */
export interface Shape {
  count: number;
  position: Float32Array;
  normal: Float32Array;
  /** Three corners a face. */
  faces: Uint32Array;
  /** The vertices' numbers in the file. */
  numbers: Uint32Array;
  /** Where each vertex lies in the colour box, [0, 1] in each direction. */
  place?: Float32Array;
}

export const NONE = -1;

/** A map, by the source's vertices; NaN is what was not measured or has no match. */
export interface ShapeMap {
  /** Nearest target vertex or `NONE`. */
  partner: Int32Array;
  /** For each target vertex the source vertex that lands nearest, or `NONE`. */
  back: Int32Array;
  /** Where vertices land, in the viewer's coordinates of the target. */
  image: Float32Array;
  /** The same in the colour box. */
  place: Float32Array;
  /** The source in the target's pose, in the target's coordinates; `image` if not registered. */
  registered: Float32Array;
  registeredNormal: Float32Array;
  isRegistered: boolean;
  dIso: Float32Array;
  error: Float32Array | null;
  /** How sure the points of both shapes' vertices are, in [0, 1]. */
  confidence: Record<Side, Float32Array> | null;
}

export interface Level {
  source: Uint32Array;
  target: Uint32Array;
  dIso: Float32Array;
}

/** A point of the file in the viewer's coordinates. */
type Placing = { rotation: number[]; centre: Triple; scale: number };

const NOT_MEASURED = 65535;
const NO_SHARE = 255;

function decodePoints(steps: Uint32Array, box: Box): Float32Array {
  const count = steps.length / 3;
  const points = new Float32Array(steps.length);
  for (let k = 0; k < 3; ++k) {
    const unit = box.size[k]! / 65535;
    for (let v = 0; v < count; ++v) points[3 * v + k] = box.low[k]! + unit * steps[k * count + v]!;
  }
  return points;
}

function decodeDistances(steps: Uint32Array, largest: number): Float32Array {
  const distances = new Float32Array(steps.length);
  for (let v = 0; v < steps.length; ++v)
    distances[v] = steps[v] === NOT_MEASURED ? NaN : (steps[v]! / 65534) * largest;
  return distances;
}

const decodeShares = (steps: Uint32Array): Float32Array =>
  Float32Array.from(steps, (step) => (step === NO_SHARE ? NaN : step / 254));

const decodeIndices = (plusOne: Uint32Array): Int32Array =>
  Int32Array.from(plusOne, (value) => value - 1);

function decodeFaces(arrays: Arrays, side: Side): Uint32Array {
  const corner = [0, 1, 2].map((k) => arrays(`${side}/corner${k}`));
  const faces = new Uint32Array(3 * corner[0]!.length);
  for (let f = 0; f < corner[0]!.length; ++f) {
    const first = corner[0]![f]!;
    faces[3 * f] = first;
    faces[3 * f + 1] = first + unzigzag(corner[1]![f]!);
    faces[3 * f + 2] = first + unzigzag(corner[2]![f]!);
  }
  return faces;
}

function rotate(rotation: number[], points: Float32Array): Float32Array {
  const rotated = new Float32Array(points.length);
  for (let i = 0; i < points.length; i += 3) {
    for (let k = 0; k < 3; ++k)
      rotated[i + k] =
        rotation[3 * k]! * points[i]! +
        rotation[3 * k + 1]! * points[i + 1]! +
        rotation[3 * k + 2]! * points[i + 2]!;
  }
  return rotated;
}

function middle(points: Float32Array): Triple {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; ++i) {
    low[i % 3] = Math.min(low[i % 3]!, points[i]!);
    high[i % 3] = Math.max(high[i % 3]!, points[i]!);
  }
  return [0, 1, 2].map((k) => (low[k]! + high[k]!) / 2) as Triple;
}

function place(placing: Placing, points: Float32Array): Float32Array {
  const placed = rotate(placing.rotation, points);
  for (let i = 0; i < placed.length; ++i)
    placed[i] = (placed[i]! - placing.centre[i % 3]!) * placing.scale;
  return placed;
}

/** Everything that the page shows. Maps and levels are decoded when they are first asked for. */
export class Result {
  readonly source: Shape;
  readonly target: Shape;
  private readonly targetPlacing: Placing;
  private readonly maps = new Map<number, ShapeMap>();
  private readonly levels = new Map<number, Level>();

  constructor(
    readonly manifest: Manifest,
    private readonly arrays: Arrays,
  ) {
    const source = this.decodeShape('source', manifest.source);
    const target = this.decodeShape('target', manifest.target);
    this.source = source.shape;
    this.target = target.shape;
    this.target.place = this.inColorBox(target.points);
    this.targetPlacing = target.placing;
  }

  get numMaps(): number {
    return this.manifest.maps.length;
  }

  get numLevels(): number {
    return this.manifest.levels.length;
  }

  shape(side: Side): Shape {
    return side === 'source' ? this.source : this.target;
  }

  map(index: number): ShapeMap {
    let map = this.maps.get(index);
    if (!map) this.maps.set(index, (map = this.decodeMap(index)));
    return map;
  }

  level(index: number): Level {
    let level = this.levels.get(index);
    if (!level) {
      const entry = this.manifest.levels[index]!;
      level = {
        source: this.arrays(`levels/${index}/source`),
        target: this.arrays(`levels/${index}/target`),
        dIso: decodeDistances(this.arrays(`levels/${index}/d_iso`), entry.d_iso_max),
      };
      this.levels.set(index, level);
    }
    return level;
  }

  private decodeShape(side: Side, entry: ShapeEntry) {
    const points = decodePoints(this.arrays(`${side}/position`), entry);
    const rotation = entry.view.flat();
    const placing: Placing = {
      rotation,
      centre: middle(rotate(rotation, points)),
      scale: 1 / Math.sqrt(entry.area || 1),
    };
    const position = place(placing, points);
    const faces = decodeFaces(this.arrays, side);
    const shape: Shape = {
      count: entry.vertices,
      position,
      normal: vertexNormals(position, faces),
      faces,
      numbers: this.arrays(`${side}/numbers`),
    };
    return { shape, points, placing };
  }

  private inColorBox(points: Float32Array): Float32Array {
    const { axes, low, size } = this.manifest.colors;
    const places = rotate(axes.flat(), points);
    for (let i = 0; i < places.length; ++i) places[i] = (places[i]! - low[i % 3]!) / size[i % 3]!;
    return places;
  }

  private decodeMap(index: number): ShapeMap {
    const entry = this.manifest.maps[index]!;
    const array = (name: string) => this.arrays(`maps/${index}/${name}`);
    const points = decodePoints(array('image'), entry.image);
    const image = place(this.targetPlacing, points);
    const registered = entry.registered
      ? place(this.targetPlacing, decodePoints(array('registered'), entry.registered))
      : image;
    return {
      partner: decodeIndices(array('partner')),
      back: decodeIndices(array('back')),
      image,
      place: this.inColorBox(points),
      registered,
      registeredNormal: vertexNormals(registered, this.source.faces),
      isRegistered: entry.registered !== undefined,
      dIso: decodeDistances(array('d_iso'), entry.d_iso_max),
      error:
        entry.error_max === undefined ? null : decodeDistances(array('error'), entry.error_max),
      confidence: entry.confidence
        ? {
            source: decodeShares(array('source_confidence')),
            target: decodeShares(array('target_confidence')),
          }
        : null,
    };
  }
}
