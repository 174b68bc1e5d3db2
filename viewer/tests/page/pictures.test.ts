// SPDX-License-Identifier: BSD-3-Clause
import { execFileSync } from "node:child_process";
import { readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { coverage, decodePng, difference, root } from "./page";

describe("crumple report --png", () => {
  it("draws the frames that are asked for", () => {
    const folder = join(root, "build", "viewer", "results", "box_beam");
    const names = ["report_1.png", "report_2.png"].map((name) => join(folder, name));
    for (const name of names) rmSync(name, { force: true });
    const program = join(root, "build", "release", "crumple");
    const asked = ["--png", "--frame", "0", "--frame", "100%", "--field", "von_mises", "--view=-y", "--width", "640", "--height", "400"];
    const out = execFileSync(program, ["report", folder, ...asked], { encoding: "utf8" });
    for (const name of names) expect(out).toContain(name.slice(-12));
    const [first, last] = names.map((name) => decodePng(readFileSync(name)));
    for (const picture of [first, last]) {
      expect([picture.width, picture.height]).toEqual([640, 400]);
      expect(coverage(picture)).toBeGreaterThan(0.05);
      // The ground is white.
      expect([...picture.bytes.slice(-picture.channels)].slice(0, 3)).toEqual([255, 255, 255]);
    }
    expect(difference(first, last)).toBeGreaterThan(0.02);
  });
});
