// SPDX-License-Identifier: BSD-3-Clause
// What `crumple report` writes about a run (crumple/report/payload.cpp).

export interface FieldMeta {
  name: string;
  by_node: boolean;
  bits: 8 | 16;
  low: number;
  high: number;
}

export interface WallsMeta {
  /** x, y, z of every point at time zero [length] */
  points: number[];
  /** points around each face */
  faces: number[][];
  /** id of the wall of each face */
  wall: number[];
  /** by id: x, y, z of its displacement in every frame [length] */
  motion: Record<string, number[]>;
}

export interface Check {
  name: string;
  value: number | null;
  limit: number | null;
  pass: boolean;
  source: string;
  source_limit: number | null;
}

export interface PlaneWall {
  id: number;
  point: number[];
  normal: number[];
}

/** Neighbouring elements that have gained or lost energy without motion. */
export interface WorstElements {
  part: number;
  kind: string;
  first: number;
  last: number;
  elements: number;
  residual: number | null;
  fastest_node: number;
  speed: number | null;
  place: (number | null)[];
}

/** What --trace-energy leaves in run.json, as far as the page shows it. */
export interface EnergyTrace {
  worst_elements: WorstElements[];
}

/** run.json; a name may be missing in results of an older program. */
export interface RunRecord {
  version?: string;
  deck?: string;
  title?: string;
  units?: string;
  termination?: string;
  reason?: string;
  end_time?: number;
  cycles?: number;
  nodes?: number;
  elements?: Record<string, number>;
  threads?: number;
  precision?: string;
  isa?: string;
  search?: string;
  wall_seconds?: number;
  loop_seconds?: number;
  ns_per_element_cycle?: number;
  peak_memory_bytes?: number;
  energy?: Record<string, number | null>;
  added_mass?: number;
  energy_trace?: EnergyTrace | null;
  state_hash?: string;
  timings?: Record<string, number>;
  contact?: Record<string, unknown>[];
  checks?: Check[];
  warnings?: string[];
  /** what of the deck did not take part */
  left_out?: { name: string; reason: string; count: number; place: string }[];
  parts?: { id: number; title: string }[];
  plane_walls?: PlaneWall[];
}

/** The runs of `crumple scatter` of which the run that is shown is the unperturbed one. */
export interface ScatterMeta {
  /** that ended normally */
  runs: number;
  /** largest move of a node over the diagonal of the model; null if no record tells */
  perturbation: number | null;
  /** histories with bands, by what the names of their curves begin with; of so many points one was kept */
  histories: { name: string; every: number }[];
}

export interface Meta {
  format: number;
  name: string;
  run: RunRecord | null;
  times: number[];
  model: { nodes: number; cells: number };
  nodes: number;
  cells: number;
  faces: number;
  lines: number;
  box: { low: number[]; high: number[] };
  fields: FieldMeta[];
  walls: WallsMeta | null;
  tables: { name: string; every: number }[];
  scatter: ScatterMeta | null;
}
