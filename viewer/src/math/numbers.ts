// SPDX-License-Identifier: BSD-3-Clause

/** A number as tables and legends show it: four digits, no exponent where none is needed. */
export function short(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) return `${value < 0 ? "−" : ""}${Number(Math.abs(value).toPrecision(digits)).toExponential().replace("e+", "e")}`;
  return String(Number(value.toPrecision(digits))).replace(/^-/, "−");
}

/** Numbers of an axis, with as many digits as it takes to tell neighbours apart. */
export function ticks(values: number[]): string[] {
  const step = values.length > 1 ? Math.abs(values[1] - values[0]) : 0;
  const most = values.reduce((a, b) => Math.max(a, Math.abs(b)), 0);
  if (step === 0 || most === 0) return values.map((value) => short(value));
  const digits = Math.min(12, Math.max(2, Math.ceil(Math.log10(most / step)) + 2));
  return values.map((value) => short(Math.abs(value) < 1e-6 * step ? 0 : value, digits));
}

/** Bounds of an axis: a little more than the values take, and never so little that rounding shows. */
export function axisRange(low: number | null, high: number | null): [number, number] {
  if (low === null || high === null || !Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (size === 0) return [-1, 1];
  const least = 1e-6 * size;
  const middle = 0.5 * (low + high);
  const half = Math.max(0.53 * (high - low), least);
  // A curve that starts from zero and stays on one side of it has the axis as its ground.
  if (low === 0) return [0, middle + half];
  if (high === 0) return [middle - half, 0];
  return [middle - half, middle + half];
}

/** Linear interpolation in a table with ascending abscissae; constant beyond its ends. */
export function interpolate(xs: ArrayLike<number>, ys: ArrayLike<number>, x: number): number {
  let low = 0;
  let high = xs.length - 1;
  if (high < 0) return NaN;
  if (x <= xs[low]) return ys[low];
  if (x >= xs[high]) return ys[high];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (xs[middle] <= x) low = middle;
    else high = middle;
  }
  return ys[low] + ((x - xs[low]) / (xs[high] - xs[low])) * (ys[high] - ys[low]);
}

const titles: Record<string, string> = { dt: "Step", rigidwall: "Rigid wall", von_mises: "Von Mises stress", von_mises_mid: "Von Mises at middle" };

/** What a name of a field or column is called in headings. */
export function title(name: string): string {
  const words = name.replace(/_/g, " ");
  return titles[name] ?? words.charAt(0).toUpperCase() + words.slice(1);
}
