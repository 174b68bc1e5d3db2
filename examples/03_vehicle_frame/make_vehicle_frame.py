#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes vehicle_frame.k: the third example of F. Wang, J. Cheng & Z. Yao, Acta Mechanica Sinica 16(4), 2000, a vehicle
frame that runs onto a rigid wall at 48 km/h with 550 kg on its second cross member.

The paper's mesh is not published. This one is a ladder frame: two rails of box section that rise over the axles, five
cross members. The wall is at x = 0, x points to the rear, z up. Units: m, kg, s.

    ./make_vehicle_frame.py > vehicle_frame.k
    ./make_vehicle_frame.py --rows 10 > finer.k
"""

import argparse
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from cards import mass_cards, node_cards, search_lines, shell_cards  # noqa: E402

VELOCITY = 48.0 / 3.6
PAYLOAD = 550.0  # on the second cross member
END_TIME = 0.0188

# All that follows is ours.
LENGTH = 4.0
HEIGHT = 0.12  # of the rails
WIDTH = 0.07  # of the rails
INNER = 0.40  # from the middle to the rails' inner webs
HORN = 0.45  # the rails in front of this are thin, and meant to fold
# Height of the rails' axis (x, z): level between two equal heights, a cosine between two others.
AXIS = [(0.0, 0.0), (HORN, 0.0), (0.75, 0.06), (1.0, 0.06), (1.3, -0.06), (2.5, -0.06), (2.8, 0.10), (3.3, 0.10),
        (3.6, 0.02), (LENGTH, 0.02)]
# Shells along the rails: (up to x, length of a shell with five rows over the height).
ZONES = [(HORN, 0.010), (1.2, 0.025), (LENGTH, 0.060)]
# Cross members: (from x, to x).
MEMBERS = [(0.33, 0.41), (0.84, 0.94), (1.68, 1.78), (2.85, 2.95), (3.86, 3.96)]
LOADED = 1  # the second
MEMBER_PART = 0.6  # of the rails' height
# Parts: title and thickness.
PARTS = {1: ("horns of the rails", 0.0020), 2: ("rails", 0.0032), 3: ("cross members", 0.0025),
         4: ("second cross member, carries the load", 0.0040)}
DENSITY = 7830.0
YOUNGS_MODULUS = 207.0e9
POISSONS_RATIO = 0.3
YIELD_STRESS = 350.0e6
TANGENT_MODULUS = 1.0e9
WALL_FRICTION = 0.3
CONTACT_FRICTION = 0.1
HOURGLASS_COEFFICIENT = 0.01  # stiffness form; more puts a tenth of the work into the corners of the folds
TRIGGER_DEPTH = 0.001  # two faces in, two out: the folding mode of a box
TRIGGER_CENTRE = 0.04
TRIGGER_LENGTH = 0.06  # one fold, 2 H, of Wierzbicki & Abramowicz, J. Appl. Mech. 50 (1983)
DOMAIN = (-0.02, -0.52, -0.20), (1.2, 0.52, 0.25)  # the cells cover the front only
MARGIN = 0.3  # what the territory expansion c leaves beyond the largest thickness, over CELL
CELL = 0.020  # with five rows: the mean edge in the front


def axis_height(x):
    for (x0, z0), (x1, z1) in zip(AXIS, AXIS[1:]):
        if x <= x1:
            return z0 + (z1 - z0) * (1 - math.cos(math.pi * (x - x0) / (x1 - x0))) / 2
    return AXIS[-1][1]


def trigger(x, across):
    """Push of a face at x, `across` from its middle as a part of its half width [m]."""
    along = (x - TRIGGER_CENTRE) / TRIGGER_LENGTH
    if abs(along) >= 0.5:
        return 0.0
    return TRIGGER_DEPTH * math.cos(math.pi * along) ** 2 * math.cos(0.5 * math.pi * across)


class Frame:
    """Nodes and shells, numbered from 1."""

    def __init__(self, rows):
        self.rows = rows
        self.columns = max(2, round(rows * WIDTH / HEIGHT))
        self.around = 2 * (rows + self.columns)
        self.stations = self.make_stations()
        self.nodes = []
        self.shells = []  # (part, node, node, node, node)
        self.rails = {side: self.add_rail(side) for side in (1, -1)}
        self.payload_nodes = []
        for number, (front, rear) in enumerate(MEMBERS):
            self.add_member(number, front, rear)

    def make_stations(self):
        """Places along the rails where shells meet."""
        stations = [0.0]
        for end, length in ZONES:
            begin = stations[-1]
            count = round((end - begin) / (length * 5 / self.rows))
            stations += [begin + (end - begin) * (i + 1) / count for i in range(count)]
        return stations

    def add_node(self, x, y, z):
        self.nodes.append((x, y, z))
        return len(self.nodes)

    def section(self, x):
        """Points (distance from the middle of the frame, z) round a rail: inner web upwards, top outwards, outer web
        down, bottom inwards."""
        rows, columns = self.rows, self.columns
        points = []
        for j in range(rows):
            across = 2 * j / rows - 1
            points.append((INNER - trigger(x, across), HEIGHT / 2 * across))
        for j in range(columns):
            across = 2 * j / columns - 1
            points.append((INNER + WIDTH * j / columns, HEIGHT / 2 - (trigger(x, across) if j > 0 else 0.0)))
        for j in range(rows):
            across = 1 - 2 * j / rows
            points.append((INNER + WIDTH + (trigger(x, across) if j > 0 else 0.0), HEIGHT / 2 * across))
        for j in range(columns):
            across = 1 - 2 * j / columns
            points.append((INNER + WIDTH * (1 - j / columns), -HEIGHT / 2 + (trigger(x, across) if j > 0 else 0.0)))
        return points

    def add_rail(self, side):
        rings = []
        for x in self.stations:
            base = axis_height(x)
            rings.append([self.add_node(x, side * y, base + z) for y, z in self.section(x)])
        for front, rear, x in zip(rings, rings[1:], self.stations):
            part = 1 if x < HORN - 1e-9 else 2
            for j in range(self.around):
                following = (j + 1) % self.around
                self.shells.append((part, front[j], rear[j], rear[following], front[following]))
        return rings

    def nearest_station(self, x):
        return min(range(len(self.stations)), key=lambda i: abs(self.stations[i] - x))

    def member_ring(self, front, rear):
        """(station, row) round the place of a cross member on the inner web."""
        first, last = self.nearest_station(front), self.nearest_station(rear)
        low = round(self.rows * (1 - MEMBER_PART) / 2)
        high = self.rows - low
        return ([(first, row) for row in range(low, high)] + [(i, high) for i in range(first, last)]
                + [(last, row) for row in range(high, low, -1)] + [(i, low) for i in range(last, first, -1)])

    def add_member(self, number, front, rear):
        ring = self.member_ring(front, rear)
        spans = max(2, round(14 * self.rows / 5))
        left, right = ([self.rails[side][i][row] for i, row in ring] for side in (1, -1))
        rings = [left]
        for k in range(1, spans):
            y = INNER * (1 - 2 * k / spans)
            rings.append([self.add_node(self.nodes[node - 1][0], y, self.nodes[node - 1][2]) for node in left])
        rings.append(right)
        part = 4 if number == LOADED else 3
        for one, other in zip(rings, rings[1:]):
            for j in range(len(ring)):
                following = (j + 1) % len(ring)
                self.shells.append((part, one[j], other[j], other[following], one[following]))
        if number == LOADED:
            self.payload_nodes = [node for between in rings[1:-1] for node in between]

    def end_nodes(self):
        """Lower outer corners of both rails' rear ends, and of their front ends."""
        corner = 2 * self.rows + self.columns
        return [self.rails[side][end][corner] for end in (-1, 0) for side in (1, -1)]


def part_cards(options):
    for part, (title, thickness) in PARTS.items():
        yield "*PART"
        yield title
        yield f"{part:10d}{part:10d}{1:10d}"
        yield "*SECTION_SHELL"
        yield f"{part:10d}{options.formulation:10d}  0.833333{options.points:10d}"
        yield f"{thickness:10g}" * 4


def deck(options):
    frame = Frame(options.rows)
    cell = CELL * 5 / options.rows
    yield """*KEYWORD
$ Written by make_vehicle_frame.py. Units: m, kg, s.
*TITLE
Vehicle frame onto a rigid wall (Wang, Cheng & Yao 2000, example 3)
$ The cells cover the front of the frame only."""
    yield from search_lines(*DOMAIN, cell, max(thickness for _, thickness in PARTS.values()) + MARGIN * cell)
    yield f"""*CONTROL_TERMINATION
$   endtim
{END_TIME:10g}
*CONTROL_TIMESTEP
$   dtinit    tssfac
       0.0       0.9
*CONTROL_ENERGY
$     hgen      rwen    slnten
         2         2         2
*CONTROL_HOURGLASS
$      ihq        qh
         4{HOURGLASS_COEFFICIENT:10g}
*CONTROL_SHELL
$   wrpang     esort     irnxx    istupd
      20.0         0        -1         0
*DATABASE_GLSTAT
   2.0E-05
*DATABASE_MATSUM
   2.0E-05
*DATABASE_RWFORC
   2.0E-05
*DATABASE_NODOUT
   2.0E-05
*DATABASE_HISTORY_NODE
""" + "".join(f"{node:10d}" for node in frame.end_nodes()) + """
*DATABASE_BINARY_D3PLOT
   4.7E-04"""
    yield from part_cards(options)
    yield f"""*MAT_PLASTIC_KINEMATIC
$      mid        ro         e        pr      sigy      etan      beta
         1{DENSITY:10g}{YOUNGS_MODULUS:10.4g}{POISSONS_RATIO:10g}{YIELD_STRESS:10.4g}{TANGENT_MODULUS:10.4g}       1.0
         0         0         0
*CONTACT_AUTOMATIC_SINGLE_SURFACE
$     ssid      msid     sstyp     mstyp
         0         0         0         0
$       fs        fd        dc        vc       vdc
{CONTACT_FRICTION:10g}{CONTACT_FRICTION:10g}       0.0       0.0      20.0
         0
*RIGIDWALL_PLANAR_ID
         1
$     nsid    nsidex     boxid
         0         0         0
$       xt        yt        zt        xh        yh        zh      fric
       0.0       0.0       0.0       0.1       0.0       0.0{WALL_FRICTION:10g}
*INITIAL_VELOCITY
$     nsid
         0
$       vx        vy        vz
{-VELOCITY:10.6g}       0.0       0.0
*ELEMENT_MASS"""
    share = PAYLOAD / len(frame.payload_nodes)
    yield from mass_cards([(node, share) for node in frame.payload_nodes])
    yield "*NODE"
    yield from node_cards(frame.nodes)
    yield "*ELEMENT_SHELL"
    yield from shell_cards(frame.shells)
    yield "*END"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", type=int, default=5, help="shells over the height of a rail (default 5)")
    parser.add_argument("--formulation", type=int, default=2, help="ELFORM (default 2, Belytschko-Tsay)")
    parser.add_argument("--points", type=int, default=5, help="integration points through the thickness (default 5)")
    for line in deck(parser.parse_args()):
        print(line)


if __name__ == "__main__":
    main()
