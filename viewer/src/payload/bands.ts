// SPDX-License-Identifier: BSD-3-Clause
import { interpolate } from "../math/numbers";
import { parseHistory, splitBy } from "./history";

/** Range of a curve over the runs of `crumple scatter`. */
export interface Band {
  times: Float64Array;
  median: Float64Array;
  /** 5th percentile */
  low: Float64Array;
  /** 95th percentile */
  high: Float64Array;
}

/** A band at the times of a chart; null where it has not begun or has ended. */
export interface SampledBand {
  median: (number | null)[];
  low: (number | null)[];
  high: (number | null)[];
}

/** Bands by the names of their curves. */
export function parseBands(csv: string): Map<string, Band> {
  const bands = new Map<string, Band>();
  for (const [curve, { number }] of splitBy(parseHistory(csv), ["curve"]))
    bands.set(curve, { times: number["time"], median: number["median"], low: number["p5"], high: number["p95"] });
  return bands;
}

export function sampledBand(band: Band, times: ArrayLike<number>): SampledBand {
  const { times: own } = band;
  const along = (values: Float64Array) =>
    Array.from(times, (time) => (time < own[0] || time > own[own.length - 1] ? null : interpolate(own, values, time)));
  return { median: along(band.median), low: along(band.low), high: along(band.high) };
}
