// SPDX-License-Identifier: BSD-3-Clause
import { canFilter, evenly, filtered } from "../math/filter";
import { curveName, splitBy, type History } from "./history";

export interface Force {
  label: string;
  /** by which its band is found */
  curve: string;
  times: Float64Array;
  values: Float64Array;
}

/** Normal forces of the walls, as recorded. */
export function wallForces(history: History): Force[] {
  return [...splitBy(history, ["wall"])].map(([wall, rows]) => ({
    label: `wall ${wall}`,
    curve: curveName(rows, "normal"),
    times: rows.number["time"],
    values: rows.number["normal"],
  }));
}

/** Size of the resultants on the interfaces. The second side has the force of the first turned round, and a
 * surface in contact with itself has none: both are left out. */
export function contactForces(history: History): Force[] {
  const forces: Force[] = [];
  for (const [item, rows] of splitBy(history, ["interface", "side"])) {
    const [id, side] = item.split(" ");
    if (side === "second" || side === "single") continue;
    const { fx, fy, fz } = rows.number;
    forces.push({
      label: side === "transducer" ? `transducer ${id}` : `contact ${id}`,
      curve: curveName(rows, "resultant"),
      times: rows.number["time"],
      values: fx.map((x, i) => Math.hypot(x, fy[i], fz[i])),
    });
  }
  return forces;
}

export interface Filtering {
  /** 0 is none */
  cfc: number;
  /** seconds that one unit of time of the deck is */
  secondsPerUnit: number;
}

/** Samples per second of a history, on the average. */
export function sampleRate(times: Float64Array, secondsPerUnit: number): number {
  const span = (times[times.length - 1] - times[0]) * secondsPerUnit;
  return span > 0 ? (times.length - 1) / span : 0;
}

/** The force through the filter, at even times; as it is where the class asks for finer samples. */
export function filteredForce(force: Force, filtering: Filtering): Force {
  const interval = 1 / sampleRate(force.times, filtering.secondsPerUnit);
  if (filtering.cfc === 0 || !canFilter(filtering.cfc, interval)) return force;
  const even = evenly(force.times, force.values);
  return { ...force, times: even.times, values: filtered(even.values, filtering.cfc, interval) };
}

/** Guess from the end time where the deck's units are not known: crashes take milliseconds. */
export function guessTimeUnit(units: string | undefined, endTime: number): "s" | "ms" | "us" {
  const named = /(\S+)\s*$/.exec(units ?? "")?.[1];
  if (named === "s" || named === "ms" || named === "us") return named;
  if (endTime > 5000) return "us";
  return endTime > 2 ? "ms" : "s";
}
