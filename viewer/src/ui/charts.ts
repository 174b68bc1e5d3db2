// SPDX-License-Identifier: BSD-3-Clause
import uPlot from "uplot";
import { axisRange, short, ticks } from "../math/numbers";
import type { SampledBand } from "../payload/bands";
import { boundsWithBands, drawBand } from "./band_layer";
import { h } from "./dom";
import { FittedPlot } from "./fitted_plot";
import type { Themes } from "./theme";

export interface Curve {
  label: string;
  values: ArrayLike<number>;
  shown?: boolean;
  dash?: number[];
  /** over the runs of a scatter, at the chart's x */
  band?: SampledBand | undefined;
}

export interface ChartData {
  xLabel: string;
  x: ArrayLike<number>;
  curves: Curve[];
  /** what the bands are, for the legend */
  bandLabel?: string | undefined;
}

export const hues = ["#3f7fbf", "#d9822b", "#3f9b5a", "#c24d4d", "#8a66b8", "#8c6a4f", "#c877a8", "#7a858f", "#a8a032", "#3fa3a8", "#b0892f"];

function hueOf(place: number): string {
  return hues[place % hues.length];
}

/** Room for the longest number of an axis [px]. */
export function axisSize(_: uPlot, texts: string[] | null): number {
  return 16 + 6.4 * Math.max(3, ...(texts ?? []).map((text) => text.length));
}

/** A chart that follows its box's width, the theme and the moment of the animation. */
export class Chart extends FittedPlot<ChartData> {
  private moment = -Infinity;
  private readonly marker = h("div", { class: "moment" });
  private readonly key = h("div", { class: "band-key" });
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
      scales: { x: { time: false }, y: { range: (plot: uPlot, low: number, high: number) => this.yRange(plot, data, [low, high]) } },
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
          stroke: hueOf(i),
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
        drawAxes: [
          (plot) => {
            for (const { band, place } of this.shownBands(plot, data)) drawBand(plot, data.x, band, hueOf(place));
          },
        ],
        draw: [() => this.placeMoment()],
        ready: [(plot) => this.listen(plot)],
      },
    };
    const columns = [data.x, ...data.curves.map((curve) => curve.values)] as unknown as uPlot.AlignedData;
    this.plot = new uPlot(options, columns, this.host);
    this.showKey(data);
  }

  /** Bands are shown and hidden together with their curves. */
  private shownBands(plot: uPlot, data: ChartData): { band: SampledBand; place: number }[] {
    return data.curves.flatMap(({ band }, place) => (band && plot.series[place + 1].show ? [{ band, place }] : []));
  }

  private yRange(plot: uPlot, data: ChartData, bounds: [number, number]): [number, number] {
    const { min, max } = plot.scales["x"];
    const bands = this.shownBands(plot, data).map(({ band }) => band);
    return axisRange(...boundsWithBands(bounds, bands, data.x, [min ?? -Infinity, max ?? Infinity]));
  }

  private showKey(data: ChartData): void {
    this.key.remove();
    if (!data.bandLabel || !data.curves.some((curve) => curve.band)) return;
    const entries = [["run", "unperturbed run"], ["median", "median"], ["area", data.bandLabel]];
    this.key.replaceChildren(...entries.map(([mark, text]) => h("span", {}, h("i", { class: mark }), text)));
    this.host.append(this.key);
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
