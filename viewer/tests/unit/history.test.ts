// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { contactForces, filteredForce, guessTimeUnit, sampleRate, wallForces } from "../../src/payload/forces";
import { parseHistory, splitBy } from "../../src/payload/history";

describe("histories", () => {
  it("have numbers and texts by column", () => {
    const history = parseHistory("time,kind,dt\n0,shell,1e-3\n0.5,beam,\n");
    expect(history.rows).toBe(2);
    expect([...history.number["time"]]).toEqual([0, 0.5]);
    expect(history.text["kind"]).toEqual(["shell", "beam"]);
    expect(history.number["dt"][1]).toBeNaN();
  });

  it("without rows are empty", () => {
    expect(parseHistory("time,a\n").rows).toBe(0);
    expect(parseHistory("").rows).toBe(0);
  });

  it("are split by item in the order of the file", () => {
    const parts = splitBy(parseHistory("time,wall,f\n0,7,1\n0,3,2\n1,7,3\n1,3,4\n"), ["wall"]);
    expect([...parts.keys()]).toEqual(["7", "3"]);
    expect([...parts.get("3")!.number["f"]]).toEqual([2, 4]);
  });
});

describe("forces", () => {
  it("of walls are the normal ones", () => {
    const forces = wallForces(parseHistory("time,wall,normal,fx,fy,fz\n0,1,5,-5,0,0\n1,1,6,-6,0,0\n"));
    expect(forces.map((force) => [force.label, [...force.values]])).toEqual([["wall 1", [5, 6]]]);
  });

  it("of contacts are resultants of the first sides and of transducers", () => {
    const csv = "time,interface,side,fx,fy,fz,mass\n0,1,single,0,0,0,1\n0,2,first,3,4,0,1\n0,2,second,-3,-4,0,1\n0,9,transducer,0,0,2,1\n";
    expect(contactForces(parseHistory(csv)).map((force) => [force.label, force.values[0]])).toEqual([
      ["contact 2", 5],
      ["transducer 9", 2],
    ]);
  });

  it("are filtered in the deck's unit of time", () => {
    const times = Float64Array.from({ length: 2001 }, (_, i) => i * 0.01); // ms
    const noisy = times.map((_, i) => 10 + (i % 2 === 0 ? 3 : -3));
    expect(sampleRate(times, 1e-3)).toBeCloseTo(1e5, 6);
    const force = { label: "wall 1", curve: "rwforc.normal[1]", times, values: noisy };
    const smooth = filteredForce(force, { cfc: 180, secondsPerUnit: 1e-3 });
    for (const value of smooth.values.slice(700, 1300)) expect(value).toBeCloseTo(10, 2);
    const raw = filteredForce(force, { cfc: 0, secondsPerUnit: 1e-3 });
    expect(raw).toBe(force);
  });

  it("know a unit of time from the deck's units, else guess", () => {
    expect(guessTimeUnit("kg, mm, ms", 0.01)).toBe("ms");
    expect(guessTimeUnit("t, mm, s", 20)).toBe("s");
    expect(guessTimeUnit("", 20)).toBe("ms");
    expect(guessTimeUnit(undefined, 0.012)).toBe("s");
  });
});
