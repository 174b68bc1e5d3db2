// SPDX-License-Identifier: BSD-3-Clause
import { short } from "../math/numbers";
import type { Run } from "../payload/run";
import type { FringeSource } from "../scene/fringe_source";
import type { Pick } from "../scene/picker";
import { Chart } from "./charts";
import { choose, h, options } from "./dom";
import { fieldTitle } from "./side_panel";
import type { Themes } from "./theme";

/** What was picked: ids, values now, and a history. */
export class Selection {
  readonly element = h("div", { class: "selection" });
  private readonly hint = h("p", { class: "muted" }, "Click the model to see a node's and an element's id, values and history.");
  private readonly facts = h("dl", {});
  private readonly choice = h("select", { "aria-label": "history of", id: "history" });
  private readonly host = h("div", { class: "plot" });
  private readonly save = h("button", { type: "button", title: "save this history as CSV" }, "CSV");
  private readonly chart: Chart;
  private pick: Pick | null = null;
  private frame = 0;

  constructor(
    private readonly run: Run,
    private readonly sources: FringeSource[],
    themes: Themes,
    seek: (time: number) => void,
  ) {
    this.chart = new Chart(this.host, 150, themes, seek);
    options(this.choice, sources.map((source) => [source.name, `${source.byNode ? "node" : "element"}: ${fieldTitle(source)}`]));
    this.choice.value = "displacement";
    this.choice.addEventListener("change", () => this.showHistory());
    this.save.addEventListener("click", () => this.saveHistory());
    this.element.append(h("h3", {}, "Selection"), this.hint, this.facts, h("div", { class: "buttons" }, this.choice, this.save), this.host);
    this.set(null);
  }

  set(pick: Pick | null, field?: string): void {
    this.pick = pick;
    this.hint.hidden = pick !== null;
    for (const part of [this.facts, this.choice, this.host, this.save]) part.hidden = pick === null;
    if (field && this.sources.some((source) => source.name === field)) this.choice.value = field;
    this.showFacts();
    this.showHistory();
  }

  /** name of the field whose history is shown */
  get shown(): string {
    return this.choice.value;
  }

  set shown(field: string) {
    choose(this.choice, field);
  }

  setMoment(frame: number, time: number): void {
    this.chart.setMoment(time);
    if (frame === this.frame) return;
    this.frame = frame;
    this.showFacts();
  }

  private item(source: FringeSource): number {
    return source.byNode ? this.pick!.node : this.pick!.cell;
  }

  private showFacts(): void {
    if (!this.pick) return;
    const { node, cell } = this.pick;
    const place = this.run.position(this.frame, node).map((x) => short(x)).join(", ");
    const rows: [string, string][] = [
      ["node", String(this.run.nodeId[node])],
      ["at", place],
      ["element", `${this.run.elementId[cell]} (part ${this.run.part[cell]})`],
    ];
    for (const source of this.sources) {
      const value = source.at(this.frame, this.item(source));
      if (Number.isFinite(value)) rows.push([fieldTitle(source), short(value)]);
    }
    if (this.frame >= this.run.death[cell]) rows.push(["", "the element has failed"]);
    this.facts.replaceChildren(...rows.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
  }

  private history(): { source: FringeSource; values: number[] } | null {
    const source = this.sources.find((other) => other.name === this.choice.value);
    if (!this.pick || !source) return null;
    const item = this.item(source);
    return { source, values: this.run.meta.times.map((_, frame) => source.at(frame, item)) };
  }

  private showHistory(): void {
    const history = this.history();
    if (!history) return;
    this.chart.show({
      xLabel: "time",
      x: this.run.meta.times,
      curves: [{ label: fieldTitle(history.source), values: history.values }],
    });
  }

  private saveHistory(): void {
    const history = this.history();
    if (!history) return;
    const item = this.item(history.source);
    const id = history.source.byNode ? `node_${this.run.nodeId[item]}` : `element_${this.run.elementId[item]}`;
    const lines = this.run.meta.times.map((time, frame) => `${time},${history.values[frame]}`);
    const blob = new Blob([`time,${history.source.name}\n${lines.join("\n")}\n`], { type: "text/csv" });
    const link = h("a", { href: URL.createObjectURL(blob), download: `${id}_${history.source.name}.csv` });
    link.click();
    URL.revokeObjectURL(link.href);
  }
}
