// SPDX-License-Identifier: BSD-3-Clause
// Channel frequency classes of SAE J211-1, appendix C: a two-pole Butterworth filter run forwards and backwards,
// which makes it one of four poles without phase.

export interface Coefficients {
  a0: number;
  a1: number;
  a2: number;
  b1: number;
  b2: number;
}

/** `interval` between samples [s]. */
export function coefficients(cfc: number, interval: number): Coefficients {
  const wd = 2 * Math.PI * cfc * 2.0775;
  const wa = Math.tan((wd * interval) / 2);
  const base = 1 + Math.SQRT2 * wa + wa * wa;
  const a0 = (wa * wa) / base;
  return { a0, a1: 2 * a0, a2: a0, b1: (-2 * (wa * wa - 1)) / base, b2: (-1 + Math.SQRT2 * wa - wa * wa) / base };
}

/** Samples per second must be ten times the class's frequency at least (the standard's rule); below twice the
 * filter's own corner frequency there is nothing to compute. */
export function canFilter(cfc: number, interval: number): boolean {
  return interval > 0 && cfc * 2.0775 * interval < 0.25;
}

function pass(values: Float64Array, c: Coefficients): Float64Array {
  const out = new Float64Array(values.length);
  // As if the first value had always been there.
  let x1 = values[0];
  let x2 = values[0];
  let y1 = values[0];
  let y2 = values[0];
  for (let i = 0; i < values.length; ++i) {
    const x = values[i];
    const y = c.a0 * x + c.a1 * x1 + c.a2 * x2 + c.b1 * y1 + c.b2 * y2;
    out[i] = y;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
  }
  return out;
}

/** Filters evenly spaced samples. The ends are continued by point reflection for a while, so that the filter
 * does not start and stop abruptly. */
export function filtered(values: Float64Array, cfc: number, interval: number): Float64Array {
  if (values.length < 3 || !canFilter(cfc, interval)) return values.slice();
  const c = coefficients(cfc, interval);
  const wanted = Math.ceil(2 / (cfc * 2.0775 * interval)); // two periods of the corner frequency
  const margin = Math.min(values.length - 1, Math.max(10, wanted));
  const last = values.length - 1;
  const long = new Float64Array(values.length + 2 * margin);
  long.set(values, margin);
  for (let i = 1; i <= margin; ++i) {
    long[margin - i] = 2 * values[0] - values[i];
    long[margin + last + i] = 2 * values[last] - values[last - i];
  }
  const there = pass(long, c).reverse();
  return pass(there, c).reverse().slice(margin, margin + values.length);
}

/** Values at even steps between the first and the last time, by straight lines; as many as there were. */
export function evenly(times: Float64Array, values: Float64Array): { times: Float64Array; values: Float64Array } {
  const count = times.length;
  const out = { times: new Float64Array(count), values: new Float64Array(count) };
  const step = count > 1 ? (times[count - 1] - times[0]) / (count - 1) : 0;
  let left = 0;
  for (let i = 0; i < count; ++i) {
    const time = i === count - 1 ? times[count - 1] : times[0] + i * step;
    while (left < count - 2 && times[left + 1] < time) ++left;
    const width = times[left + 1] - times[left];
    const share = width > 0 ? (time - times[left]) / width : 0;
    out.times[i] = time;
    out.values[i] = count > 1 ? values[left] + share * (values[left + 1] - values[left]) : values[i];
  }
  return out;
}
