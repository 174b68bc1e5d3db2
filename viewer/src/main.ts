// SPDX-License-Identifier: BSD-3-Clause
import "uplot/dist/uPlot.min.css";
import "./style.css";
import "./main_types";
import type { Meta } from "./payload/meta";
import { Run } from "./payload/run";
import { Curves } from "./ui/curves";
import { h } from "./ui/dom";
import { Report } from "./ui/report";
import { tables } from "./ui/tables";
import { Themes, type Theme } from "./ui/theme";
import { wholeRun, type ViewName } from "./scene/viewport";

/** Packed arrays are removed from the page when they are read: they are its largest part. */
function takeData(name: string): string | null {
  const element = document.getElementById(`crumple-data-${name}`);
  if (!element) return null;
  const text = element.textContent;
  element.remove();
  return text;
}

/** `#frame=12&field=von_mises&view=%2Bx&theme=dark&picture`, or `live` in the live page, behind the file's name sets what is shown. */
function applyAddress(report: Report, themes: Themes, frames: number): void {
  const asked = new URLSearchParams(location.hash.slice(1));
  for (const what of ["picture", "live"]) if (asked.has(what)) document.documentElement.classList.add(what);
  const theme = asked.get("theme");
  if (theme === "light" || theme === "dark") themes.choose(theme as Theme);
  const field = asked.get("field");
  if (field !== null) report.panel.setField(field);
  // The whole run is in the picture, so that pictures of several frames go together.
  const view = asked.get("view");
  if (view) report.viewport.setView(view as ViewName, wholeRun);
  const frame = asked.get("frame");
  const share = /^(\d+)%$/.exec(frame ?? "");
  if (share) report.player.goTo(Math.round((Number(share[1]) / 100) * (frames - 1)));
  else if (frame) report.player.goTo(frame === "last" ? frames - 1 : Number(frame));
}

/** Curves and tables need no graphics. */
function showWithoutModel(run: Run, themes: Themes, root: HTMLElement): void {
  const reason = "The model cannot be shown: this browser has no WebGL 2, or it is switched off.";
  root.replaceChildren(h("p", { id: "crumple-message" }, reason), new Curves(run, themes, () => {}).element, tables(run));
}

async function start(): Promise<void> {
  // For the live page, which waits for it.
  document.documentElement.dataset["report"] = "reading";
  const root = document.getElementById("crumple")!;
  const message = document.getElementById("crumple-message")!;
  try {
    const meta = document.getElementById("crumple-meta");
    if (!meta) throw new Error("This page holds no result: crumple report puts one into it.");
    const run = new Run(JSON.parse(meta.textContent!) as Meta, takeData);
    document.title = `${run.meta.name} – crumple`;
    await run.loadPositions((share) => (message.textContent = `Reading the result: ${Math.round(100 * share)} %`));
    const themes = new Themes();
    if (!document.createElement("canvas").getContext("webgl2")) {
      showWithoutModel(run, themes, root);
      return;
    }
    const report = new Report(run, themes, root);
    applyAddress(report, themes, run.frames);
    report.viewport.draw();
    window.crumple = { report, run };
  } catch (fault) {
    message.textContent = `The report cannot be shown: ${fault instanceof Error ? fault.message : String(fault)}`;
    throw fault;
  } finally {
    document.documentElement.dataset["report"] = "settled";
  }
}

void start();
