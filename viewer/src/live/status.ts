// SPDX-License-Identifier: BSD-3-Clause
import { short } from "../math/numbers";

/** What /status says (crumple/live/run_status.cpp). What is not known is null. */
export interface Status {
  state: "starting" | "running" | "ended";
  /** "normal", "error" or "interrupted"; null before the end */
  termination: string | null;
  cycle: number;
  /** [time] */
  time: number;
  /** [time] */
  end_time: number | null;
  /** written so far */
  frames: number;
  seconds_to_go: number | null;
  ns_per_element_cycle: number | null;
}

/** Share of the run that is done, 0 to 1; null if its end is not known. */
export function shareDone(status: Status): number | null {
  if (status.end_time === null || !(status.end_time > 0)) return null;
  return Math.min(1, Math.max(0, status.time / status.end_time));
}

/** "12 s", "3:05", "1:02:45", as the program's own status line has it. */
export function duration(seconds: number): string {
  const whole = Math.round(seconds);
  if (whole < 60) return `${whole} s`;
  const two = (value: number) => String(value).padStart(2, "0");
  const minutes = Math.floor(whole / 60);
  if (minutes < 60) return `${minutes}:${two(whole % 60)}`;
  return `${Math.floor(minutes / 60)}:${two(minutes % 60)}:${two(whole % 60)}`;
}

/** The facts of the strip, in its order. */
export function facts(status: Status): string[] {
  if (status.state === "starting") return [];
  const share = shareDone(status);
  const running = status.state === "running";
  const texts = [share === null ? `t = ${short(status.time)}` : `t = ${short(status.time)} of ${short(status.end_time!)}`];
  if (running && share !== null) texts.push(`${Math.floor(100 * share)} %`);
  if (status.cycle > 0) texts.push(`cycle ${status.cycle}`);
  texts.push(status.frames === 1 ? "1 frame" : `${status.frames} frames`);
  if (status.ns_per_element_cycle !== null) texts.push(`${short(status.ns_per_element_cycle, 3)} ns per element and cycle`);
  if (running && status.seconds_to_go !== null) texts.push(`${duration(status.seconds_to_go)} to go`);
  return texts;
}
