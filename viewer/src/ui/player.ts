// SPDX-License-Identifier: BSD-3-Clause
import { short } from "../math/numbers";
import { h } from "./dom";

/** Seconds that a run takes at speed 1. */
const runSeconds = 6;

export interface PlayerSettings {
  /** [time] */
  time: number;
  atEnd: boolean;
  playing: boolean;
  speed: string;
}

/** Time of the animation: slider, buttons, playing. The moment is a frame and a share of the way to the next. */
export class Player {
  readonly element: HTMLElement;
  onChange: () => void = () => {};
  private time: number;
  private playing = false;
  private readonly button = h("button", { class: "play", type: "button" });
  private readonly slider = h("input", { type: "range", min: 0, step: "any", "aria-label": "time" });
  private readonly clock = h("output", { class: "clock" });
  private readonly speed = h("select", { "aria-label": "speed" });

  constructor(private readonly times: number[]) {
    this.time = times[0];
    this.slider.max = String(times.length - 1);
    this.slider.value = "0";
    for (const factor of [0.1, 0.25, 0.5, 1, 2, 4]) this.speed.append(h("option", { value: factor }, `${factor}×`));
    this.speed.value = "1";
    this.slider.addEventListener("input", () => {
      this.play(false);
      this.setPlace(Number(this.slider.value));
    });
    const step = (text: string, title: string, move: () => void) =>
      h("button", { type: "button", title, "aria-label": title, click: move }, text);
    this.button.addEventListener("click", () => this.play(!this.playing));
    this.element = h(
      "div",
      { class: "player" },
      this.button,
      step("|◂", "first frame (Home)", () => this.goTo(0)),
      step("◂", "frame before (←)", () => this.step(-1)),
      step("▸", "next frame (→)", () => this.step(1)),
      step("▸|", "last frame (End)", () => this.goTo(this.last)),
      this.slider,
      this.clock,
      h("label", { class: "speed", title: "speed of playing" }, this.speed),
    );
    this.play(false);
    this.show();
  }

  private get last(): number {
    return this.times.length - 1;
  }

  get isPlaying(): boolean {
    return this.playing;
  }

  /** [time] */
  get now(): number {
    return this.time;
  }

  get frame(): number {
    return Math.min(this.last, Math.floor(this.place() + 1e-9));
  }

  get share(): number {
    return Math.max(0, this.place() - this.frame);
  }

  /** Frames, with the share of the way to the next behind the point. */
  place(): number {
    let low = 0;
    let high = this.last;
    if (high === 0 || this.time >= this.times[high]) return high;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= this.time) low = middle;
      else high = middle;
    }
    return low + Math.max(0, this.time - this.times[low]) / (this.times[high] - this.times[low] || 1);
  }

  setPlace(place: number): void {
    const bounded = Math.min(this.last, Math.max(0, place));
    const frame = Math.min(Math.max(0, this.last - 1), Math.floor(bounded));
    const next = Math.min(this.last, frame + 1);
    this.time = this.times[frame] + (bounded - frame) * (this.times[next] - this.times[frame]);
    this.show();
    this.onChange();
  }

  goTo(frame: number): void {
    this.play(false);
    this.setPlace(frame);
  }

  step(frames: number): void {
    const place = this.place();
    const from = frames < 0 ? Math.ceil(place - 1e-6) : Math.floor(place + 1e-6);
    this.goTo(from + frames);
  }

  play(on: boolean): void {
    this.playing = on && this.last > 0;
    if (this.playing && this.time >= this.times[this.last]) this.setPlace(0);
    this.button.textContent = this.playing ? "❚❚" : "▶";
    this.button.title = this.playing ? "pause (space)" : "play (space)";
    this.button.setAttribute("aria-label", this.button.title);
  }

  toggle(): void {
    this.play(!this.playing);
  }

  advance(seconds: number): void {
    if (!this.playing) return;
    const whole = this.times[this.last] - this.times[0];
    this.time += (seconds * Number(this.speed.value) * whole) / runSeconds;
    if (this.time >= this.times[this.last]) {
      this.time = this.times[this.last];
      this.play(false);
    }
    this.show();
    this.onChange();
  }

  get settings(): PlayerSettings {
    return { time: this.time, atEnd: !this.playing && this.place() === this.last, playing: this.playing, speed: this.speed.value };
  }

  /** What stood at the end of an earlier state of the run goes to its new end. */
  set settings(kept: PlayerSettings) {
    this.speed.value = kept.speed;
    this.time = kept.time;
    this.setPlace(kept.atEnd ? this.last : this.place());
    this.play(kept.playing);
  }

  private show(): void {
    const place = this.place();
    this.slider.value = String(place);
    const frame = Math.round(place);
    this.clock.textContent = `t = ${short(this.time)}   frame ${frame} / ${this.last}`;
    this.slider.setAttribute("aria-valuetext", this.clock.textContent);
  }
}
