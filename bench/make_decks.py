#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the large decks of whole_runs.py. Units: kg, mm, ms.

    ./make_decks.py tubes > tubes.k      25 square tubes of 4000 shells run onto a wall and fold, self-contact
    ./make_decks.py tubes --rows 16      256 of them, a million shells
    ./make_decks.py sheet > sheet.k      1000 x 1000 shells, clamped along one edge, set swinging
    ./make_decks.py block > block.k      8000 hexahedra that strike a wall at 100 m/s
    ./make_decks.py filled > filled.k    16 such tubes, each filled with 4508 hexahedra of foam, under a rigid press
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
*CONTROL_SHELL
      20.0         0        -1         0
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


def element_card(number, nodes, part=1):
    return f"{number:8d}{part:8d}" + "".join(f"{node:8d}" for node in nodes)


def node_list(nodes):
    for at in range(0, len(nodes), 8):
        yield "".join(f"{node:10d}" for node in nodes[at:at + 8])


SELF_CONTACT = """*CONTACT_AUTOMATIC_SINGLE_SURFACE
         0         0         0         0
       0.1       0.1       0.0       0.0      20.0
         0"""
WALL = """*RIGIDWALL_PLANAR_ID
         1
         0         0         0
       0.0       0.0       0.0       0.0       0.0     100.0       0.3"""
FALLING = "*INITIAL_VELOCITY\n         0\n       0.0       0.0     -20.0"


def tube_places(rows, width):
    """Axes of rows x rows tubes beside each other."""
    return [((tube % rows) * 1.2 * width, (tube // rows) * 1.2 * width) for tube in range(rows * rows)]


def tube_nodes(tube, place, width, around, high):
    """Node cards of one tube whose walls bow a little, inwards and outwards in turn."""
    side, edge = around // 4, 4 * width / around
    for j in range(high + 1):
        for i in range(around):
            face, along = divmod(i, side)
            bow = 0.3 * math.sin(2 * math.pi * j * edge / width) * math.sin(math.pi * along / side) * (-1) ** face
            across, out = along * edge - width / 2, width / 2 + bow
            x, y = [(across, -out), (out, across), (-across, out), (-out, -across)][face]
            yield node_card((tube * (high + 1) + j) * around + i + 1, place[0] + x, place[1] + y, 0.1 + j * edge)


def tube_elements(tubes, around, high):
    number = 0
    for tube in range(tubes):
        for j in range(high):
            for i in range(around):
                number += 1
                first = (tube * (high + 1) + j) * around + 1
                corners = (first + i, first + (i + 1) % around)
                yield element_card(number, (*corners, corners[1] + around, corners[0] + around))


def tubes(cycles, rows=5, width=60.0, around=100, high=40):
    """rows x rows square tubes beside each other, nodes shared round each corner, each with 5 kg on its upper rim, which
    fold it until they are almost at rest."""
    yield head(title=f"{rows * rows} square tubes onto a rigid wall", end_time=8.0, cycles=cycles, thickness=1.0)
    per_tube = around * (high + 1)
    rim = [tube * per_tube + high * around + i + 1 for tube in range(rows * rows) for i in range(around)]
    yield "*SET_NODE_LIST\n         1"
    yield from node_list(rim)
    yield "*BOUNDARY_SPC_SET\n         1         0         1         1         0         1         1         1"
    yield "*ELEMENT_MASS"
    for number, node in enumerate(rim):
        yield f"{number + 1:8d}{node:8d}{5.0 / around:16g}"
    yield from (SELF_CONTACT, WALL, FALLING, "*NODE")
    for tube, place in enumerate(tube_places(rows, width)):
        yield from tube_nodes(tube, place, width, around, high)
    yield "*ELEMENT_SHELL"
    yield from tube_elements(rows * rows, around, high)
    yield "*END"


def box_nodes(first, corner, edges, cells):
    """Node cards of a box of cells, x fastest, z slowest, from the number `first` on."""
    for k in range(cells[2] + 1):
        for j in range(cells[1] + 1):
            for i in range(cells[0] + 1):
                yield node_card(first, *(c + e * n for c, e, n in zip(corner, edges, (i, j, k))))
                first += 1


def box_elements(number, first, cells, part=1):
    """Cards of its hexahedra from `number` on; `first` is its first node."""
    line, layer = cells[0] + 1, (cells[0] + 1) * (cells[1] + 1)
    for k in range(cells[2]):
        for j in range(cells[1]):
            for i in range(cells[0]):
                corner = first + k * layer + j * line + i
                face = (corner, corner + 1, corner + line + 1, corner + line)
                yield element_card(number, (*face, *(node + layer for node in face)), part)
                number += 1


FOAM_AND_PRESS = """*PART
foam
         2         2         2
*SECTION_SOLID
         2         1
*MAT_CRUSHABLE_FOAM
         2    2.5e-7       0.5       0.0         1     0.002       0.1
*DEFINE_CURVE
         1
                 0.0               0.004
                 0.5               0.006
                 0.7               0.015
                 0.9               0.100
*PART
press
         3         3         3
*SECTION_SHELL
         3         2
       4.0       4.0       4.0       4.0
*MAT_RIGID
         3{density:10.3e}       210       0.3
         1         4         7
         0"""


def filled(cycles, rows=4, width=60.0, around=100, high=40, fill=(14, 14, 23), edge=4.0, plate=10):
    """rows x rows square tubes, each filled with foam and driven onto a wall by a plate of 8 kg over it; all plates
    are one rigid body."""
    yield head(title=f"{rows * rows} tubes filled with foam under a rigid press", end_time=8.0, cycles=cycles,
               thickness=1.0)
    yield FOAM_AND_PRESS.format(density=8.0 / (4.0 * (1.1 * width) ** 2))
    # SOFT = 1: foam is too soft for a stiffness of its own against steel.
    yield from (SELF_CONTACT, "         1", WALL, FALLING, "*NODE")
    places = tube_places(rows, width)
    top = 0.1 + high * 4 * width / around
    foam_edges = (edge, edge, (top - 1.0) / fill[2])
    per_block, per_plate = (fill[0] + 1) * (fill[1] + 1) * (fill[2] + 1), (plate + 1) ** 2
    first_foam = len(places) * around * (high + 1) + 1
    first_plate = first_foam + len(places) * per_block
    for tube, (x, y) in enumerate(places):
        yield from tube_nodes(tube, (x, y), width, around, high)
        yield from box_nodes(first_foam + tube * per_block,
                             (x - 0.5 * fill[0] * edge, y - 0.5 * fill[1] * edge, 0.5), foam_edges, fill)
        yield from box_nodes(first_plate + tube * per_plate, (x - 0.55 * width, y - 0.55 * width, top + 3.0),
                             2 * (1.1 * width / plate,) + (0.0,), (plate, plate, 0))
    yield "*ELEMENT_SHELL"
    yield from tube_elements(len(places), around, high)
    number = len(places) * around * high
    for tube in range(len(places)):
        for cell in range(plate * plate):
            corner = first_plate + tube * per_plate + cell // plate * (plate + 1) + cell % plate
            number += 1
            yield element_card(number, (corner, corner + 1, corner + plate + 2, corner + plate + 1), 3)
    yield "*ELEMENT_SOLID"
    for tube in range(len(places)):
        yield from box_elements(number + 1 + tube * math.prod(fill), first_foam + tube * per_block, fill, 2)
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
    yield from box_nodes(1, (0, 0, 0), 3 * (edge,), 3 * (cells,))
    yield "*ELEMENT_SOLID"
    yield from box_elements(1, 1, 3 * (cells,))
    yield "*END"


DECKS = {"tubes": tubes, "sheet": sheet, "block": block, "filled": filled}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("deck", choices=tuple(DECKS))
    parser.add_argument("--cycles", type=int, default=0, help="stop after so many (default: run to the end time)")
    parser.add_argument("--rows", type=int, help="of tubes, with as many in each (default 5; filled 4)")
    arguments = parser.parse_args()
    if arguments.rows is not None and arguments.deck not in ("tubes", "filled"):
        parser.error("only tubes stand in rows")
    rows = {} if arguments.rows is None else {"rows": arguments.rows}
    for line in DECKS[arguments.deck](arguments.cycles, **rows):
        print(line)


if __name__ == "__main__":
    main()
