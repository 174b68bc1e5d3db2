// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import type { Run } from "../../src/payload/run";
import { foundPick, namedPick } from "../../src/ui/report_settings";

const before = { nodeId: [11, 12, 13, 14], elementId: [5, 5], part: [1, 2] } as unknown as Run;
const after = { nodeId: [9, 14, 11, 13, 12], elementId: [4, 5, 5], part: [1, 1, 2] } as unknown as Run;

it("finds a pick again where erosion has shown other elements", () => {
  const pick = { cell: 1, node: 3, outline: [0, 1, 1, 3] };
  const named = namedPick(before, pick);
  expect(named).toEqual({ element: 5, part: 2, node: 14, outline: [11, 12, 12, 14] });
  expect(foundPick(before, named)).toEqual(pick);
  expect(foundPick(after, named)).toEqual({ cell: 2, node: 1, outline: [2, 4, 4, 1] });
});

it("drops a pick of what is not there any more", () => {
  expect(foundPick(after, { element: 6, part: 2, node: 14, outline: [] })).toBeNull();
  expect(foundPick(after, { element: 5, part: 2, node: 8, outline: [] })).toBeNull();
  expect(foundPick(after, { element: 5, part: 2, node: 9, outline: [8, 9] })).toBeNull();
});
