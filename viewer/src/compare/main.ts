// SPDX-License-Identifier: BSD-3-Clause
import "uplot/dist/uPlot.min.css";
import "../style.css";
import "./compare.css";
import { Themes, type Theme } from "../ui/theme";
import { ComparePage } from "./compare_page";
import type { Comparison } from "./comparison";

declare global {
  interface Window {
    /** for tests */
    crumpleComparison?: { comparison: Comparison; themes: Themes };
  }
}

function start(): void {
  const root = document.getElementById("crumple")!;
  const message = document.getElementById("crumple-message")!;
  try {
    const data = document.getElementById("crumple-comparison");
    if (!data) throw new Error("this page holds no comparison: crumple compare --html puts one into it.");
    const comparison = JSON.parse(data.textContent!) as Comparison;
    const themes = new Themes();
    const theme = new URLSearchParams(location.hash.slice(1)).get("theme");
    if (theme === "light" || theme === "dark") themes.choose(theme as Theme);
    document.title = `${comparison.reference.source} – ${comparison.other.source} – crumple`;
    new ComparePage(comparison, themes, root);
    window.crumpleComparison = { comparison, themes };
  } catch (fault) {
    message.textContent = `The comparison cannot be shown: ${fault instanceof Error ? fault.message : String(fault)}`;
    throw fault;
  }
}

start();
