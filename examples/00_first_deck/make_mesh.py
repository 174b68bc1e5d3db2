#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes mesh.k: a square tube of shells, 40 x 40 mm and 150 mm long, with its lowest ring of nodes as set 1. [mm]

    ./make_mesh.py > mesh.k
    ./make_mesh.py --element-size 2.5 > finer_mesh.k
"""

import argparse
import math

WIDTH = 40.0
LENGTH = 150.0
DENT = 0.2  # faces in and out by turns over the highest FOLD: where the first fold is to form
FOLD = 28.0


def dent_at(z, across):
    """How far a face is pushed out at height z, `across` from its middle."""
    below_top = LENGTH - z
    if below_top >= FOLD:
        return 0.0
    return DENT * math.sin(math.pi * below_top / FOLD) ** 2 * math.cos(math.pi * across / WIDTH)


def ring(cells, z):
    """Nodes of one ring, face by face."""
    for face in range(4):
        sign = 1 if face % 2 == 0 else -1
        angle = face * math.pi / 2
        for j in range(cells):
            across = -WIDTH / 2 + WIDTH * j / cells
            out = WIDTH / 2 + (sign * dent_at(z, across) if j > 0 else 0.0)
            yield (out * math.cos(angle) - across * math.sin(angle), out * math.sin(angle) + across * math.cos(angle), z)


def lines(element_size):
    cells, rows = round(WIDTH / element_size), round(LENGTH / element_size)
    around = 4 * cells
    yield "*KEYWORD\n$ Written by make_mesh.py.\n*NODE"
    number = 0
    for row in range(rows + 1):
        for x, y, z in ring(cells, LENGTH * row / rows):
            number += 1
            yield f"{number:8d}{x:16.9g}{y:16.9g}{z:16.9g}"
    yield "*ELEMENT_SHELL"
    for row in range(rows):
        for j in range(around):
            low, high = row * around + 1, (row + 1) * around + 1
            following = (j + 1) % around
            corners = (low + j, low + following, high + following, high + j)
            yield f"{row * around + j + 1:8d}{1:8d}" + "".join(f"{node:8d}" for node in corners)
    yield "*SET_NODE_LIST_TITLE\nlowest ring\n         1"
    for first in range(1, around + 1, 8):
        yield "".join(f"{node:10d}" for node in range(first, min(first + 8, around + 1)))
    yield "*END"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--element-size", type=float, default=5.0, help="[mm], a divisor of 40 and 150 (default 5)")
    print("\n".join(lines(parser.parse_args().element_size)))


if __name__ == "__main__":
    main()
