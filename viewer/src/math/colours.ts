// SPDX-License-Identifier: BSD-3-Clause

export type Rgb = [number, number, number];

// Turbo (A. Mikhailov, 2019): polynomial fit of its authors, 0..1.
const red = [0.13572138, 4.6153926, -42.66032258, 132.13108234, -152.94239396, 59.28637943];
const green = [0.09140261, 2.19418839, 4.84296658, -14.18503333, 4.27729857, 2.82956604];
const blue = [0.1066733, 12.64194608, -60.58204836, 110.36276771, -89.90310912, 27.34824973];

function polynomial(c: number[], x: number): number {
  let sum = 0;
  for (let i = c.length - 1; i >= 0; --i) sum = sum * x + c[i];
  return Math.min(1, Math.max(0, sum));
}

/** Colour of a fringe at 0..1. The darkest ends of the map are left out: edges are drawn over it. */
export function fringe(x: number): Rgb {
  const t = 0.09 + 0.86 * Math.min(1, Math.max(0, x));
  return [polynomial(red, t), polynomial(green, t), polynomial(blue, t)];
}

/** RGBA bytes of the fringe in equal bands, or continuous with `bands` 0. */
export function fringeTable(bands: number, size = 256): Uint8Array {
  const table = new Uint8Array(4 * size);
  for (let i = 0; i < size; ++i) {
    const x = bands > 1 ? Math.min(bands - 1, Math.floor((i / size) * bands)) / (bands - 1) : i / (size - 1);
    const colour = fringe(x);
    for (let c = 0; c < 3; ++c) table[4 * i + c] = Math.round(255 * colour[c]);
    table[4 * i + 3] = 255;
  }
  return table;
}

// Twelve hues that stay apart from each other on light and dark ground (after P. Tol's and Tableau's sets, muted).
const palette: Rgb[] = [
  "5b8db8", "d98e4a", "6aa56b", "c26a6a", "9079b0", "a58062", "cf8fb4", "8c969e", "b9b15a", "5fb0b5", "8a6f3c", "6d83c9",
].map((hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255) as Rgb);

export function partColour(place: number): Rgb {
  const base = palette[place % palette.length];
  const round = Math.floor(place / palette.length) % 3;
  const factor = [1, 0.75, 1.2][round];
  return base.map((c) => Math.min(1, c * factor)) as Rgb;
}

export function css(colour: Rgb): string {
  return `rgb(${colour.map((c) => Math.round(255 * c)).join(" ")})`;
}
