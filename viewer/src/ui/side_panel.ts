// SPDX-License-Identifier: BSD-3-Clause
import { Vector3 } from "three";
import { short, title } from "../math/numbers";
import { fringeSources, type FringeSource } from "../scene/fringe_source";
import type { ModelView } from "../scene/model_view";
import type { Walls } from "../scene/walls";
import type { Run } from "../payload/run";
import { boxOf, h, labelled, options, setBox, toggle } from "./dom";
import type { Legend } from "./legend";

type RangeKind = "run" | "frame" | "own";

export interface PanelSettings {
  field: string;
  range: RangeKind;
  low: string;
  high: string;
  bands: string;
  edges: boolean;
  ghost: boolean;
  /** null where there are none to switch */
  walls: boolean | null;
  section: boolean;
  axis: string;
  /** of the section: along its axis [length], or a share of the depth */
  cut: number;
}

/** Choice of what is shown and how: fringe, edges, ghost, walls, section. */
export class SidePanel {
  readonly element = h("div", { class: "panel" });
  readonly sources: FringeSource[];
  readonly edges: HTMLLabelElement;
  readonly ghost: HTMLLabelElement;
  readonly section: HTMLLabelElement;
  readonly field = h("select", { id: "field", "aria-label": "fringe" });
  private readonly rangeKind = h("select", { id: "range", "aria-label": "range" });
  private readonly low = h("input", { type: "number", step: "any", "aria-label": "lowest value" });
  private readonly high = h("input", { type: "number", step: "any", "aria-label": "highest value" });
  private readonly bands = h("select", { "aria-label": "bands" });
  private readonly axis = h("select", { "aria-label": "normal of the section" });
  private readonly cut = h("input", { type: "range", min: 0, max: 1, step: 0.002, value: 0.5, "aria-label": "place of the section" });
  private readonly cutValue = h("output", {});
  /** Where the section is, as a share of the way through the box; the slider shows the nearest of its steps. */
  private share = 0.5;
  private readonly wallToggle: HTMLLabelElement | null;
  private source: FringeSource | null = null;
  private frame = 0;

  constructor(
    private readonly run: Run,
    private readonly view: ModelView,
    private readonly legend: Legend,
    walls: Walls,
    private readonly redraw: () => void,
  ) {
    this.sources = fringeSources(run);
    options(this.field, [["", "by part"], ...this.sources.map((source): [string, string] => [source.name, fieldTitle(source)])]);
    options(this.rangeKind, [["run", "of the run"], ["frame", "of the frame"], ["own", "given"]]);
    options(this.bands, [["12", "12"], ["8", "8"], ["20", "20"], ["0", "smooth"]]);
    this.field.addEventListener("change", () => this.setField(this.field.value));
    this.rangeKind.addEventListener("change", () => this.updateRange());
    for (const input of [this.low, this.high])
      input.addEventListener("change", () => {
        this.rangeKind.value = "own";
        this.updateRange();
      });
    this.bands.addEventListener("change", () => {
      view.setBands(Number(this.bands.value));
      this.updateRange();
    });
    const many = run.meta.faces > 40000;
    this.edges = toggle("edges", !many, (on) => this.act(() => view.setEdges(on)), "e");
    view.setEdges(!many);
    this.ghost = toggle("undeformed", false, (on) => this.act(() => view.setGhost(on)), "g");
    this.wallToggle = walls.any ? toggle("walls", true, (on) => this.act(() => (walls.group.visible = on)), "w") : null;
    this.section = toggle("section", false, () => this.updateSection(), "s");
    options(this.axis, [["x", "x"], ["y", "y"], ["z", "z"], ["-x", "−x"], ["-y", "−y"], ["-z", "−z"], ["view", "view"]]);
    this.axis.addEventListener("change", () => this.updateSection());
    this.cut.addEventListener("input", () => {
      this.share = Number(this.cut.value);
      this.updateSection();
    });
    this.element.append(
      labelled("fringe", this.field),
      h("div", { class: "fringe-only" },
        labelled("range", this.rangeKind),
        h("div", { class: "pair" }, this.low, h("span", {}, "to"), this.high),
        labelled("bands", this.bands)),
      h("div", { class: "toggles" }, this.edges, this.ghost, this.wallToggle, this.section),
      h("div", { class: "section-only", hidden: true }, labelled("cut away", this.axis), this.cut, this.cutValue),
    );
  }

  viewDirection: () => Vector3 = () => new Vector3(0, 0, 1);

  private act(change: () => void): void {
    change();
    this.redraw();
  }

  get current(): FringeSource | null {
    return this.source;
  }

  setField(name: string): void {
    this.source = this.sources.find((source) => source.name === name) ?? null;
    this.field.value = this.source?.name ?? "";
    this.view.setSource(this.source);
    this.element.querySelector<HTMLElement>(".fringe-only")!.hidden = this.source === null;
    if (this.rangeKind.value === "own") this.rangeKind.value = "run";
    this.updateRange();
  }

  get settings(): PanelSettings {
    return {
      field: this.field.value,
      range: this.rangeKind.value as RangeKind,
      low: this.low.value,
      high: this.high.value,
      bands: this.bands.value,
      edges: boxOf(this.edges).checked,
      ghost: boxOf(this.ghost).checked,
      walls: this.wallToggle && boxOf(this.wallToggle).checked,
      section: boxOf(this.section).checked,
      axis: this.axis.value,
      cut: this.axis.value === "view" ? this.share : this.place(this.share),
    };
  }

  set settings(kept: PanelSettings) {
    this.bands.value = kept.bands;
    this.view.setBands(Number(kept.bands));
    this.setField(kept.field);
    this.rangeKind.value = kept.range;
    if (kept.range === "own") [this.low.value, this.high.value] = [kept.low, kept.high];
    this.updateRange();
    setBox(this.edges, kept.edges);
    setBox(this.ghost, kept.ghost);
    if (this.wallToggle && kept.walls !== null) setBox(this.wallToggle, kept.walls);
    this.axis.value = kept.axis;
    const [start, end] = [this.place(0), this.place(1)];
    this.share = kept.axis === "view" || start === end ? kept.cut : (kept.cut - start) / (end - start);
    this.cut.value = String(this.share);
    setBox(this.section, kept.section);
    this.updateSection();
  }

  /** The frame whose values are shown has changed. */
  setFrame(frame: number): void {
    if (frame === this.frame) return;
    this.frame = frame;
    if (this.source && this.rangeKind.value === "frame") this.updateRange();
  }

  private updateRange(): void {
    if (!this.source) {
      this.legend.hide();
      this.redraw();
      return;
    }
    const kind = this.rangeKind.value as RangeKind;
    let [low, high] = kind === "frame" ? this.source.frameRange(this.frame) : this.source.range();
    if (kind === "own") {
      low = this.low.value === "" ? low : Number(this.low.value);
      high = this.high.value === "" ? high : Number(this.high.value);
    } else {
      this.low.value = String(Number(low.toPrecision(5)));
      this.high.value = String(Number(high.toPrecision(5)));
    }
    this.view.setRange(low, high);
    const note = { run: "range of the run", frame: "range of the frame", own: "given range" }[kind];
    this.legend.show(fieldTitle(this.source), low, high, Number(this.bands.value), note);
    this.redraw();
  }

  /** Where a share of the way through the run's box lies along the axis of the section [length]. */
  private place(share: number): number {
    const axis = Math.max(0, "xyz".indexOf(this.axis.value.slice(-1)));
    const { low, high } = this.run.meta.box;
    return low[axis] + share * (high[axis] - low[axis]);
  }

  private updateSection(): void {
    const on = this.section.querySelector("input")!.checked;
    this.element.querySelector<HTMLElement>(".section-only")!.hidden = !on;
    if (!on) {
      this.act(() => this.view.setSection(null));
      return;
    }
    const choice = this.axis.value;
    const { share } = this;
    if (choice === "view") {
      this.act(() => this.view.setSection(this.viewDirection(), share - 0.5));
      this.cutValue.textContent = `${Math.round(100 * share)} % of the depth`;
      return;
    }
    const axis = "xyz".indexOf(choice.slice(-1));
    const sign = choice.startsWith("-") ? -1 : 1;
    const at = this.place(share);
    const normal = new Vector3().setComponent(axis, sign);
    const world = (at - this.view.centre.getComponent(axis)) / this.view.diagonal;
    this.act(() => this.view.setSection(normal, sign * world));
    this.cutValue.textContent = `${"xyz"[axis]} = ${short(at)}`;
  }
}

/** Vectors are shown by their size. */
export function fieldTitle(source: FringeSource): string {
  const last = /^(.*)_([xyz])$/.exec(source.name);
  return last ? `${title(last[1])} ${last[2].toUpperCase()}` : title(source.name);
}
