// SPDX-License-Identifier: BSD-3-Clause
import type { ViewName } from "../scene/viewport";

export interface KeyActions {
  play(): void;
  step(frames: number): void;
  ends(last: boolean): void;
  view(name: ViewName): void;
  toggle(what: "edges" | "ghost" | "section"): void;
  theme(): void;
  unpick(): void;
  help(): void;
}

const views: Record<string, ViewName> = { "0": "iso", "1": "+x", "2": "+y", "3": "+z", "4": "-x", "5": "-y", "6": "-z", f: "iso" };

export const keyHelp: [string, string][] = [
  ["space", "play, pause"],
  ["← →", "frame before, next; with shift ten"],
  ["Home End", "first, last frame"],
  ["0 or f", "whole model from an angle"],
  ["1 2 3 4 5 6", "from +x, +y, +z, −x, −y, −z"],
  ["e g s", "edges, undeformed, section"],
  ["t", "light or dark"],
  ["Esc", "drop what was picked"],
  ["drag, wheel", "turn, zoom; right button or shift moves"],
  ["touch", "one finger turns, two zoom and move, a tap picks"],
];

export function listenToKeys(actions: KeyActions): void {
  window.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || /^(SELECT|TEXTAREA)$/.test(target.tagName)) return;
    if (target instanceof HTMLInputElement && target.type !== "checkbox" && target.type !== "range") return;
    const key = event.key;
    // The player's slider goes by frames; others keep their own arrows.
    const slider = target instanceof HTMLInputElement && target.type === "range" && !target.closest(".player");
    if (slider && /^(Arrow|Home|End)/.test(key)) return;
    const stride = event.shiftKey ? 10 : 1;
    const moving: Record<string, () => void> = {
      ArrowLeft: () => actions.step(-stride),
      ArrowRight: () => actions.step(stride),
      Home: () => actions.ends(false),
      End: () => actions.ends(true),
      Escape: () => actions.unpick(),
      e: () => actions.toggle("edges"),
      g: () => actions.toggle("ghost"),
      s: () => actions.toggle("section"),
      t: () => actions.theme(),
      "?": () => actions.help(),
    };
    // A button that has the focus is pressed by the space bar as everywhere.
    if (key === " " && !(target instanceof HTMLButtonElement) && !(target instanceof HTMLInputElement)) moving[" "] = () => actions.play();
    const view = views[key];
    const act = moving[key] ?? (view ? () => actions.view(view) : undefined);
    if (!act) return;
    event.preventDefault();
    act();
  });
}
