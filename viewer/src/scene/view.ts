import { Matrix4, PerspectiveCamera, Scene, Vector3 } from 'three';
import type { Extent } from './extent';
import { Orbit } from './orbit';
import type { Surface } from './surface';

/** In CSS pixels, from the canvas's top left. */
export interface Rectangle {
  x: number;
  y: number;
  width: number;
  height: number;
}

export interface ScreenPoint {
  x: number;
  y: number;
  /** Whether the surface faces the viewer there. */
  facing: boolean;
}

/** One of the places on the canvas in which shapes are seen. */
export class View {
  readonly camera = new PerspectiveCamera();
  readonly orbit = new Orbit();
  readonly scene = new Scene();
  rectangle: Rectangle = { x: 0, y: 0, width: 1, height: 1 };

  contains(x: number, y: number): boolean {
    const { rectangle: r } = this;
    return x >= r.x && y >= r.y && x < r.x + r.width && y < r.y + r.height;
  }

  aim(orbit: Orbit, extent: Extent): void {
    const aspect = this.rectangle.width / this.rectangle.height;
    orbit.aim(this.camera, aspect, extent.distance(aspect));
  }

  private matrix(): Matrix4 {
    return new Matrix4().multiplyMatrices(
      this.camera.projectionMatrix,
      this.camera.matrixWorldInverse,
    );
  }

  project(surface: Surface, vertex: number): ScreenPoint {
    const at = (get: (v: number, k: number) => number) =>
      new Vector3(get(vertex, 0), get(vertex, 1), get(vertex, 2));
    const point = at((v, k) => surface.coordinate(v, k));
    const normal = at((v, k) => surface.normalComponent(v, k));
    const facing = normal.dot(this.camera.position.clone().sub(point)) >= 0;
    point.applyMatrix4(this.matrix());
    const { x, y, width, height } = this.rectangle;
    return {
      x: x + ((point.x + 1) / 2) * width,
      y: y + ((1 - point.y) / 2) * height,
      facing,
    };
  }

  /** The vertex nearest to a place on the canvas among those in front, -1 if none is near. */
  pick(surface: Surface, x: number, y: number): number {
    for (const radius of [7, 25]) {
      const vertex = this.pickWithin(surface, x, y, radius);
      if (vertex >= 0) return vertex;
    }
    return -1;
  }

  private pickWithin(surface: Surface, x: number, y: number, radius: number): number {
    const m = this.matrix().elements;
    const { x: left, y: top, width, height } = this.rectangle;
    const near: { vertex: number; distance: number; depth: number }[] = [];
    let front = Infinity;
    for (let v = 0; v < surface.count; ++v) {
      const px = surface.coordinate(v, 0);
      const py = surface.coordinate(v, 1);
      const pz = surface.coordinate(v, 2);
      const w = m[3]! * px + m[7]! * py + m[11]! * pz + m[15]!;
      const sx = left + (((m[0]! * px + m[4]! * py + m[8]! * pz + m[12]!) / w + 1) / 2) * width;
      const sy = top + ((1 - (m[1]! * px + m[5]! * py + m[9]! * pz + m[13]!) / w) / 2) * height;
      const distance = Math.hypot(sx - x, sy - y);
      if (w <= 0 || distance > radius) continue;
      // w is the distance from the viewer in the shape's unit.
      near.push({ vertex: v, distance, depth: w });
      front = Math.min(front, w);
    }
    // What lies much farther back than the nearest is hidden by it.
    const BEHIND = 0.08;
    let best = -1;
    let least = Infinity;
    for (const { vertex, distance, depth } of near) {
      if (depth > front + BEHIND || distance >= least) continue;
      least = distance;
      best = vertex;
    }
    return best;
  }
}
