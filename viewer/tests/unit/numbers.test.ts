// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { fringe, fringeTable } from "../../src/math/colours";
import { axisRange, interpolate, short, ticks, title } from "../../src/math/numbers";

describe("numbers", () => {
  it("are short", () => {
    expect([0, 12.34567, 0.00123456, 123456, 1.5e-7, -3, NaN, null].map((value) => short(value))).toEqual([
      "0", "12.35", "0.001235", "1.235e5", "1.5e-7", "−3", "–", "–",
    ]);
  });

  it("of an axis can be told apart", () => {
    expect(ticks([0.999999, 1, 1.000001])).toEqual(["0.999999", "1", "1.000001"]);
    expect(ticks([0, 5000, 10000])).toEqual(["0", "5000", "10000"]);
    expect(new Set(ticks([1e6, 1e6 + 1, 1e6 + 2])).size).toBe(3);
  });

  it("bound an axis with some room, and never too narrowly", () => {
    expect(axisRange(0, 10)).toEqual([0, 10.3]);
    const [low, high] = axisRange(1, 1 + 1e-12);
    expect(high - low).toBeGreaterThan(1e-6);
    expect(axisRange(null, null)).toEqual([0, 1]);
    expect(axisRange(0, 0)).toEqual([-1, 1]);
  });

  it("are interpolated and held at the ends", () => {
    const at = (x: number) => interpolate([0, 1, 3], [10, 20, 40], x);
    expect([-1, 0, 0.5, 2, 3, 9].map(at)).toEqual([10, 10, 15, 30, 40, 40]);
    expect(interpolate([], [], 1)).toBeNaN();
  });

  it("have headings", () => {
    expect(title("plastic_strain")).toBe("Plastic strain");
    expect(title("von_mises")).toBe("Von Mises stress");
  });
});

describe("fringe", () => {
  it("goes from blue to red", () => {
    const [low, high] = [fringe(0), fringe(1)];
    expect(low[2]).toBeGreaterThan(low[0]);
    expect(high[0]).toBeGreaterThan(high[2]);
  });

  it("has as many colours as bands", () => {
    const colours = (bands: number) => {
      const table = fringeTable(bands);
      return new Set(Array.from({ length: 256 }, (_, i) => table.slice(4 * i, 4 * i + 4).join())).size;
    };
    expect(colours(12)).toBe(12);
    expect(colours(0)).toBeGreaterThan(200);
  });
});
