// SPDX-License-Identifier: BSD-3-Clause
import { Vector3, type Camera } from "three";

const names = ["X", "Y", "Z"];
const colours = ["#d05b4c", "#4f9a4f", "#4a7fd0"];
const namespace = "http://www.w3.org/2000/svg";

/** The directions of the axes in the corner of the picture. */
export class Triad {
  readonly element: SVGSVGElement;
  private readonly lines: SVGLineElement[] = [];
  private readonly labels: SVGTextElement[] = [];

  constructor() {
    this.element = document.createElementNS(namespace, "svg");
    this.element.setAttribute("viewBox", "-50 -50 100 100");
    this.element.setAttribute("class", "triad");
    this.element.setAttribute("aria-hidden", "true");
    names.forEach((name, i) => {
      const line = document.createElementNS(namespace, "line");
      line.setAttribute("stroke", colours[i]);
      line.setAttribute("stroke-width", "3");
      line.setAttribute("stroke-linecap", "round");
      const label = document.createElementNS(namespace, "text");
      label.textContent = name;
      label.setAttribute("fill", colours[i]);
      this.lines.push(line);
      this.labels.push(label);
      this.element.append(line, label);
    });
  }

  update(camera: Camera): void {
    const inverse = camera.quaternion.clone().invert();
    const tips = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].map((v) => v.applyQuaternion(inverse));
    tips.forEach((tip, i) => {
      this.lines[i].setAttribute("x2", String(30 * tip.x));
      this.lines[i].setAttribute("y2", String(-30 * tip.y));
      this.labels[i].setAttribute("x", String(40 * tip.x));
      this.labels[i].setAttribute("y", String(-40 * tip.y));
    });
    // The axis that points at the viewer is painted last.
    [0, 1, 2].sort((a, b) => tips[a].z - tips[b].z).forEach((i) => this.element.append(this.lines[i], this.labels[i]));
  }
}
