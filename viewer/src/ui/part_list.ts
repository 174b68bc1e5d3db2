// SPDX-License-Identifier: BSD-3-Clause
import { css } from "../math/colours";
import type { Run } from "../payload/run";
import type { ModelView } from "../scene/model_view";
import { h } from "./dom";

/** Parts to switch on and off; a double click shows one alone. */
export class PartList {
  readonly element: HTMLElement;
  private readonly boxes: HTMLInputElement[] = [];

  constructor(
    run: Run,
    private readonly view: ModelView,
    private readonly redraw: () => void,
  ) {
    const titles = new Map((run.meta.run?.parts ?? []).map((part) => [part.id, part.title]));
    const rows = view.parts.map((id, i) => {
      const box = h("input", { type: "checkbox", "data-part": id });
      box.checked = true;
      box.addEventListener("change", () => this.set(i, box.checked));
      this.boxes.push(box);
      const swatch = h("i", { class: "swatch", style: `background:${css(view.partColour(i))}` });
      const row = h("label", { class: "part", title: "double click: this part alone" }, box, swatch, h("b", {}, String(id)), h("span", {}, titles.get(id) ?? ""));
      row.addEventListener("dblclick", (event) => {
        event.preventDefault();
        this.setAll((other) => other === i);
      });
      return row;
    });
    const button = (text: string, wanted: (part: number) => boolean) =>
      h("button", { type: "button", click: () => this.setAll(wanted) }, text);
    this.element = h(
      "details",
      { class: "parts", open: true },
      h("summary", {}, `Parts (${view.parts.length})`),
      h("div", { class: "buttons" }, button("all", () => true), button("none", () => false), button("invert", (part) => !view.isPartVisible(part))),
      h("div", { class: "list" }, ...rows),
    );
  }

  set(part: number, visible: boolean): void {
    this.view.setPartVisible(part, visible);
    this.boxes[part].checked = visible;
    this.redraw();
  }

  /** ids of the parts that are switched off */
  get hidden(): number[] {
    return this.view.parts.filter((_, part) => !this.view.isPartVisible(part));
  }

  set hidden(ids: number[]) {
    this.view.parts.forEach((id, part) => this.set(part, !ids.includes(id)));
  }

  private setAll(wanted: (part: number) => boolean): void {
    this.boxes.map((_, part) => wanted(part)).forEach((visible, part) => this.set(part, visible));
  }
}
