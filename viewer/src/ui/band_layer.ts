// SPDX-License-Identifier: BSD-3-Clause
import type uPlot from "uplot";
import type { SampledBand } from "../payload/bands";

type Bounds = [low: number | null, high: number | null];

/** The bounds, widened so that the bands are between them where `x` is within `window`. */
export function boundsWithBands(bounds: Bounds, bands: SampledBand[], x: ArrayLike<number>, window: [number, number]): Bounds {
  let [low, high] = bounds;
  for (const band of bands)
    for (let i = 0; i < x.length; ++i) {
      const [bottom, top] = [band.low[i], band.high[i]];
      if (bottom === null || top === null || x[i] < window[0] || x[i] > window[1]) continue;
      if (low === null || bottom < low) low = bottom;
      if (high === null || top > high) high = top;
    }
  return [low, high];
}

/** Draws a band as a translucent area with a dashed median, within the axes. */
export function drawBand(plot: uPlot, x: ArrayLike<number>, band: SampledBand, hue: string): void {
  const places = band.low.flatMap((value, i) => (value === null ? [] : [i]));
  if (places.length === 0) return;
  const context = plot.ctx;
  const line = (values: (number | null)[], order: number[]) =>
    order.forEach((i) => context.lineTo(plot.valToPos(x[i], "x", true), plot.valToPos(values[i]!, "y", true)));
  context.save();
  context.beginPath();
  context.rect(plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height);
  context.clip();
  context.beginPath();
  line(band.low, places);
  line(band.high, [...places].reverse());
  context.closePath();
  context.fillStyle = `${hue}40`;
  context.fill();
  context.beginPath();
  line(band.median, places);
  context.strokeStyle = hue;
  context.lineWidth = 1.2 * window.devicePixelRatio;
  context.setLineDash([4, 3].map((size) => size * window.devicePixelRatio));
  context.stroke();
  context.restore();
}
