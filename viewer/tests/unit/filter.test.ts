// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { canFilter, coefficients, evenly, filtered } from "../../src/math/filter";

const sine = (frequency: number, rate: number, count: number) =>
  Float64Array.from({ length: count }, (_, i) => Math.sin((2 * Math.PI * frequency * i) / rate));

/** Size of the middle of a signal, where the ends do not matter. */
function amplitude(values: Float64Array): number {
  const middle = values.slice(values.length / 4, (3 * values.length) / 4);
  return middle.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
}

describe("SAE J211 filters", () => {
  it("has the coefficients of appendix C", () => {
    // wd = 2 pi CFC 2.0775, wa = sin(wd T/2) / cos(wd T/2) and so on, worked out apart from this program.
    const published: [number, number, number, number, number][] = [
      [60, 1e-4, 0.001452367, 1.889343224, -0.895152694],
      [180, 1e-4, 0.011796271, 1.670117463, -0.717302548],
      [600, 1e-4, 0.097184625, 0.945574009, -0.33431251],
      [1000, 5e-5, 0.071893097, 1.111586176, -0.399158564],
    ];
    for (const [cfc, interval, a0, b1, b2] of published) {
      const got = coefficients(cfc, interval);
      expect(got.a0).toBeCloseTo(a0, 8);
      expect(got.a1).toBeCloseTo(2 * a0, 8);
      expect(got.a2).toBeCloseTo(a0, 8);
      expect(got.b1).toBeCloseTo(b1, 8);
      expect(got.b2).toBeCloseTo(b2, 8);
    }
    const c = coefficients(180, 1e-4);
    // A constant goes through unchanged.
    expect(c.a0 + c.a1 + c.a2 + c.b1 + c.b2).toBeCloseTo(1, 14);
  });

  for (const cfc of [60, 180, 600])
    it(`class ${cfc} passes and stops what the standard's corridor asks for`, () => {
      const rate = 50 * cfc * 2.0775;
      const gain = (frequency: number) => amplitude(filtered(sine(frequency, rate, 20000), cfc, 1 / rate));
      // Two passes of a filter that is down by 3 dB at 2.0775 CFC are down by 6 dB there.
      expect(gain(2.0775 * cfc)).toBeCloseTo(0.5, 2);
      // At the class's own frequency within +0.5 and -1 dB, well below it nothing is lost.
      expect(20 * Math.log10(gain(cfc))).toBeGreaterThan(-1);
      expect(20 * Math.log10(gain(cfc))).toBeLessThan(0.5);
      expect(gain(cfc / 10)).toBeCloseTo(1, 3);
      // 24 dB an octave beyond.
      const steep = 20 * Math.log10(gain(8 * cfc) / gain(4 * cfc));
      expect(steep).toBeGreaterThan(-27);
      expect(steep).toBeLessThan(-22);
    });

  it("does not shift in time", () => {
    const pulse = new Float64Array(1001);
    for (let i = 0; i <= 1000; ++i) pulse[i] = Math.exp(-(((i - 500) / 20) ** 2));
    const out = filtered(pulse, 60, 1e-4);
    expect(out.indexOf(Math.max(...out))).toBe(500);
    for (let i = 0; i < 300; ++i) expect(out[500 - i]).toBeCloseTo(out[500 + i], 9);
  });

  it("keeps constants and straight lines to their ends", () => {
    const line = Float64Array.from({ length: 400 }, (_, i) => 3 + 0.01 * i);
    const out = filtered(line, 180, 1e-5);
    out.forEach((value, i) => expect(Math.abs(value - line[i])).toBeLessThan(5e-3));
    const flat = filtered(new Float64Array(300).fill(7), 180, 1e-5);
    for (const value of flat) expect(value).toBeCloseTo(7, 10);
  });

  it("refuses what is sampled too coarsely", () => {
    expect(canFilter(60, 1e-3)).toBe(true);
    expect(canFilter(600, 1e-3)).toBe(false);
    expect(canFilter(60, 0)).toBe(false);
    expect([...filtered(Float64Array.of(1, 5, 2, 8), 600, 1e-3)]).toEqual([1, 5, 2, 8]);
  });

  it("spreads samples evenly", () => {
    const even = evenly(Float64Array.of(0, 1, 4), Float64Array.of(0, 10, 40));
    expect([...even.times]).toEqual([0, 2, 4]);
    expect([...even.values]).toEqual([0, 20, 40]);
  });
});
