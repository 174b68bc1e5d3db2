// SPDX-License-Identifier: BSD-3-Clause
import { css, fringe } from "../math/colours";
import { short } from "../math/numbers";
import { h } from "./dom";

/** Bands of the fringe with the values between them. */
export class Legend {
  readonly element = h("div", { class: "legend" });

  show(title: string, low: number, high: number, bands: number, note: string): void {
    const steps = bands > 0 ? bands : 10;
    const rows = h("div", { class: "bands" });
    const bar = h("div", { class: "bar" });
    if (bands > 0) {
      for (let band = steps - 1; band >= 0; --band)
        bar.append(h("i", { style: `background:${css(fringe(steps > 1 ? band / (steps - 1) : 0))}` }));
    } else {
      const stops = Array.from({ length: 17 }, (_, i) => css(fringe(1 - i / 16)));
      bar.style.background = `linear-gradient(${stops.join(",")})`;
    }
    const numbers = h("div", { class: "numbers" });
    for (let i = steps; i >= 0; --i) {
      const value = low + ((high - low) * i) / steps;
      // What is a rounding error of the range is a zero.
      numbers.append(h("span", {}, short(Math.abs(value) < 1e-9 * Math.abs(high - low) ? 0 : value)));
    }
    rows.append(bar, numbers);
    this.element.replaceChildren(h("b", {}, title), h("small", {}, note), rows);
    this.element.hidden = false;
  }

  hide(): void {
    this.element.hidden = true;
  }
}
