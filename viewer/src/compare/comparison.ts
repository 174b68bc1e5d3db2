// SPDX-License-Identifier: BSD-3-Clause
import { interpolate, short } from "../math/numbers";

/** What crumple compare writes into the page; docs/compare.md has the meaning of the scores. */
export interface Comparison {
  reference: Side;
  other: Side;
  cfc: number | null;
  floor: number;
  tolerance?: number;
  curves: ComparedCurve[];
  not_rated: CurveDescription[];
  only_in_reference: string[];
  only_in_other: string[];
  notes: string[];
  /** points of the first curves of `curves` */
  drawn: { reference: Points; other: Points }[];
}

export interface Side {
  source: string;
  files: string[];
  curves: number;
  notes: string[];
}

export interface CurveDescription {
  name: string;
  other_name?: string;
  group: string;
  quantity: string;
  item: string;
  start: number;
  end: number;
  peak: number;
  difference: number;
  time: number;
  /** null if the reference is zero and the other is not */
  relative: number | null;
}

export interface ComparedCurve extends CurveDescription {
  samples: number;
  interval: number;
  sprague_geers: { magnitude: number | null; phase: number; combined: number | null };
  iso_18571: {
    corridor: number;
    phase: number;
    magnitude: number;
    slope: number;
    rating: number;
    grade: Grade;
    shift_samples: number;
  };
}

export type Grade = "excellent" | "good" | "fair" | "poor";
export const grades: Grade[] = ["excellent", "good", "fair", "poor"];

/** times and values */
export type Points = [number[], number[]];

/** Two curves at all times of both, as a chart wants them; null where a curve has not begun or has ended. */
export function together(first: Points, second: Points): { x: number[]; first: (number | null)[]; second: (number | null)[] } {
  const x = [...new Set([...first[0], ...second[0]])].sort((a, b) => a - b);
  const along = ([times, values]: Points) =>
    x.map((time) => (time < times[0] || time > times[times.length - 1] ? null : interpolate(times, values, time)));
  return { x, first: along(first), second: along(second) };
}

/** As a share of a hundred, or a factor where that is clearer. */
export function percent(share: number | null): string {
  if (share === null) return "ref. zero";
  return share >= 100 ? `× ${short(share, 3)}` : `${short(100 * share, 3)} %`;
}
