#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a deck with every shell split into four, for a converged answer to compare with (docs/theory/hourglass.md).

    bench/refine_shells.py deck.k fine.k

The deck has one *NODE, one *ELEMENT_SHELL and at most one *SET_NODE_LIST, in fixed columns. A new node in the middle of an
edge joins the set if both ends of the edge are in it, one in the middle of a shell if all its nodes are.
"""
import sys
from pathlib import Path


def block(lines, keyword):
    """First and last line (excluded) of the data behind a keyword."""
    first = lines.index(keyword) + 1
    last = next((i for i in range(first, len(lines)) if lines[i].startswith("*")), len(lines))
    return first, last


def fields(line, width):
    return [line[i:i + width].strip() for i in range(0, len(line), width)]


class Mesh:
    def __init__(self, nodes, members):
        self.nodes = nodes
        self.members = members
        self.middles = {}
        self.last = max(nodes)

    def middle(self, *corners):
        """The node in the middle of some nodes, made where there is none yet."""
        key = tuple(sorted(corners))
        if key not in self.middles:
            self.last += 1
            self.middles[key] = self.last
            self.nodes[self.middles[key]] = [sum(self.nodes[c][axis] for c in corners) / len(corners) for axis in range(3)]
            if self.members.issuperset(corners):
                self.members.add(self.last)
        return self.middles[key]

    def split(self, corners):
        if corners[-1] == corners[-2]:
            a, b, c = corners[:3]
            ab, bc, ca = self.middle(a, b), self.middle(b, c), self.middle(c, a)
            return [(a, ab, ca, ca), (ab, b, bc, bc), (ca, bc, c, c), (ab, bc, ca, ca)]
        a, b, c, d = corners
        ab, bc, cd, da, centre = (self.middle(a, b), self.middle(b, c), self.middle(c, d), self.middle(d, a),
                                  self.middle(*corners))
        return [(a, ab, centre, da), (ab, b, bc, centre), (centre, bc, c, cd), (da, centre, cd, d)]


def refined(lines):
    first, last = block(lines, "*NODE")
    nodes = {int(line[:8]): [float(text) for text in fields(line[8:56], 16)] for line in lines[first:last]}
    members = set()
    if "*SET_NODE_LIST" in lines:
        start, end = block(lines, "*SET_NODE_LIST")
        members = {int(text) for line in lines[start + 1:end] for text in fields(line, 10) if text}
    mesh = Mesh(nodes, members)
    shells = []
    begin, stop = block(lines, "*ELEMENT_SHELL")
    for line in lines[begin:stop]:
        _, part, *corners = (int(text) for text in fields(line, 8))
        shells += [(part, *four) for four in mesh.split(corners + corners[-1:] * (4 - len(corners)))]
    new = {begin: ["".join(f"{n:8d}" for n in (i + 1, *shell)) for i, shell in enumerate(shells)],
           first: [f"{i:8d}" + "".join(f"{x:16.9g}" for x in at) for i, at in sorted(nodes.items())]}
    ends = {begin: stop, first: last}
    if members:
        ordered = [f"{n:10d}" for n in sorted(members)]
        new[start + 1] = ["".join(ordered[i:i + 8]) for i in range(0, len(ordered), 8)]
        ends[start + 1] = end
    for begin in sorted(new, reverse=True):
        lines[begin:ends[begin]] = new[begin]
    return lines


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    lines = Path(sys.argv[1]).read_text(encoding="utf-8").splitlines()
    Path(sys.argv[2]).write_text("\n".join(refined(lines)) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
