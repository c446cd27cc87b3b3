import { vertexNormals } from '../geometry/normals';
import type { Arrays } from './arrays';
import { decodeDistances, decodeFaces, decodeIndices, decodePoints, decodeShares } from './decode';
import type { Manifest, ShapeEntry } from './manifest';
import { inColorBox, place, type Placing, placingOf } from './placing';
import type { Shape } from './shape';

export type Side = 'source' | 'target';

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
    this.target.place = inColorBox(target.points, manifest.colors);
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
    const placing = placingOf(points, entry.view, entry.area);
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
      place: inColorBox(points, this.manifest.colors),
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
