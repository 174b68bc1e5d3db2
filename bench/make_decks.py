#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the large decks of whole_runs.py. Units: kg, mm, ms.

    ./make_decks.py tubes > tubes.k      25 square tubes of 4000 shells run onto a wall and fold, self-contact
    ./make_decks.py tubes --rows 16      256 of them, a million shells
    ./make_decks.py sheet > sheet.k      1000 x 1000 shells, clamped along one edge, set swinging
    ./make_decks.py block > block.k      8000 hexahedra that strike a wall at 100 m/s
"""

import argparse
import math

HEAD = """*KEYWORD
*TITLE
{title}
*CONTROL_TERMINATION
{end_time:10g}{cycles:10d}
*CONTROL_TIMESTEP
       0.0       0.9
*CONTROL_ENERGY
         2         2         2
*CONTROL_HOURGLASS
         4      0.03
*PART
{part}
         1         1         1
{section}
*MAT_PLASTIC_KINEMATIC
         1   7.85e-6       210       0.3      0.25       1.0       1.0
         0         0         0"""


def head(title, end_time, cycles, thickness=None):
    """The cards before the mesh; those of a shell where there is a thickness, else of a solid."""
    if thickness is None:
        return HEAD.format(title=title, end_time=end_time, cycles=cycles, part="solids",
                           section="*SECTION_SOLID\n         1         1")
    section = "*SECTION_SHELL\n         1         2  0.833333         3\n" + 4 * f"{thickness:10g}"
    return HEAD.format(title=title, end_time=end_time, cycles=cycles, part="shells", section=section)


def node_card(number, x, y, z):
    return f"{number:8d}{x:16.9g}{y:16.9g}{z:16.9g}"


def element_card(number, nodes):
    return f"{number:8d}{1:8d}" + "".join(f"{node:8d}" for node in nodes)


def node_list(nodes):
    for at in range(0, len(nodes), 8):
        yield "".join(f"{node:10d}" for node in nodes[at:at + 8])


def tubes(cycles, rows=5, width=60.0, around=100, high=40):
    """rows x rows square tubes beside each other, nodes shared round each corner, each with 5 kg on its upper rim, which
    fold it until they are almost at rest."""
    yield head(title=f"{rows * rows} square tubes onto a rigid wall", end_time=8.0, cycles=cycles, thickness=1.0)
    edge = 4 * width / around
    per_tube = around * (high + 1)
    rim = [tube * per_tube + high * around + i + 1 for tube in range(rows * rows) for i in range(around)]
    yield "*SET_NODE_LIST\n         1"
    yield from node_list(rim)
    yield "*BOUNDARY_SPC_SET\n         1         0         1         1         0         1         1         1"
    yield "*ELEMENT_MASS"
    for number, node in enumerate(rim):
        yield f"{number + 1:8d}{node:8d}{5.0 / around:16g}"
    yield f"""*CONTACT_AUTOMATIC_SINGLE_SURFACE
         0         0         0         0
       0.1       0.1       0.0       0.0      20.0
         0
*RIGIDWALL_PLANAR_ID
         1
         0         0         0
       0.0       0.0       0.0       0.0       0.0     100.0       0.3
*INITIAL_VELOCITY
         0
       0.0       0.0     -20.0
*NODE"""
    side = around // 4
    for tube in range(rows * rows):
        x0, y0 = (tube % rows) * 1.2 * width, (tube // rows) * 1.2 * width
        for j in range(high + 1):
            for i in range(around):
                face, along = divmod(i, side)
                bow = 0.3 * math.sin(2 * math.pi * j * edge / width) * math.sin(math.pi * along / side) * (-1) ** face
                across, out = along * edge - width / 2, width / 2 + bow
                x, y = [(across, -out), (out, across), (-across, out), (-out, -across)][face]
                yield node_card(tube * per_tube + j * around + i + 1, x0 + x, y0 + y, 0.1 + j * edge)
    yield "*ELEMENT_SHELL"
    number = 0
    for tube in range(rows * rows):
        for j in range(high):
            for i in range(around):
                number += 1
                first = tube * per_tube + j * around + 1
                corners = (first + i, first + (i + 1) % around)
                yield element_card(number, (*corners, corners[1] + around, corners[0] + around))
    yield "*END"


def sheet(cycles, cells=1000, edge=5.0):
    yield head(title=f"sheet of {cells * cells} shells", end_time=100.0, cycles=cycles, thickness=1.5)
    line = cells + 1
    yield "*SET_NODE_LIST\n         1"
    yield from node_list(list(range(1, line + 1)))
    yield """*BOUNDARY_SPC_SET
         1         0         1         1         1         1         1         1
*INITIAL_VELOCITY
         0
       0.0       0.0      10.0
*NODE"""
    for j in range(line):
        for i in range(line):
            z = 2 * math.sin(0.25 * i) + math.cos(0.2 * j)
            yield node_card(j * line + i + 1, i * edge, j * edge, z)
    yield "*ELEMENT_SHELL"
    for j in range(cells):
        for i in range(cells):
            corner = j * line + i + 1
            yield element_card(j * cells + i + 1, (corner, corner + 1, corner + line + 1, corner + line))
    yield "*END"


def block(cycles, cells=20, edge=5.0):
    """cells x cells x cells hexahedra, yielding from the wall upwards."""
    yield head(title=f"block of {cells ** 3} hexahedra onto a rigid wall", end_time=10.0, cycles=cycles)
    yield """*RIGIDWALL_PLANAR
         0         0         0
       0.0       0.0       0.0       0.0       0.0     100.0       0.3
*INITIAL_VELOCITY
         0
       0.0       0.0    -100.0
*NODE"""
    line = cells + 1
    for k in range(line):
        for j in range(line):
            for i in range(line):
                yield node_card((k * line + j) * line + i + 1, i * edge, j * edge, k * edge)
    yield "*ELEMENT_SOLID"
    for k in range(cells):
        for j in range(cells):
            for i in range(cells):
                corner = (k * line + j) * line + i + 1
                face = (corner, corner + 1, corner + line + 1, corner + line)
                yield element_card((k * cells + j) * cells + i + 1, (*face, *(node + line * line for node in face)))
    yield "*END"


DECKS = {"tubes": tubes, "sheet": sheet, "block": block}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("deck", choices=tuple(DECKS))
    parser.add_argument("--cycles", type=int, default=0, help="stop after so many (default: run to the end time)")
    parser.add_argument("--rows", type=int, help="of tubes, with as many in each (default 5)")
    arguments = parser.parse_args()
    if arguments.rows is not None and arguments.deck != "tubes":
        parser.error("only tubes stand in rows")
    rows = {} if arguments.rows is None else {"rows": arguments.rows}
    for line in DECKS[arguments.deck](arguments.cycles, **rows):
        print(line)


if __name__ == "__main__":
    main()
