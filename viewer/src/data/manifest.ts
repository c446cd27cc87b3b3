/** What `isomatch report` writes into the page; see results/page/page_data.h. */

export type Triple = [number, number, number];

/** 16-bit steps of a box in the file's units. */
export interface Box {
  low: Triple;
  size: Triple;
}

/** A place lies at `(axes * point - low) / size`. */
export interface ColorBox extends Box {
  axes: [Triple, Triple, Triple];
}

export interface ShapeEntry extends Box {
  vertices: number;
  faces: number;
  vertices_given: number;
  simplified: boolean;
  area: number;
  /** Rows point right, up and towards the viewer. */
  view: [Triple, Triple, Triple];
}

export interface MapEntry {
  folder: string;
  image: Box;
  registered?: Box;
  d_iso_max: number;
  error_max?: number;
  /** Whether the method tells how sure it is. */
  confidence: boolean;
}

export interface LevelEntry {
  matches: number;
  d_iso_max: number;
}

export interface ArrayEntry {
  name: string;
  count: number;
  bytes: number;
  planes: number;
  delta: boolean;
}

export interface MeshReport {
  file: string;
  vertices: number;
  faces: number;
  warnings?: string[];
}

/** Whether a map can be trusted, see docs/verdict.md. */
export interface Fit {
  grade: 'good' | 'doubtful' | 'poor';
  reasons: string[];
}

/** The parts of report.json that the page knows; it shows the others as they are. */
export interface Report {
  isomatch?: string;
  command?: string[];
  working_folder?: string;
  options: { method: string } & Record<string, unknown>;
  source: MeshReport;
  target: MeshReport;
  source_vertices_matched?: number;
  source_vertices_unmatched?: number;
  /** Of results of older versions there is none. */
  fit?: Fit;
  ambiguity?: number;
  ambiguous?: boolean;
  contradicted_landmarks?: [number, number][];
  oriented?: boolean;
  complete?: boolean;
  alternatives?: { folder: string; energy: number; distortion: number; fit?: Fit }[];
  map?: { energy: number; distortion: number };
  hypotheses?: { distortion: number; orientation: number; coarse_energy: number }[];
  seconds?: Record<string, number>;
  peak_memory_mib?: number;
}

export interface Manifest {
  format: number;
  report: Report;
  folder: string;
  source: ShapeEntry;
  target: ShapeEntry;
  colors: ColorBox;
  truth: { source: string; target: string } | null;
  maps: MapEntry[];
  levels: LevelEntry[];
  arrays: ArrayEntry[];
}
