// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { duration, facts, shareDone, type Status } from "../../src/live/status";

const running: Status = {
  state: "running",
  termination: null,
  cycle: 1200,
  time: 0.5,
  end_time: 2,
  frames: 3,
  seconds_to_go: 65.4,
  ns_per_element_cycle: 61.25,
};

it("tells how far a run is", () => {
  expect(shareDone(running)).toBe(0.25);
  expect(facts(running)).toEqual(["t = 0.5 of 2", "25 %", "cycle 1200", "3 frames", "61.3 ns per element and cycle", "1:05 to go"]);
});

it("leaves out what is not known, and what an ended run has no more", () => {
  expect(facts({ ...running, end_time: null, seconds_to_go: null, ns_per_element_cycle: null, cycle: 0, frames: 1 })).toEqual(["t = 0.5", "1 frame"]);
  expect(facts({ ...running, state: "ended", time: 2 })).toEqual(["t = 2 of 2", "cycle 1200", "3 frames", "61.3 ns per element and cycle"]);
  expect(facts({ ...running, state: "starting" })).toEqual([]);
  expect(shareDone({ ...running, end_time: null })).toBeNull();
  expect(shareDone({ ...running, time: 3 })).toBe(1);
});

it("writes durations as the program does", () => {
  expect([0.4, 12, 59.6, 185, 3765].map(duration)).toEqual(["0 s", "12 s", "1:00", "3:05", "1:02:45"]);
});
