# SPDX-License-Identifier: BSD-3-Clause
"""The script that splits the shells of a deck."""
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import refine_shells  # noqa: E402

DECK = """*KEYWORD
*SET_NODE_LIST
         1
         1         2
*PART
*NODE
       1              0.              0.              0.
       2              2.              0.              0.
       3              2.              2.              0.
       4              0.              2.              0.
       5              4.              0.              2.
*ELEMENT_SHELL
       7       3       1       2       3       4
       8       3       2       5       3       3
*END"""


class RefineShells(unittest.TestCase):
    def setUp(self):
        lines = refine_shells.refined(DECK.split("\n"))
        self.lines = lines
        first, last = refine_shells.block(lines, "*NODE")
        self.nodes = {int(line[:8]): [float(line[8 + 16 * i:24 + 16 * i]) for i in range(3)] for line in lines[first:last]}
        first, last = refine_shells.block(lines, "*ELEMENT_SHELL")
        self.shells = [[int(text) for text in line.split()] for line in lines[first:last]]

    def test_neighbours_share_the_nodes_of_their_edge(self):
        # 5 nodes, 6 edges' middles of which one is shared, and the middle of the quadrilateral.
        self.assertEqual(len(self.nodes), 5 + 4 + 2 + 1)
        self.assertEqual([shell[0] for shell in self.shells], list(range(1, 9)))
        self.assertEqual({shell[1] for shell in self.shells}, {3})

    def test_area_stays(self):
        def cross(a, b):
            return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

        total = [0.0, 0.0, 0.0]
        for shell in self.shells:
            a, b, c, d = (self.nodes[node] for node in shell[2:])
            area = cross([c[i] - a[i] for i in range(3)], [d[i] - b[i] for i in range(3)])
            total = [total[i] + 0.5 * area[i] for i in range(3)]
        self.assertEqual(total, [-2.0, 0.0, 6.0])

    def test_middles_of_edges_of_the_set_join_it(self):
        first, last = refine_shells.block(self.lines, "*SET_NODE_LIST")
        members = {int(text) for line in self.lines[first + 1:last] for text in line.split()}
        self.assertEqual(members, {1, 2, next(n for n, x in self.nodes.items() if x == [1, 0, 0])})


if __name__ == "__main__":
    unittest.main()
