#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes square_tube.k: a whole square tube of steel that a mass drives onto a rigid wall, folding onto itself.

60 x 60 x 1.5 mm, 240 mm long, 120 kg at 10 mm/ms. Units: mm, kg, ms (force kN, stress GPa, energy J).

    ./make_square_tube.py > square_tube.k                       2 304 shells of 5 mm
    ./make_square_tube.py --element-size 2.5 --formulation 16 > finer.k
"""

import argparse
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from cards import id_cards, mass_cards, node_cards, shell_cards  # noqa: E402

LENGTH = 240.0
WIDTH = 60.0
THICKNESS = 1.5
MASS = 120.0
VELOCITY = 10.0
END_TIME = 20.0
TRIGGER_DEPTH = 0.3  # faces in and out by turns: the symmetric folding mode of a square tube
TRIGGER_LENGTH = 44.0  # one fold, 2 H = 1.97 (b^2 t)^(1/3), W. Wierzbicki & W. Abramowicz, J. Appl. Mech. 50 (1983)

# Mild steel: effective plastic strain, yield stress [GPa].
HARDENING = [(0.0, 0.260), (0.02, 0.300), (0.05, 0.340), (0.10, 0.380), (0.20, 0.425), (0.40, 0.470)]


def face_push(z, across):
    """Outward push of a face at height z, `across` from its middle [mm]."""
    if z >= TRIGGER_LENGTH:
        return 0.0
    return TRIGGER_DEPTH * math.sin(math.pi * z / TRIGGER_LENGTH) ** 2 * math.cos(math.pi * across / WIDTH)


def ring(cells, z):
    """Points of one ring: face by face, each from one corner to before the next."""
    half = WIDTH / 2
    points = []
    for face in range(4):
        sign = 1 if face % 2 == 0 else -1
        for j in range(cells):
            across = -half + WIDTH * j / cells
            out = half + (sign * face_push(z, across) if j > 0 else 0.0)
            angle = face * math.pi / 2
            x = out * math.cos(angle) - across * math.sin(angle)
            y = out * math.sin(angle) + across * math.cos(angle)
            points.append((x, y, z))
    return points


def mesh(element_size):
    cells = round(WIDTH / element_size)
    rows = round(LENGTH / element_size)
    around = 4 * cells
    nodes = [point for row in range(rows + 1) for point in ring(cells, LENGTH * row / rows)]
    shells = []
    for row in range(rows):
        for j in range(around):
            following = (j + 1) % around
            lower, upper = row * around, (row + 1) * around
            shells.append((lower + j + 1, lower + following + 1, upper + following + 1, upper + j + 1))
    top = range(rows * around + 1, (rows + 1) * around + 1)
    return nodes, shells, top


def deck(options):
    nodes, shells, top = mesh(options.element_size)
    yield f"""*KEYWORD
$ Written by make_square_tube.py. Units: mm, kg, ms.
*TITLE
Square tube, 60 x 60 x 1.5 mm, driven onto a rigid wall by {MASS:g} kg at {VELOCITY:g} m/s
*CONTROL_TERMINATION
{END_TIME:10g}
*CONTROL_TIMESTEP
       0.0       0.9
*CONTROL_ENERGY
         2         2         2
*CONTROL_HOURGLASS
         4      0.03
*CONTROL_SHELL
      20.0         0        -1         0
*DATABASE_GLSTAT
      0.02
*DATABASE_RWFORC
      0.02
*DATABASE_BINARY_D3PLOT
       0.4
*PART
tube
         1         1         1
*SECTION_SHELL
$    secid    elform      shrf       nip
         1{options.formulation:10d}  0.833333{options.points:10d}
{THICKNESS:10g}
*MAT_PIECEWISE_LINEAR_PLASTICITY
$      mid        ro         e        pr      sigy      etan      fail
         1   7.83E-6     207.0       0.3
$        c         p      lcss
       0.0       0.0         1
       0.0
       0.0
*DEFINE_CURVE
         1"""
    for strain, stress in HARDENING:
        yield f"{strain:20g}{stress:20g}"
    yield f"""*CONTACT_AUTOMATIC_SINGLE_SURFACE
         0         0         0         0
$       fs        fd        dc        vc       vdc
      0.15      0.15       0.0       0.0      20.0
         0
*RIGIDWALL_PLANAR_ID
         1
         0
       0.0       0.0       0.0       0.0       0.0       1.0       0.3
*INITIAL_VELOCITY
         0
       0.0       0.0{-VELOCITY:10g}
*SET_NODE_LIST_TITLE
top: held across the tube and against turning, carries the mass
         1"""
    yield from id_cards(top)
    yield """*BOUNDARY_SPC_SET
$     nsid       cid      dofx      dofy      dofz     dofrx     dofry     dofrz
         1         0         1         1         0         1         1         1
*ELEMENT_MASS"""
    yield from mass_cards([(node, MASS / len(top)) for node in top])
    yield "*NODE"
    yield from node_cards(nodes)
    yield "*ELEMENT_SHELL"
    yield from shell_cards([(1, *shell) for shell in shells])
    yield "*END"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--element-size", type=float, default=5.0, help="[mm], a divisor of 60 (default 5)")
    parser.add_argument("--formulation", type=int, default=2, help="ELFORM (default 2, Belytschko-Tsay)")
    parser.add_argument("--points", type=int, default=3, help="through the thickness (default 3)")
    for line in deck(parser.parse_args()):
        print(line)


if __name__ == "__main__":
    main()
