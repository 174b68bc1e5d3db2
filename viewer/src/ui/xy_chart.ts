// SPDX-License-Identifier: BSD-3-Clause
import uPlot from "uplot";
import { axisRange, ticks } from "../math/numbers";
import { axisSize, hues } from "./charts";
import { FittedPlot } from "./fitted_plot";

export interface XyData {
  xLabel: string;
  yLabel: string;
  curves: { label: string; x: Float64Array; y: Float64Array }[];
}

/** Curves of one quantity over another, which may turn back. */
export class XyChart extends FittedPlot<XyData> {
  protected rebuild(): void {
    this.plot?.destroy();
    this.plot = null;
    const data = this.data;
    if (!data || data.curves.length === 0) return;
    const grid = { stroke: this.themes.colour("grid"), width: 1 };
    const axis = {
      stroke: this.themes.colour("muted"),
      grid,
      ticks: { ...grid, size: 4 },
      font: "11px system-ui, sans-serif",
      labelFont: "11px system-ui, sans-serif",
      values: (_: uPlot, places: number[]) => ticks(places),
    };
    const draw: uPlot.Series.PathBuilder = (plot, place) => {
      const curve = data.curves[place - 1];
      const context = plot.ctx;
      context.save();
      context.beginPath();
      context.rect(plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height);
      context.clip();
      context.beginPath();
      curve.x.forEach((x, i) => {
        const at: [number, number] = [plot.valToPos(x, "x", true), plot.valToPos(curve.y[i], "y", true)];
        if (i === 0) context.moveTo(...at);
        else context.lineTo(...at);
      });
      context.strokeStyle = hues[(place - 1) % hues.length];
      context.lineWidth = 1.5 * window.devicePixelRatio;
      context.stroke();
      context.restore();
      return null;
    };
    const options: uPlot.Options = {
      mode: 2,
      width: Math.max(120, this.host.clientWidth),
      height: this.height,
      scales: { x: { time: false, range: (_: uPlot, low: number, high: number) => axisRange(low, high) }, y: { range: (_: uPlot, low: number, high: number) => axisRange(low, high) } },
      legend: { live: false },
      cursor: { drag: { x: true, y: false } },
      axes: [
        { ...axis, size: 30, label: data.xLabel, labelSize: 14 },
        { ...axis, size: axisSize },
      ],
      series: [
        {},
        ...data.curves.map((curve, i): uPlot.Series => ({
          label: curve.label,
          stroke: hues[i % hues.length],
          facets: [
            { scale: "x", auto: true },
            { scale: "y", auto: true },
          ],
          paths: draw,
        })),
      ],
    };
    const columns = [null, ...data.curves.map((curve) => [curve.x, curve.y])];
    this.plot = new uPlot(options, columns as unknown as uPlot.AlignedData, this.host);
  }
}
