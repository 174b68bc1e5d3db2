// SPDX-License-Identifier: BSD-3-Clause
import type { Run } from "../payload/run";
import type { Pick } from "../scene/picker";
import type { CurveSettings } from "./curves";
import type { PlayerSettings } from "./player";
import type { PanelSettings } from "./side_panel";
import type { Theme } from "./theme";

export type Triple = [number, number, number];

/** A pick by ids. */
export interface NamedPick {
  element: number;
  part: number;
  node: number;
  outline: number[];
}

/** What the user has set in a report, for that of a later state of the same run. */
export interface ReportSettings {
  /** [length] */
  eye: Triple;
  /** what is looked at [length] */
  target: Triple;
  up: Triple;
  /** null follows the system */
  theme: Theme | null;
  player: PlayerSettings;
  panel: PanelSettings;
  /** ids */
  hiddenParts: number[];
  curves: CurveSettings;
  picked: NamedPick | null;
  /** field whose history is shown */
  history: string;
  /** of the page and of its side [px] */
  scroll: [number, number];
}

export function namedPick(run: Run, pick: Pick): NamedPick {
  return {
    element: run.elementId[pick.cell],
    part: run.part[pick.cell],
    node: run.nodeId[pick.node],
    outline: pick.outline.map((node) => run.nodeId[node]),
  };
}

/** Null if the run shows the element or one of the nodes no more. */
export function foundPick(run: Run, named: NamedPick): Pick | null {
  const cell = run.elementId.findIndex((id, place) => id === named.element && run.part[place] === named.part);
  const places = new Map([named.node, ...named.outline].map((id) => [id, run.nodeId.indexOf(id)]));
  if (cell < 0 || [...places.values()].includes(-1)) return null;
  return { cell, node: places.get(named.node)!, outline: named.outline.map((id) => places.get(id)!) };
}
