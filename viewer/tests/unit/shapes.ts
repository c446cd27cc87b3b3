import type { Shape } from '../../src/data/shape';
import { vertexNormals } from '../../src/geometry/normals';

export function shapeOf(position: number[], faces: number[]): Shape {
  const coordinates = Float32Array.from(position);
  const corners = Uint32Array.from(faces);
  return {
    count: position.length / 3,
    position: coordinates,
    normal: vertexNormals(coordinates, corners),
    faces: corners,
    numbers: Uint32Array.from({ length: position.length / 3 }, (_, v) => v),
  };
}

/** A flat grid in the plane z = 0, facing +z; vertex (i, j) is j (columns + 1) + i. */
export function sheet(columns: number, rows: number): Shape {
  const position: number[] = [];
  const faces: number[] = [];
  for (let j = 0; j <= rows; ++j) for (let i = 0; i <= columns; ++i) position.push(i, j, 0);
  for (let j = 0; j < rows; ++j) {
    for (let i = 0; i < columns; ++i) {
      const v = j * (columns + 1) + i;
      const above = v + columns + 1;
      faces.push(v, v + 1, above + 1, v, above + 1, above);
    }
  }
  return shapeOf(position, faces);
}

/** A sphere about the origin of `2 n` times `n` cells, without its poles. */
export function band(n: number, radius: number): Shape {
  const position: number[] = [];
  const faces: number[] = [];
  const columns = 2 * n;
  for (let j = 1; j < n; ++j) {
    for (let i = 0; i < columns; ++i) {
      const polar = (Math.PI * j) / n;
      const angle = (2 * Math.PI * i) / columns;
      position.push(
        radius * Math.sin(polar) * Math.cos(angle),
        radius * Math.cos(polar),
        -radius * Math.sin(polar) * Math.sin(angle),
      );
    }
  }
  for (let j = 0; j + 2 < n; ++j) {
    for (let i = 0; i < columns; ++i) {
      const v = j * columns + i;
      const right = j * columns + ((i + 1) % columns);
      faces.push(v, v + columns, right + columns, v, right + columns, right);
    }
  }
  return shapeOf(position, faces);
}
