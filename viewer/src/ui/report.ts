// SPDX-License-Identifier: BSD-3-Clause
import { Vector3 } from "three";
import { short } from "../math/numbers";
import type { Run } from "../payload/run";
import { ModelView } from "../scene/model_view";
import { Picker, type Pick } from "../scene/picker";
import { Triad } from "../scene/triad";
import { Viewport, type ViewName } from "../scene/viewport";
import { Walls } from "../scene/walls";
import { Curves } from "./curves";
import { boxOf, h, setBox } from "./dom";
import { keyHelp, listenToKeys } from "./keys";
import { Legend } from "./legend";
import { PartList } from "./part_list";
import { Player } from "./player";
import { foundPick, namedPick, type ReportSettings } from "./report_settings";
import { Selection } from "./selection";
import { SidePanel } from "./side_panel";
import { tables } from "./tables";
import type { Themes } from "./theme";

/** The whole page. */
export class Report {
  readonly view: ModelView;
  readonly viewport: Viewport;
  readonly player: Player;
  readonly panel: SidePanel;
  readonly parts: PartList;
  readonly selection: Selection;
  private readonly walls: Walls;
  private readonly picker: Picker;
  private readonly curves: Curves;
  private readonly triad = new Triad();
  private readonly legend = new Legend();
  private readonly help: HTMLDialogElement;
  private readonly side = h("aside", {});
  private readonly stage = h("div", { class: "stage" });
  private readonly paper = h("img", { class: "paper", alt: "the model as it was shown when this was printed" });
  private readonly caption = h("div", { class: "caption" });
  picked: Pick | null = null;

  constructor(
    private readonly run: Run,
    private readonly themes: Themes,
    root: HTMLElement,
  ) {
    this.help = this.makeHelp();
    const animation = h("section", { id: "animation" });
    root.replaceChildren(this.header(), animation);
    const host = h("div", { class: "canvas" });
    this.stage.append(host, this.legend.element, this.triad.element, this.viewButtons(), this.caption, this.paper);
    this.view = new ModelView(run);
    this.walls = new Walls(run, this.view);
    this.player = new Player(run.meta.times);
    const side = this.side;
    animation.append(this.stage, side, this.player.element);
    this.viewport = new Viewport(host, this.view);
    this.viewport.scene.add(this.walls.group);
    this.viewport.afterDraw = () => this.triad.update(this.viewport.camera);
    this.viewport.beforeFrame = (passed) => this.player.advance(passed);
    const redraw = () => this.viewport.invalidate();
    this.panel = new SidePanel(run, this.view, this.legend, this.walls, redraw);
    this.panel.viewDirection = () => this.viewport.camera.getWorldDirection(new Vector3()).negate();
    this.parts = new PartList(run, this.view, redraw);
    const seek = (time: number) => this.seek(time);
    this.selection = new Selection(run, this.panel.sources, themes, seek);
    side.append(this.panel.element, this.parts.element, this.selection.element);
    this.picker = new Picker(run, this.view);
    this.curves = new Curves(run, themes, seek);
    root.append(this.curves.element, tables(run), this.help);
    this.player.onChange = () => this.showMoment();
    this.listenToPicks(host);
    this.listenToPrint();
    this.listen();
    this.panel.setField(this.panel.sources[0]?.name ?? "");
    this.showMoment();
    themes.watch(() => this.paint());
  }

  /** Names nothing by its place in this page's arrays: a later state of the same run has others. */
  get settings(): ReportSettings {
    const { eye, target, up } = this.viewport.sight;
    return {
      eye: this.view.toModel(eye),
      target: this.view.toModel(target),
      up: up.toArray(),
      theme: this.themes.choice,
      player: this.player.settings,
      panel: this.panel.settings,
      hiddenParts: this.parts.hidden,
      curves: this.curves.settings,
      picked: this.picked && namedPick(this.run, this.picked),
      history: this.selection.shown,
      scroll: [window.scrollY, this.side.scrollTop],
    };
  }

  set settings(kept: ReportSettings) {
    this.themes.choose(kept.theme);
    this.panel.settings = kept.panel;
    this.parts.hidden = kept.hiddenParts;
    this.setPick(kept.picked && foundPick(this.run, kept.picked));
    this.selection.shown = kept.history;
    this.curves.settings = kept.curves;
    this.player.settings = kept.player;
    this.viewport.sight = {
      eye: this.view.toWorld(kept.eye),
      target: this.view.toWorld(kept.target),
      up: new Vector3(...kept.up),
    };
    window.scrollTo({ top: kept.scroll[0], behavior: "instant" });
    this.side.scrollTop = kept.scroll[1];
    this.viewport.draw();
  }

  seek(time: number): void {
    this.player.play(false);
    const times = this.run.meta.times;
    const next = times.findIndex((other) => other >= time);
    if (next <= 0) this.player.setPlace(next < 0 ? times.length - 1 : 0);
    else this.player.setPlace(next - 1 + (time - times[next - 1]) / (times[next] - times[next - 1]));
  }

  /** Looks at what is there now. */
  setView(name: ViewName): void {
    this.viewport.setView(name, this.view.ball(this.player.frame));
  }

  private showMoment(): void {
    const { frame, share } = this.player;
    const shown = share < 0.5 ? frame : frame + 1;
    this.view.setTime(frame, share);
    this.walls.setTime(frame, share, this.player.now);
    this.panel.setFrame(shown);
    // Curves are drawn anew for a moving line: not at every picture while playing.
    this.selection.setMoment(shown, this.player.now);
    this.curves.setMoment(this.player.now);
    this.caption.textContent = `t = ${short(this.player.now)}`;
    this.viewport.invalidate();
  }

  pickAt(x: number, y: number): Pick | null {
    const { frame, share } = this.player;
    const { renderer, camera } = this.viewport;
    this.setPick(this.picker.pick(renderer, camera, x, y, frame, share));
    return this.picked;
  }

  private setPick(pick: Pick | null): void {
    this.picked = pick;
    this.view.setMarks(pick?.node ?? null, pick?.outline ?? [], pick?.cell ?? 0);
    this.selection.set(pick, this.panel.current?.name);
    this.curves.setPickedNode(pick?.node ?? null);
    this.viewport.invalidate();
  }

  private listenToPicks(host: HTMLElement): void {
    let start: PointerEvent | null = null;
    host.addEventListener("pointerdown", (event) => (start = event.isPrimary && event.button === 0 ? event : null));
    host.addEventListener("pointerup", (event) => {
      if (!start || !event.isPrimary) return;
      const moved = Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY);
      const late = event.timeStamp - start.timeStamp > 600;
      start = null;
      if (moved > 5 || late) return;
      const box = host.getBoundingClientRect();
      this.pickAt(event.clientX - box.left, event.clientY - box.top);
    });
  }

  /** Paper gets a picture: browsers may find the canvas empty when they print. */
  private listenToPrint(): void {
    window.addEventListener("beforeprint", () => {
      this.viewport.draw();
      this.paper.src = this.viewport.renderer.domElement.toDataURL("image/png");
    });
  }

  private paint(): void {
    const dark = this.themes.theme === "dark";
    this.view.setTints(dark ? [0, 0, 0, 0.5] : [0.06, 0.08, 0.1, 0.42], dark ? [0.8, 0.85, 0.9, 0.3] : [0.2, 0.25, 0.3, 0.3]);
    this.walls.setColour(dark ? "#8fa3b5" : "#5f7386");
    this.viewport.setGround(this.themes.colour("stage"));
    this.viewport.draw();
  }

  private listen(): void {
    listenToKeys({
      play: () => this.player.toggle(),
      step: (frames) => this.player.step(frames),
      ends: (last) => this.player.goTo(last ? this.run.frames - 1 : 0),
      view: (name) => this.setView(name),
      toggle: (what) => setBox(this.panel[what], !boxOf(this.panel[what]).checked),
      theme: () => this.themes.toggle(),
      unpick: () => this.setPick(null),
      help: () => (this.help.open ? this.help.close() : this.help.showModal()),
    });
  }

  private viewButtons(): HTMLElement {
    const names: [ViewName, string][] = [["iso", "fit"], ["+x", "+x"], ["-x", "−x"], ["+y", "+y"], ["-y", "−y"], ["+z", "+z"], ["-z", "−z"]];
    return h(
      "div",
      { class: "views", role: "group", "aria-label": "view" },
      ...names.map(([name, text]) => h("button", { type: "button", click: () => this.setView(name) }, text)),
    );
  }

  private header(): HTMLElement {
    const record = this.run.meta.run;
    const termination = record?.termination ?? "no run.json: not ended, or killed";
    const failed = (record?.checks ?? []).filter((check) => !check.pass).length;
    const badge = h("span", { class: !record ? "badge bad unended" : record.termination === "normal" ? "badge good" : "badge bad", title: record?.reason }, termination);
    const checks = record?.checks
      ? h("a", { class: failed > 0 ? "badge warn" : "badge good", href: "#tables" }, failed > 0 ? `${failed} of ${record.checks.length} checks fail` : `${record.checks.length} checks pass`)
      : null;
    const link = (text: string, target: string) => h("a", { href: target }, text);
    const button = (text: string, label: string, click: () => void) =>
      h("button", { type: "button", title: label, "aria-label": label, click }, text);
    return h(
      "header",
      {},
      h("div", { class: "name" }, h("b", {}, this.run.meta.name), h("span", {}, record?.title ?? "")),
      badge,
      checks,
      h("nav", {}, link("Animation", "#animation"), link("Curves", "#curves"), link("Tables", "#tables")),
      button("◐", "light or dark (t)", () => this.themes.toggle()),
      button("print", "print or save as PDF", () => window.print()),
      button("?", "keys (?)", () => this.help.showModal()),
    );
  }

  private makeHelp(): HTMLDialogElement {
    const rows = keyHelp.flatMap(([key, text]) => [h("dt", {}, key), h("dd", {}, text)]);
    const dialog = h("dialog", {}, h("h3", {}, "Keys, mouse, touch"), h("dl", {}, ...rows));
    dialog.append(h("form", { method: "dialog" }, h("button", {}, "close")));
    return dialog;
  }
}
