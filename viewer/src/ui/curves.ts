// SPDX-License-Identifier: BSD-3-Clause
import { interpolate, short, title } from "../math/numbers";
import { sampledBand, type SampledBand } from "../payload/bands";
import {
  contactForces,
  filteredForce,
  guessTimeUnit,
  sampleRate,
  wallForces,
  type Filtering,
  type Force,
} from "../payload/forces";
import { canFilter } from "../math/filter";
import { curveName, splitBy, type History } from "../payload/history";
import type { ScatterMeta } from "../payload/meta";
import type { Run } from "../payload/run";
import { Chart, type Curve } from "./charts";
import { choose, h, labelled, options } from "./dom";
import type { Themes } from "./theme";
import { XyChart } from "./xy_chart";

const height = 230;
const classes = [0, 60, 180, 600];
const seconds = { s: 1, ms: 1e-3, us: 1e-6 };

export interface CurveSettings {
  filter: string;
  unit: string;
  mover: string;
  /** by chart: series that the user has switched, by label */
  switched: [string, boolean][][];
}

/** The section with all curves over time. */
export class Curves {
  readonly element = h("section", { id: "curves" });
  private readonly grid = h("div", { class: "charts" });
  private readonly charts: Chart[] = [];
  private readonly filter = h("select", { "aria-label": "filter" });
  private readonly unit = h("select", { "aria-label": "unit of time" });
  private readonly mover = h("select", { "aria-label": "displacement of" });
  private readonly note = h("small", {});
  private readonly refilters: (() => void)[] = [];
  private forceDisplacement: XyChart | null = null;
  private picked: number | null = null;

  constructor(
    private readonly run: Run,
    private readonly themes: Themes,
    private readonly seek: (time: number) => void,
  ) {
    const glstat = run.history("glstat.csv");
    if (glstat) this.addEnergies(glstat);
    const walls = run.history("rwforc.csv");
    const contacts = run.history("rcforc.csv");
    const wall = walls ? wallForces(walls) : [];
    const contact = contacts ? contactForces(contacts) : [];
    this.addForces("Wall forces", wall);
    this.addForces("Contact forces (resultant)", contact);
    this.addForceDisplacement(wall.length > 0 ? wall : contact, wall.length > 0 ? walls! : contacts);
    this.addTimeStep(glstat, run.history("timestep.csv"));
    if (glstat) this.addColumns("Added mass", glstat, ["added_mass"]);
    const matsum = run.history("matsum.csv");
    if (matsum) this.addParts(matsum);
    const residuals = run.history("energy_residual.csv");
    if (residuals) this.addResiduals(residuals);
    const controls = wall.length + contact.length > 0 ? this.filterControls([...wall, ...contact]) : null;
    this.element.append(h("h2", {}, "Curves"), ...(controls ? [controls] : []), this.grid);
    if (!this.grid.hasChildNodes()) this.grid.append(h("p", { class: "muted" }, "The run has no histories."));
  }

  setMoment(time: number): void {
    for (const chart of this.charts) chart.setMoment(time);
  }

  get settings(): CurveSettings {
    const [filter, unit, mover] = [this.filter.value, this.unit.value, this.mover.value];
    return { filter, unit, mover, switched: this.charts.map((chart) => [...chart.switched]) };
  }

  /** Where other charts are there than before, it cannot be told whose series were switched. */
  set settings(kept: CurveSettings) {
    if (kept.switched.length === this.charts.length)
      kept.switched.forEach((series, i) => this.charts[i].setSwitched(series));
    choose(this.unit, kept.unit);
    choose(this.filter, kept.filter);
    choose(this.mover, kept.mover);
  }

  /** The node that the user picked may be chosen for the force over its displacement. */
  setPickedNode(node: number | null): void {
    this.picked = node;
    this.fillMovers();
    if (node !== null) this.mover.value = "picked";
    this.showForceDisplacement();
  }

  private box(heading: string): HTMLElement {
    const body = h("div", { class: "plot" });
    this.grid.append(h("figure", { class: "chart" }, h("figcaption", {}, heading), body));
    return body;
  }

  private addChart(heading: string): Chart {
    const chart = new Chart(this.box(heading), height, this.themes, this.seek);
    this.charts.push(chart);
    return chart;
  }

  /** A column of a history with its band. */
  private column(label: string, history: History, name: string): Curve {
    return { label, values: history.number[name], band: this.band(curveName(history, name), history.number["time"]) };
  }

  private band(curve: string, times: ArrayLike<number>): SampledBand | undefined {
    const band = this.run.band(curve);
    return band ? sampledBand(band, times) : undefined;
  }

  private showOverTime(chart: Chart, x: ArrayLike<number>, curves: Curve[]): void {
    const scatter = this.run.meta.scatter;
    chart.show({ xLabel: "time", x, curves, bandLabel: scatter ? bandLabel(scatter) : undefined });
  }

  private addColumns(heading: string, history: History, names: string[], hidden: string[] = []): void {
    const curves = names
      .filter((name) => history.number[name])
      .map((name): Curve => ({ ...this.column(title(name), history, name), shown: !hidden.includes(name) }));
    if (curves.length > 0) this.showOverTime(this.addChart(heading), history.number["time"], curves);
  }

  private addEnergies(glstat: History): void {
    const all = ["kinetic", "internal", "hourglass", "contact", "friction", "rigidwall", "damping", "external_work", "eroded", "total"];
    const empty = all.filter((name) => glstat.number[name]?.every((value) => value === 0));
    this.addColumns("Energies", glstat, all.filter((name) => !empty.includes(name)));
    this.addColumns("Energy ratio", glstat, ["ratio"]);
  }

  private addTimeStep(glstat: History | null, steps: History | null): void {
    if (!steps || steps.rows === 0) {
      if (glstat) this.addColumns("Time step", glstat, ["dt"]);
      return;
    }
    const body = this.box("Time step and the element that controls it");
    const host = h("div", {});
    const chart = new Chart(host, height, this.themes, this.seek);
    this.charts.push(chart);
    chart.show({ xLabel: "time", x: steps.number["time"], curves: [{ label: "Step", values: steps.number["dt"] }] });
    const counts = [...splitBy(steps, ["kind", "element", "part"])].sort((a, b) => b[1].rows - a[1].rows);
    const list = counts.slice(0, 4).map(([item, rows]) => {
      const [kind, element, part] = item.split(" ");
      return `${kind} ${element} (part ${part}) ${Math.round((100 * rows.rows) / steps.rows)} %`;
    });
    body.append(host, h("small", { class: "muted" }, `controlled by ${list.join(", ")}${counts.length > 4 ? ", …" : ""}`));
  }

  private addParts(matsum: History): void {
    const parts = splitBy(matsum, ["part"]);
    const largest = [...parts]
      .map(([id, rows]) => ({ id, rows, most: rows.number["internal"].reduce((a, b) => Math.max(a, b), 0) }))
      .sort((a, b) => b.most - a.most)
      .slice(0, 8);
    if (largest.length < 2) return;
    const curves = largest.map(({ id, rows }) => this.column(`part ${id}`, rows, "internal"));
    const heading = parts.size > largest.length ? `Internal energy of the ${largest.length} parts with the most` : "Internal energy by part";
    this.showOverTime(this.addChart(heading), largest[0].rows.number["time"], curves);
  }

  /** Of parts and contacts, those with the largest. */
  private addResiduals(residuals: History): void {
    const most = (rows: History) => rows.number["residual"].reduce((a, b) => Math.max(a, Math.abs(b)), 0);
    const items = [...splitBy(residuals, ["kind", "id"])].sort((a, b) => most(b[1]) - most(a[1])).slice(0, 8);
    if (items.length === 0) return;
    const curves = items.map(([item, rows]): Curve => {
      const [kind, id] = item.split(" ");
      return { label: kind === "rest" ? "rest" : `${kind} ${id}`, values: rows.number["residual"] };
    });
    this.addChart("Energy residuals by part and contact").show({ xLabel: "time", x: items[0][1].number["time"], curves });
  }

  private filtering(): Filtering {
    return { cfc: Number(this.filter.value || 0), secondsPerUnit: seconds[(this.unit.value || "s") as keyof typeof seconds] };
  }

  private filterControls(forces: Force[]): HTMLElement {
    options(this.filter, classes.map((cfc) => [String(cfc), cfc === 0 ? "none" : `SAE CFC ${cfc}`]));
    options(this.unit, [["s", "s"], ["ms", "ms"], ["us", "µs"]]);
    const end = this.run.meta.times[this.run.frames - 1];
    this.unit.value = guessTimeUnit(this.run.meta.run?.units, end);
    const refresh = () => {
      const { secondsPerUnit } = this.filtering();
      const rate = sampleRate(forces[0].times, secondsPerUnit);
      for (const option of this.filter.options)
        option.disabled = option.value !== "0" && !canFilter(Number(option.value), 1 / rate);
      if (this.filter.selectedOptions[0]?.disabled) this.filter.value = "0";
      const bands = this.run.meta.scatter && this.filter.value !== "0" ? "; bands are of unfiltered forces and not drawn" : "";
      this.note.textContent = `forces recorded at ${short(rate, 3)} Hz if a unit of time is 1 ${this.unit.selectedOptions[0].text}${bands}`;
      for (const refilter of this.refilters) refilter();
      this.showForceDisplacement();
    };
    this.filter.addEventListener("change", refresh);
    this.unit.addEventListener("change", refresh);
    refresh();
    return h("div", { class: "controls" }, labelled("Filter of forces", this.filter), labelled("unit of time", this.unit), this.note);
  }

  private addForces(heading: string, forces: Force[]): void {
    if (forces.length === 0) return;
    const chart = this.addChart(heading);
    const show = () => {
      const shown = forces.map((force) => filteredForce(force, this.filtering()));
      const x = shown[0].times;
      const curves = shown.map((force, i): Curve => {
        // Percentiles of filtered forces are not filtered percentiles.
        const band = force === forces[i] ? this.band(force.curve, x) : undefined;
        return { label: force.label, values: force.values, band };
      });
      this.showOverTime(chart, x, curves);
    };
    this.refilters.push(show);
    show();
  }

  // Force over displacement.

  private forces: Force[] = [];
  private direction: [number, number, number] | null = null;

  private addForceDisplacement(forces: Force[], history: History | null): void {
    if (forces.length === 0 || !history) return;
    this.forces = forces;
    this.direction = meanDirection(history);
    const body = this.box("Force over displacement");
    const host = h("div", {});
    body.append(host, h("div", { class: "controls" }, labelled("displacement of", this.mover)));
    this.forceDisplacement = new XyChart(host, height - 30, this.themes);
    this.mover.addEventListener("change", () => this.showForceDisplacement());
    this.fillMovers();
    this.showForceDisplacement();
  }

  private fillMovers(): void {
    const list: [string, string][] = [];
    if (this.picked !== null) list.push(["picked", `picked node ${this.run.nodeId[this.picked]}`]);
    const farthest = this.farthestNode();
    // The way of the node that moves farthest counts as positive, whichever side the force is taken from.
    if (this.direction && this.along(this.run.frames - 1, farthest) < 0)
      this.direction = [-this.direction[0], -this.direction[1], -this.direction[2]];
    list.push(["farthest", `node ${this.run.nodeId[farthest]}, which moves farthest`]);
    const nodout = this.run.history("nodout.csv");
    if (nodout) for (const id of splitBy(nodout, ["node"]).keys()) list.push([`node ${id}`, `node ${id} of nodout`]);
    options(this.mover, list);
  }

  private farthestNode(): number {
    const last = this.run.frames - 1;
    let best = 0;
    let most = -1;
    for (let node = 0; node < this.run.meta.nodes; ++node) {
      const moved = Math.abs(this.along(last, node));
      if (moved > most) [best, most] = [node, moved];
    }
    return best;
  }

  /** Displacement in the mean direction of the force, or its size where the force has none. */
  private along(frame: number, node: number): number {
    const now = this.run.position(frame, node);
    const start = this.run.position(0, node);
    const u = now.map((x, axis) => x - start[axis]);
    return this.direction ? u.reduce((sum, x, axis) => sum + x * this.direction![axis], 0) : Math.hypot(...u);
  }

  private showForceDisplacement(): void {
    if (!this.forceDisplacement || this.forces.length === 0) return;
    let times: ArrayLike<number> = this.run.meta.times;
    let moved: ArrayLike<number>;
    const choice = this.mover.value;
    if (choice.startsWith("node ")) {
      const rows = splitBy(this.run.history("nodout.csv")!, ["node"]).get(choice.slice(5))!;
      const u = ["ux", "uy", "uz"].map((name) => rows.number[name]);
      times = rows.number["time"];
      moved = u[0].map((_, i) =>
        this.direction
          ? u.reduce((sum, x, axis) => sum + x[i] * this.direction![axis], 0)
          : Math.hypot(u[0][i], u[1][i], u[2][i]),
      );
    } else {
      const node = choice === "picked" && this.picked !== null ? this.picked : this.farthestNode();
      moved = this.run.meta.times.map((_, frame) => this.along(frame, node));
    }
    const curves = this.forces.map((force) => {
      const shown = filteredForce(force, this.filtering());
      return { label: shown.label, x: shown.times.map((time) => interpolate(times, moved, time)), y: shown.values };
    });
    this.forceDisplacement.show({ xLabel: "displacement in the direction of the force", yLabel: "force", curves });
  }
}

/** What the bands are, as their legend tells. */
function bandLabel({ runs, perturbation }: ScatterMeta): string {
  const moved = perturbation === null ? "" : `, nodes moved by up to ${short(perturbation)} of the diagonal`;
  return `P5 to P95 of ${runs} runs${moved}`;
}

/** Unit vector of the sum of a history's forces; null if they cancel or there are none. */
function meanDirection(history: History): [number, number, number] | null {
  const first = history.text["side"] ? splitBy(history, ["side"]).get("first") : history;
  if (!first) return null;
  const sum = ["fx", "fy", "fz"].map((name) => first.number[name].reduce((a, b) => a + (Number.isFinite(b) ? b : 0), 0));
  const size = Math.hypot(...sum);
  return size > 0 ? (sum.map((x) => x / size) as [number, number, number]) : null;
}
