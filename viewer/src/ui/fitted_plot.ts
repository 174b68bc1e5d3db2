// SPDX-License-Identifier: BSD-3-Clause
import uPlot from "uplot";
import type { Themes } from "./theme";

/** A plot that follows its box's width [px] and the theme, which it is drawn anew for. */
export abstract class FittedPlot<Data> {
  protected plot: uPlot | null = null;
  protected data: Data | null = null;

  constructor(
    protected readonly host: HTMLElement,
    /** [px] */
    protected readonly height: number,
    protected readonly themes: Themes,
  ) {
    new ResizeObserver(() => this.fit()).observe(host);
    themes.watch(() => this.rebuild());
  }

  show(data: Data): void {
    this.data = data;
    this.rebuild();
  }

  /** Replaces the plot by one of the present data, or by none. */
  protected abstract rebuild(): void;

  private fit(): void {
    const width = this.host.clientWidth;
    if (this.plot && width > 0 && width !== this.plot.width) this.plot.setSize({ width, height: this.height });
  }
}
