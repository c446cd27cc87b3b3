import { type Arrays, unzigzag } from './arrays';
import type { Box } from './manifest';

/** The way back from results/page/packed_geometry.h. */

const NOT_MEASURED = 65535;
const NO_SHARE = 255;

export function decodePoints(steps: Uint32Array, box: Box): Float32Array {
  const count = steps.length / 3;
  const points = new Float32Array(steps.length);
  for (let k = 0; k < 3; ++k) {
    const unit = box.size[k]! / 65535;
    for (let v = 0; v < count; ++v) points[3 * v + k] = box.low[k]! + unit * steps[k * count + v]!;
  }
  return points;
}

export function decodeDistances(steps: Uint32Array, largest: number): Float32Array {
  const distances = new Float32Array(steps.length);
  for (let v = 0; v < steps.length; ++v)
    distances[v] = steps[v] === NOT_MEASURED ? NaN : (steps[v]! / 65534) * largest;
  return distances;
}

export const decodeShares = (steps: Uint32Array): Float32Array =>
  Float32Array.from(steps, (step) => (step === NO_SHARE ? NaN : step / 254));

export const decodeIndices = (plusOne: Uint32Array): Int32Array =>
  Int32Array.from(plusOne, (value) => value - 1);

export function decodeFaces(arrays: Arrays, name: string): Uint32Array {
  const corner = [0, 1, 2].map((k) => arrays(`${name}/corner${k}`));
  const faces = new Uint32Array(3 * corner[0]!.length);
  for (let f = 0; f < corner[0]!.length; ++f) {
    const first = corner[0]![f]!;
    faces[3 * f] = first;
    faces[3 * f + 1] = first + unzigzag(corner[1]![f]!);
    faces[3 * f + 2] = first + unzigzag(corner[2]![f]!);
  }
  return faces;
}
