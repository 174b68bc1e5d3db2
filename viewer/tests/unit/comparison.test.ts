// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { percent, together } from "../../src/compare/comparison";

describe("curves over each other", () => {
  it("have values at the times of both", () => {
    const both = together([[0, 1, 2], [0, 10, 20]], [[0.5, 1], [7, 9]]);
    expect(both.x).toEqual([0, 0.5, 1, 2]);
    expect(both.first).toEqual([0, 5, 10, 20]);
    expect(both.second).toEqual([null, 7, 9, null]);
  });
});

describe("shares", () => {
  it("are told in percent, as factors or as what they are not", () => {
    expect(percent(0)).toBe("0 %");
    expect(percent(0.01234)).toBe("1.23 %");
    expect(percent(1e-8)).toBe("1e-6 %");
    expect(percent(264000)).toBe("× 2.64e5");
    expect(percent(null)).toBe("ref. zero");
  });
});
