// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { Mesh } from "../../src/payload/run";
import { edgeGeometry, faceGeometry, lineGeometry, type CellFacts } from "../../src/scene/geometry";

/** Faces as [four nodes, cell, behind]; columns as Run has them. */
function meshOf(faces: number[][], lines: number[][] = []): Mesh {
  const columns = (rows: number[][], width: number) =>
    Int32Array.from(Array.from({ length: width }, (_, column) => rows.map((row) => row[column])).flat());
  return { faceCount: faces.length, faces: columns(faces, 6), lineCount: lines.length, lines: columns(lines, 3) };
}

const facts = (part: number[], death: number[]): CellFacts => ({
  part: Uint32Array.from(part),
  death: Int32Array.from(death),
  frames: 10,
});

describe("geometry", () => {
  it("splits quadrilaterals and keeps triangles", () => {
    const geometry = faceGeometry(meshOf([[0, 1, 2, 3, 0, -1], [1, 4, 2, 2, 1, -1]]), facts([0, 0], [10, 10]));
    expect(geometry.getAttribute("items").count).toBe(7);
    expect([...geometry.getIndex()!.array]).toEqual([0, 1, 2, 0, 2, 3, 4, 5, 6]);
  });

  it("shows a face from the death of the cell behind it to that of its own", () => {
    const geometry = faceGeometry(meshOf([[0, 1, 2, 3, 0, 1]]), facts([0, 0], [8, 3]));
    const life = geometry.getAttribute("life");
    expect([life.getX(0), life.getY(0)]).toEqual([3, 8]);
  });

  it("draws an edge of two lasting faces once, of parts apart and of mortal faces each", () => {
    const two = [[0, 1, 2, 3, 0, -1], [1, 4, 5, 2, 1, -1]];
    const edges = (part: number[], death: number[]) =>
      edgeGeometry(meshOf(two), facts(part, death), 6).drawRange.count / 2;
    expect(edges([0, 0], [10, 10])).toBe(7);
    expect(edges([0, 1], [10, 10])).toBe(8);
    expect(edges([0, 0], [10, 4])).toBe(8);
  });

  it("numbers lines behind the faces", () => {
    const geometry = lineGeometry(meshOf([[0, 1, 2, 3, 0, -1]], [[4, 5, 1]]), facts([0, 2], [10, 10]));
    const items = geometry.getAttribute("items");
    expect([items.getX(0), items.getX(1), items.getY(0), items.getZ(0), items.getW(0)]).toEqual([4, 5, 1, 2, 1]);
  });
});
