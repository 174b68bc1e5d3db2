// SPDX-License-Identifier: BSD-3-Clause
import { short } from "../math/numbers";
import { Chart } from "../ui/charts";
import { h, labelled, options } from "../ui/dom";
import type { Themes } from "../ui/theme";
import { grades, percent, together, type ComparedCurve, type Comparison, type Side } from "./comparison";

const chartHeight = 200;

/** The page of a comparison: what was compared, the table, the curves over each other. */
export class ComparePage {
  private readonly rows: HTMLTableRowElement[] = [];
  private readonly figures: (HTMLElement | null)[] = [];
  private readonly group = h("select", { "aria-label": "group" });
  private readonly grade = h("select", { "aria-label": "grade" });

  constructor(
    private readonly comparison: Comparison,
    private readonly themes: Themes,
    root: HTMLElement,
  ) {
    root.replaceChildren(this.header(), this.summary(), this.tables(), this.charts());
    this.group.addEventListener("change", () => this.filter());
    this.grade.addEventListener("change", () => this.filter());
    window.addEventListener("keydown", (event) => {
      if (event.key === "t" && !(event.target instanceof HTMLSelectElement)) themes.toggle();
    });
    // A printed page has all charts, also those that nobody has scrolled to.
    window.addEventListener("beforeprint", () => this.drawAll());
  }

  private header(): HTMLElement {
    const button = h("button", { title: "light or dark (t)", click: () => this.themes.toggle() }, "◐");
    const name = h("span", { class: "name" }, "Comparison");
    return h("header", {}, name, h("nav", {}, h("a", { href: "#scores" }, "Scores"), h("a", { href: "#curves" }, "Curves")), button);
  }

  private summary(): HTMLElement {
    const { reference, other, curves, cfc, tolerance, notes } = this.comparison;
    const side = (label: string, hue: string, of: Side) => [
      h("dt", {}, h("span", { class: `line ${hue}` }), label),
      h("dd", {}, `${of.source} (${of.files.join(", ")})`),
    ];
    const list = h("dl", { class: "sides" }, ...side("Reference", "reference", reference), ...side("Other", "other", other));
    const counts = grades.map((grade) => {
      const count = curves.filter((curve) => curve.iso_18571.grade === grade).length;
      return h("span", { class: `badge ${grade}` }, `${count} ${grade}`);
    });
    const worst = curves[0];
    const words = worst ? `Worst difference ${percent(worst.relative)} of the peak: ${worst.name} at ${short(worst.time)}.` : "";
    const beyond = curves.filter((curve) => curve.relative === null || curve.relative > (tolerance ?? Infinity)).length;
    const verdict =
      tolerance === undefined ? "" : beyond === 0 ? ` All within ${percent(tolerance)}.` : ` ${beyond} beyond ${percent(tolerance)}.`;
    const filtered = cfc === null ? "" : ` Both sides went through SAE CFC ${cfc}.`;
    const all = [...reference.notes, ...other.notes, ...notes];
    return h(
      "section",
      { id: "summary" },
      list,
      h("p", {}, `${curves.length} curves by ISO/TS 18571: `, ...counts.flatMap((count) => [count, " "])),
      h("p", {}, words + verdict + filtered),
      all.length > 0 ? h("ul", { class: "muted" }, ...all.map((note) => h("li", {}, note))) : null,
    );
  }

  private tables(): HTMLElement {
    const heads: [string, string][] = [
      ["curve", ""],
      ["worst difference", "largest, other - reference"],
      ["of peak", "over the largest size of the reference"],
      ["at time", ""],
      ["M", "Sprague-Geers: magnitude, 0 is perfect"],
      ["P", "Sprague-Geers: phase, 0 is perfect"],
      ["C", "Sprague-Geers: both, 0 is perfect"],
      ["corridor", "ISO/TS 18571, 1 is perfect"],
      ["phase", "ISO/TS 18571, 1 is perfect"],
      ["magnitude", "ISO/TS 18571, 1 is perfect"],
      ["slope", "ISO/TS 18571, 1 is perfect"],
      ["ISO rating", "0.4 corridor + 0.2 (phase + magnitude + slope)"],
      ["", ""],
    ];
    const head = h("tr", {}, ...heads.map(([text, title], place) => h("th", { title: title || undefined, class: place > 0 ? "number" : undefined }, text)));
    const body = h("tbody", {}, ...this.comparison.curves.map((curve, place) => this.row(curve, place)));
    const table = h("div", { class: "block wide" }, h("div", { class: "scroll scores" }, h("table", {}, h("thead", {}, head), body)));
    options(this.group, [["", "all"], ...[...new Set(this.comparison.curves.map((curve) => curve.group))].map((name): [string, string] => [name, name])]);
    options(this.grade, [["", "all"], ...grades.map((grade): [string, string] => [grade, grade])]);
    const controls = h("div", { class: "controls" }, labelled("Group", this.group), labelled("grade", this.grade));
    return h("section", { id: "scores" }, h("h2", {}, "Scores, the worst difference first"), controls, table, this.lists());
  }

  private row(curve: ComparedCurve, place: number): HTMLTableRowElement {
    const { sprague_geers: errors, iso_18571: iso } = curve;
    const three = (value: number | null) => (value === null ? "–" : Math.abs(value) < 100 ? value.toFixed(3).replace("-", "−") : short(value));
    const cells = [short(curve.difference), percent(curve.relative), short(curve.time), three(errors.magnitude), three(errors.phase), three(errors.combined)];
    const scores = [iso.corridor, iso.phase, iso.magnitude, iso.slope].map((score) => score.toFixed(2));
    const name = curve.other_name ? `${curve.name} – ${curve.other_name}` : curve.name;
    const linked = place < this.comparison.drawn.length ? h("a", { href: `#curve-${place}` }, name) : name;
    const row = h(
      "tr",
      {},
      h("td", {}, linked),
      ...[...cells, ...scores, iso.rating.toFixed(3)].map((text) => h("td", { class: "number" }, text)),
      h("td", {}, h("span", { class: `badge ${iso.grade}` }, iso.grade)),
    );
    this.rows.push(row);
    return row;
  }

  private lists(): HTMLElement {
    const { not_rated, only_in_reference, only_in_other, floor } = this.comparison;
    const list = (heading: string, names: string[]) =>
      names.length === 0 ? null : h("details", {}, h("summary", {}, `${heading} (${names.length})`), h("p", { class: "muted" }, names.join(", ")));
    return h(
      "div",
      { class: "lists" },
      list(`Not rated: zero, or below ${percent(floor)} of the largest of their kind on both sides`, not_rated.map((curve) => curve.name)),
      list("Only in the reference", only_in_reference),
      list("Only in the other", only_in_other),
    );
  }

  private charts(): HTMLElement {
    const { drawn, curves } = this.comparison;
    const grid = h("div", { class: "charts" });
    const watcher = new IntersectionObserver(
      (entries) => {
        for (const entry of entries) if (entry.isIntersecting) this.draw(Number((entry.target as HTMLElement).dataset["place"]), watcher);
      },
      { rootMargin: "400px" },
    );
    drawn.forEach((_, place) => {
      const curve = curves[place];
      const words = `${percent(curve.relative)} at ${short(curve.time)}, ISO ${curve.iso_18571.rating.toFixed(3)} ${curve.iso_18571.grade}`;
      const figure = h(
        "figure",
        { class: "chart", id: `curve-${place}`, "data-place": place },
        h("figcaption", {}, curve.name, " ", h("small", {}, words)),
        h("div", { class: "plot" }),
      );
      this.figures.push(figure);
      grid.append(figure);
      watcher.observe(figure);
    });
    this.watcher = watcher;
    const rest = curves.length - drawn.length;
    const note = rest > 0 ? h("p", { class: "muted" }, `The ${drawn.length} curves that differ most are drawn; ${rest} more are in the table.`) : null;
    return h("section", { id: "curves" }, h("h2", {}, "Curves"), grid, note);
  }

  private watcher: IntersectionObserver | null = null;
  private readonly done = new Set<number>();

  private draw(place: number, watcher: IntersectionObserver | null): void {
    const figure = this.figures[place];
    if (!figure || this.done.has(place)) return;
    this.done.add(place);
    watcher?.unobserve(figure);
    const plot = figure.querySelector<HTMLElement>(".plot")!;
    const data = together(this.comparison.drawn[place].reference, this.comparison.drawn[place].other);
    const chart = new Chart(plot, chartHeight, this.themes, null);
    const curves = [
      { label: "reference", values: data.first as number[] },
      { label: "other", values: data.second as number[], dash: [5, 3] },
    ];
    chart.show({ xLabel: "time", x: data.x, curves });
    chart.setMoment(this.comparison.curves[place].time);
  }

  private drawAll(): void {
    this.figures.forEach((_, place) => this.draw(place, this.watcher));
  }

  private filter(): void {
    this.comparison.curves.forEach((curve, place) => {
      const shown = (!this.group.value || curve.group === this.group.value) && (!this.grade.value || curve.iso_18571.grade === this.grade.value);
      this.rows[place].hidden = !shown;
      const figure = this.figures[place];
      if (figure) figure.hidden = !shown;
    });
  }
}
