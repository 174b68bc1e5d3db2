// SPDX-License-Identifier: BSD-3-Clause
import { short, title } from "../math/numbers";
import { splitBy } from "../payload/history";
import type { Run } from "../payload/run";
import { h } from "./dom";

type Cell = string | number | null | undefined | HTMLElement;

const isNumber = (cell: Cell): boolean => typeof cell === "number" || cell === null || cell === undefined;

function table(heads: string[], rows: Cell[][]): HTMLElement {
  // A column with a number in it is set to the right, its head as well.
  const right = heads.map((_, column) => rows.some((row) => typeof row[column] === "number"));
  const side = (column: number) => (right[column] ? "number" : undefined);
  const head = h("tr", {}, ...heads.map((text, column) => h("th", { scope: "col", class: side(column) }, text)));
  const body = rows.map((row) =>
    h(
      "tr",
      {},
      ...row.map((cell, column) =>
        h("td", { class: side(column) }, cell instanceof HTMLElement ? cell : isNumber(cell) ? short(cell as number) : String(cell)),
      ),
    ),
  );
  const named = heads.some((text) => text !== "");
  return h("div", { class: "scroll" }, h("table", {}, ...(named ? [h("thead", {}, head)] : []), h("tbody", {}, ...body)));
}

function block(heading: string, content: HTMLElement, wide = false): HTMLElement {
  return h("article", { class: wide ? "block wide" : "block" }, h("h3", {}, heading), content);
}

function checks(run: Run): HTMLElement | null {
  const list = run.meta.run?.checks;
  if (!list || list.length === 0) return null;
  const rows = list.map((check): Cell[] => [
    check.name,
    check.value,
    check.limit,
    check.source_limit ?? "–",
    check.source,
    h("b", { class: check.pass ? "pass" : "fail" }, check.pass ? "PASS" : "FAIL"),
  ]);
  return block("Checks", table(["check", "value", "limit", "source's limit", "source", ""], rows), true);
}

function parts(run: Run): HTMLElement | null {
  const titles = new Map((run.meta.run?.parts ?? []).map((part) => [String(part.id), part.title]));
  const drawn = new Map<string, number>();
  for (const id of run.part) drawn.set(String(id), (drawn.get(String(id)) ?? 0) + 1);
  const matsum = run.history("matsum.csv");
  const last = matsum ? splitBy(matsum, ["part"]) : null;
  const ids = [...new Set([...drawn.keys(), ...(last?.keys() ?? []), ...titles.keys()])].sort((a, b) => Number(a) - Number(b));
  const rows = ids.map((id): Cell[] => {
    const history = last?.get(id);
    const at = (name: string) => (history ? history.number[name][history.rows - 1] : null);
    return [id, titles.get(id) ?? "", drawn.get(id) ?? 0, at("mass"), at("internal"), at("kinetic"), at("hourglass")];
  });
  return block(
    "Parts",
    table(["part", "title", "elements seen", "mass", "internal", "kinetic", "hourglass"], rows),
    true,
  );
}

function timings(run: Run): HTMLElement | null {
  const record = run.meta.run;
  if (!record?.timings) return null;
  const loop = record.loop_seconds ?? 0;
  const rows: Cell[][] = Object.entries(record.timings).map(([name, time]) => [title(name), time, share(time, loop)]);
  const rest = loop - Object.values(record.timings).reduce((a, b) => a + b, 0);
  rows.push(["Other", Math.max(0, rest), share(Math.max(0, rest), loop)], ["Total", loop, share(loop, loop)]);
  return block("Timings", table(["stage", "seconds", "share"], rows));
}

function share(part: number, whole: number): string {
  return whole > 0 ? `${((100 * part) / whole).toFixed(1)} %` : "–";
}

function energies(run: Run): HTMLElement | null {
  const energy = run.meta.run?.energy;
  if (!energy) return null;
  const rows = Object.entries(energy)
    .filter(([name]) => name !== "error")
    .map(([name, value]): Cell[] => [title(name), value]);
  rows.push(["Error / absorbed", energy["error"]]);
  return block("Energies at the end", table(["energy", "value"], rows));
}

function facts(run: Run): HTMLElement | null {
  const record = run.meta.run;
  if (!record) return null;
  const scatter = run.meta.scatter;
  const elements = Object.entries(record.elements ?? {})
    .filter(([, count]) => count > 0)
    .map(([kind, count]) => `${count} ${kind}`)
    .join(", ");
  const rows: Cell[][] = [
    ["program", record.version],
    ["deck", record.deck],
    ["units (guess)", record.units || undefined],
    ["ended", `${record.termination}: ${record.reason}`],
    ["scatter", scatter ? `unperturbed one of ${scatter.runs} runs` : undefined],
    ["end time", record.end_time],
    ["cycles", record.cycles],
    ["nodes", record.nodes],
    ["elements", elements],
    ["arithmetic", `${record.precision}, ${record.isa}, ${record.threads} thread${record.threads === 1 ? "" : "s"}`],
    ["contact search", record.search],
    ["wall time [s]", record.wall_seconds],
    ["ns per element-cycle", record.ns_per_element_cycle],
    ["memory [MB]", (record.peak_memory_bytes ?? NaN) / 1e6],
    ["state hash", record.state_hash],
  ];
  const shown = rows.filter(([, value]) => value !== undefined);
  const exact = shown.map(([name, value]): Cell[] => [
    name,
    typeof value === "number" ? (Number.isInteger(value) ? String(value) : short(value)) : value,
  ]);
  return block("Run", table(["", ""], exact));
}

function contacts(run: Run): HTMLElement | null {
  const list = run.meta.run?.contact;
  if (!list || list.length === 0) return null;
  const names = ["id", "method", "searches", "active_pairs", "worst_penetration", "worst_node", "energy", "friction_energy"];
  const rows = list.map((contact) => names.map((name) => contact[name] as Cell));
  return block("Contacts", table(names.map((name) => name.replace(/_/g, " ")), rows), true);
}

function worstElements(run: Run): HTMLElement | null {
  const list = run.meta.run?.energy_trace?.worst_elements;
  if (!list || list.length === 0) return null;
  const rows = list.map((group): Cell[] => [
    String(group.part),
    `${group.elements} ${group.kind}s from ${group.first} to ${group.last}`,
    group.residual,
    String(group.fastest_node),
    group.speed,
    group.place.map((value) => short(value ?? NaN)).join(", "),
  ]);
  const heads = ["part", "neighbouring elements", "residual", "fastest node", "its speed", "where it is"];
  return block("Where energy goes wrong", table(heads, rows), true);
}

function warnings(run: Run): HTMLElement | null {
  const list = run.meta.run?.warnings;
  if (!list || list.length === 0) return null;
  return block("Warnings", h("ul", {}, ...list.map((text) => h("li", {}, text))), true);
}

function leftOut(run: Run): HTMLElement | null {
  const list = run.meta.run?.left_out;
  if (!list || list.length === 0) return null;
  const rows = list.map((item): Cell[] => [item.name, item.reason, String(item.count), item.place]);
  return block("Left out of the deck", table(["what", "why", "times", "first at"], rows), true);
}

export function tables(run: Run): HTMLElement {
  const blocks = [checks, warnings, leftOut, parts, contacts, worstElements, facts, energies, timings].map((make) => make(run));
  const data = run.meta;
  const exactness = Math.max(...run.axes.map((axis) => axis.step)) / 2;
  const coarse = data.fields.filter((field) => field.bits === 8).length > 0;
  const note =
    `The animation holds ${data.times.length} frames of the ${data.nodes} nodes that are seen, with an error of their ` +
    `coordinates of at most ${short(exactness, 2)}; fringes are exact to ${coarse ? "1/500" : "1/130 000"} of their range. ` +
    "Numbers are in the units of the deck.";
  const thinned = data.tables.filter((entry) => entry.every > 1).map((entry) => `${entry.name} (one moment in ${entry.every})`);
  for (const { name, every } of data.scatter?.histories ?? []) if (every > 1) thinned.push(`bands of ${name} (one point in ${every})`);
  return h(
    "section",
    { id: "tables" },
    h("h2", {}, "Tables"),
    h("div", { class: "blocks" }, ...blocks),
    h("p", { class: "muted" }, note, thinned.length > 0 ? ` Thinned out: ${thinned.join(", ")}.` : ""),
  );
}
