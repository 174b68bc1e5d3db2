// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { parseBands, sampledBand } from "../../src/payload/bands";
import { contactForces, wallForces } from "../../src/payload/forces";
import { curveName, parseHistory, splitBy } from "../../src/payload/history";
import { boundsWithBands } from "../../src/ui/band_layer";

const csv =
  "time,curve,median,p5,p95\n" +
  "0,rwforc.normal[1],2,1,3\n2,rwforc.normal[1],4,3,7\n" +
  "0,rcforc.resultant[2 first],5,4,6\n1,rcforc.resultant[2 first],6,5,8\n";

describe("bands", () => {
  it("are kept by the names of their curves", () => {
    const bands = parseBands(csv);
    expect([...bands.keys()]).toEqual(["rwforc.normal[1]", "rcforc.resultant[2 first]"]);
    const band = bands.get("rwforc.normal[1]")!;
    expect([band.times, band.median, band.low, band.high].map((values) => [...values])).toEqual([
      [0, 2],
      [2, 4],
      [1, 3],
      [3, 7],
    ]);
  });

  it("have values at the times of a chart, none beyond their own", () => {
    const { median, low, high } = sampledBand(parseBands(csv).get("rwforc.normal[1]")!, [0, 1, 2, 3]);
    expect(median).toEqual([2, 3, 4, null]);
    expect(low).toEqual([1, 2, 3, null]);
    expect(high).toEqual([3, 5, 7, null]);
  });

  it("lie between the bounds of the axis, as far as they are seen", () => {
    const x = [0, 1, 2, 3];
    const band = sampledBand(parseBands(csv).get("rwforc.normal[1]")!, x);
    expect(boundsWithBands([2, 2.5], [band], x, [0, 3])).toEqual([1, 7]);
    expect(boundsWithBands([2, 2.5], [band], x, [0, 1])).toEqual([1, 5]);
    expect(boundsWithBands([0, 9], [band], x, [0, 3])).toEqual([0, 9]);
    expect(boundsWithBands([2, 2.5], [], x, [0, 3])).toEqual([2, 2.5]);
    expect(boundsWithBands([null, null], [band], x, [3, 4])).toEqual([null, null]);
  });
});

describe("names of curves", () => {
  it("are made of the file, the column and the item", () => {
    const glstat = parseHistory("time,kinetic\n0,1\n", "glstat");
    expect(curveName(glstat, "kinetic")).toBe("glstat.kinetic");
    const sides = parseHistory("time,interface,side,fx\n0,3,first,1\n", "rcforc");
    const first = splitBy(sides, ["interface", "side"]).get("3 first")!;
    expect(curveName(first, "fx")).toBe("rcforc.fx[3 first]");
  });

  it("lead from forces to their bands", () => {
    const walls = wallForces(parseHistory("time,wall,normal\n0,1,5\n", "rwforc"));
    const contacts = contactForces(parseHistory("time,interface,side,fx,fy,fz\n0,2,first,3,4,0\n0,2,second,-3,-4,0\n", "rcforc"));
    expect([...walls, ...contacts].map((force) => force.curve)).toEqual([...parseBands(csv).keys()]);
  });
});
