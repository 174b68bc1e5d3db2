// SPDX-License-Identifier: BSD-3-Clause
import { h } from "../ui/dom";
import { facts, shareDone, type Status } from "./status";

const names = { starting: "starting", running: "running", ended: "ended" };

/** The line above the report: how far the run is. */
export class Strip {
  private readonly state = h("span", { class: "state", role: "status" });
  private readonly facts = h("span", { class: "facts" });
  private readonly fault = h("span", { class: "fault" });
  private readonly done = h("i", { class: "done" });

  constructor(element: HTMLElement) {
    element.append(this.state, this.facts, this.fault, this.done);
  }

  show(status: Status): void {
    const ended = status.state === "ended";
    const text = ended ? `ended: ${status.termination ?? "?"}` : names[status.state];
    this.setState(text, ended ? (status.termination === "normal" ? "good" : "bad") : "");
    this.facts.textContent = facts(status).join("   ·   ");
    this.done.style.width = `${100 * (shareDone(status) ?? 0)}%`;
  }

  /** What the server said last is kept. */
  showGone(): void {
    this.setState("no answer any more: crumple has ended or was killed; this page stays as it is", "bad");
  }

  /** Why the present state is not shown; empty if it is. */
  setFault(text: string): void {
    this.fault.textContent = text;
  }

  private setState(text: string, kind: string): void {
    if (this.state.textContent === text) return;
    this.state.className = `state ${kind}`;
    this.state.replaceChildren(h("i", { class: "dot" }), text);
  }
}
