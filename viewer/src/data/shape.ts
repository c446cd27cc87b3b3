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
