// SPDX-License-Identifier: BSD-3-Clause
import uPlot from "uplot";
import { axisRange, short, ticks } from "../math/numbers";
import { h } from "./dom";
import { FittedPlot } from "./fitted_plot";
import type { Themes } from "./theme";

export interface Curve {
  label: string;
  values: ArrayLike<number>;
  shown?: boolean;
  dash?: number[];
}

export interface ChartData {
  xLabel: string;
  x: ArrayLike<number>;
  curves: Curve[];
}

export const hues = ["#3f7fbf", "#d9822b", "#3f9b5a", "#c24d4d", "#8a66b8", "#8c6a4f", "#c877a8", "#7a858f", "#a8a032", "#3fa3a8", "#b0892f"];

/** Room for the longest number of an axis [px]. */
export function axisSize(_: uPlot, texts: string[] | null): number {
  return 16 + 6.4 * Math.max(3, ...(texts ?? []).map((text) => text.length));
}

/** A chart that follows its box's width, the theme and the moment of the animation. */
export class Chart extends FittedPlot<ChartData> {
  private moment = -Infinity;
  private readonly marker = h("div", { class: "moment" });
  /** series that the user has switched, by label */
  readonly switched = new Map<string, boolean>();

  constructor(
    host: HTMLElement,
    height: number,
    themes: Themes,
    private readonly onSeek: ((time: number) => void) | null,
  ) {
    super(host, height, themes);
  }

  setSwitched(series: [string, boolean][]): void {
    if (series.length === 0) return;
    for (const [label, shown] of series) this.switched.set(label, shown);
    this.rebuild();
  }

  /** Puts a line at this time. It lies over the chart, which need not be drawn anew while the animation plays. */
  setMoment(time: number): void {
    this.moment = time;
    this.placeMoment();
  }

  protected rebuild(): void {
    this.plot?.destroy();
    this.plot = null;
    const data = this.data;
    if (!data || data.x.length === 0) return;
    const ink = this.themes.colour("muted");
    const grid = { stroke: this.themes.colour("grid"), width: 1 };
    const axis = { stroke: ink, grid, ticks: { ...grid, size: 4 }, font: "11px system-ui, sans-serif" };
    const values = (_: uPlot, places: number[]) => ticks(places);
    const legendValue = (_: uPlot, value: number | null) => (value === null ? "–" : short(value));
    const options: uPlot.Options = {
      width: Math.max(120, this.host.clientWidth),
      height: this.height,
      pxAlign: 1,
      scales: { x: { time: false }, y: { range: (_: uPlot, low: number, high: number) => axisRange(low, high) } },
      legend: { live: true },
      cursor: { drag: { x: true, y: false }, points: { size: 5 } },
      axes: [
        { ...axis, values, size: 30, label: data.xLabel, labelSize: 14, labelFont: "11px system-ui, sans-serif" },
        { ...axis, values, size: axisSize },
      ],
      series: [
        { label: data.xLabel, value: legendValue },
        ...data.curves.map((curve, i): uPlot.Series => ({
          label: curve.label,
          stroke: hues[i % hues.length],
          width: 1.5,
          value: legendValue,
          show: this.switched.get(curve.label) ?? curve.shown ?? true,
          points: { show: data.x.length < 2 },
          ...(curve.dash ? { dash: curve.dash } : {}),
        })),
      ],
      hooks: {
        setSeries: [
          (plot, place, change) => {
            if (place !== null && change.show !== undefined) {
              const label = plot.series[place]?.label;
              if (typeof label === "string") this.switched.set(label, plot.series[place].show ?? true);
            }
          },
        ],
        draw: [() => this.placeMoment()],
        ready: [(plot) => this.listen(plot)],
      },
    };
    const columns = [data.x, ...data.curves.map((curve) => curve.values)] as unknown as uPlot.AlignedData;
    this.plot = new uPlot(options, columns, this.host);
  }

  private listen(plot: uPlot): void {
    plot.over.append(this.marker);
    if (!this.onSeek) return;
    plot.over.addEventListener("click", (event) => {
      // A drag has zoomed.
      if (plot.select.width > 2) return;
      this.onSeek!(plot.posToVal(event.offsetX, "x"));
    });
  }

  private placeMoment(): void {
    const plot = this.plot;
    if (!plot) return;
    const x = plot.valToPos(this.moment, "x");
    const seen = x >= 0 && x <= plot.over.clientWidth;
    this.marker.style.transform = `translateX(${seen ? x : -10}px)`;
  }
}
