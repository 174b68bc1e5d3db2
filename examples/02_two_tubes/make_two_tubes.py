#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the second example of F. Wang, J. Cheng & Z. Yao, Acta Mechanica Sinica 16(4), 2000: two tubes that collide.

Each tube is 0.46 m long, 0.20 m in diameter and 5 mm thick and flies at 35 m/s against the other; their axes are
crossed. Units: m, kg, s.

    ./make_two_tubes.py > two_tubes_coarse.k                         300 shells each
    ./make_two_tubes.py --around 38 --along 24 > two_tubes_fine.k    912 shells each
"""

import argparse
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from cards import node_cards, search_lines, shell_cards  # noqa: E402

RADIUS = 0.10
LENGTH = 0.46
THICKNESS = 0.005
VELOCITY = 35.0
END_TIME = 0.006

# The paper gives neither material constants nor arrangement: these are ours.
DENSITY = 7830.0
YOUNGS_MODULUS = 207.0e9
POISSONS_RATIO = 0.3
YIELD_STRESS = 250.0e6
TANGENT_MODULUS = 1.0e9
CONTACT_FRICTION = 0.1
HOURGLASS_COEFFICIENT = 0.03  # stiffness form
GAP = 0.001  # between the surfaces at the start
MARGIN = 0.3  # what the territory expansion c leaves beyond the thickness, over the mean edge
DOMAIN = (0.22, 0.26, 0.26)  # half of the cells' box: the tubes as they are, and room for what bulges


def tube(around, along, side):
    """Points of a tube, ring by ring. `side` -1: at negative x, axis along y; +1: at positive x, axis along z. A flat
    facet faces the other tube, so that nodes meet faces and not edges edges."""
    facet = RADIUS * math.cos(math.pi / around)
    centre = side * (facet + (THICKNESS + GAP) / 2)
    points = []
    for i in range(along + 1):
        axial = LENGTH * (i / along - 0.5)
        for j in range(around):
            angle = 2 * math.pi * (j + 0.5) / around
            x = centre - side * RADIUS * math.cos(angle)
            across = RADIUS * math.sin(angle)
            points.append((x, axial, across) if side < 0 else (x, across, axial))
    return points


def shells_of(part, around, along, first):
    """Shells (part and four nodes) of a tube whose nodes begin at `first`."""
    shells = []
    for i in range(along):
        for j in range(around):
            lower, upper = first + i * around, first + (i + 1) * around
            following = (j + 1) % around
            shells.append((part, lower + j, lower + following, upper + following, upper + j))
    return shells


def deck(options):
    around, along = options.around, options.along
    nodes = tube(around, along, -1) + tube(around, along, 1)
    half = len(nodes) // 2
    shells = shells_of(1, around, along, 1) + shells_of(2, around, along, half + 1)
    # Middle of each tube's length: where the tubes meet, and opposite of it.
    near = around * (along // 2) + 1
    far = near + around // 2
    watched = (near, far, half + near, half + far)
    edges = (2 * RADIUS * math.sin(math.pi / around), LENGTH / along)
    edge = sum(edges) / 2
    contact_thickness = min(THICKNESS, 0.4 * min(edges))  # as the contact takes it
    yield """*KEYWORD
$ Written by make_two_tubes.py. Units: m, kg, s.
*TITLE
Two tubes (Wang, Cheng & Yao 2000, example 2)"""
    yield from search_lines([-half for half in DOMAIN], DOMAIN, edge, contact_thickness + MARGIN * edge)
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
*DATABASE_NODOUT
   2.0E-05
*DATABASE_HISTORY_NODE
""" + "".join(f"{node:10d}" for node in watched) + f"""
*DATABASE_BINARY_D3PLOT
   1.0E-04
*PART
tube along y, flies towards +x
$      pid     secid       mid
         1         1         1
*PART
tube along z, flies towards -x
         2         1         1
*SECTION_SHELL
$    secid    elform      shrf       nip
         1{options.formulation:10d}  0.833333{options.points:10d}
{THICKNESS:10g}{THICKNESS:10g}{THICKNESS:10g}{THICKNESS:10g}
*MAT_PLASTIC_KINEMATIC
$      mid        ro         e        pr      sigy      etan      beta
         1{DENSITY:10g}{YOUNGS_MODULUS:10.4g}{POISSONS_RATIO:10g}{YIELD_STRESS:10.4g}{TANGENT_MODULUS:10.4g}       1.0
         0         0         0
*CONTACT_AUTOMATIC_SINGLE_SURFACE
$     ssid      msid     sstyp     mstyp
         0         0         0         0
$       fs        fd        dc        vc       vdc
{CONTACT_FRICTION:10g}{CONTACT_FRICTION:10g}       0.0       0.0      20.0
         0
*INITIAL_VELOCITY_GENERATION
$       id      styp     omega        vx        vy        vz
         1         2       0.0{VELOCITY:10g}       0.0       0.0

         2         2       0.0{-VELOCITY:10g}       0.0       0.0

*NODE"""
    yield from node_cards(nodes)
    yield "*ELEMENT_SHELL"
    yield from shell_cards(shells)
    yield "*END"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--around", type=int, default=20, help="shells round a tube (default 20)")
    parser.add_argument("--along", type=int, default=15, help="shells along a tube (default 15)")
    parser.add_argument("--formulation", type=int, default=2, help="ELFORM (default 2, Belytschko-Tsay)")
    parser.add_argument("--points", type=int, default=5, help="integration points through the thickness (default 5)")
    for line in deck(parser.parse_args()):
        print(line)


if __name__ == "__main__":
    main()
