#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes box_beam.k: the first example of F. Wang, J. Cheng & Z. Yao, Acta Mechanica Sinica 16(4), 2000.

A square box beam, 0.30 m long, 0.06 m wide, 1.5 mm thick, runs at 15.6 m/s onto a rigid wall with 1440 kg at
its rear end. Two symmetry planes leave a quarter: 829 nodes, 756 shells of 5 mm, 360 kg. Units: m, kg, s.

    ./make_box_beam.py > box_beam.k
    ./make_box_beam.py --element-size 0.0025 --formulation 1 > finer.k
"""

import argparse
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from cards import id_cards, mass_cards, node_cards, shell_cards  # noqa: E402

LENGTH = 0.30
HALF_WIDTH = 0.03
THICKNESS = 0.0015
QUARTER_MASS = 360.0
VELOCITY = 15.6
END_TIME = 0.012

# The paper gives no material constants, trigger, end plate or wall friction: these are ours.
DENSITY = 7830.0
YOUNGS_MODULUS = 207.0e9
POISSONS_RATIO = 0.3
YIELD_STRESS = 250.0e6
TANGENT_MODULUS = 1.0e9
PLATE_THICKNESS = 0.006
WALL_FRICTION = 0.3
CONTACT_FRICTION = 0.1
HOURGLASS_COEFFICIENT = 0.03  # stiffness form
EXPANSION = 0.6  # territory expansion c over the shells' edge: the fastest of the values tried
TRIGGER_DEPTH = 0.0002  # one face pushed in, its neighbour out: the folding mode of a square tube
TRIGGER_CENTRE = 0.025  # distance from the wall
TRIGGER_LENGTH = 0.035  # about one full fold, 2 H, of Wierzbicki & Abramowicz, J. Appl. Mech. 50 (1983)


def trigger(distance_to_wall, across):
    """Normal displacement of a face at `across` (0 at its middle, HALF_WIDTH at the corner) [m]."""
    along = (distance_to_wall - TRIGGER_CENTRE) / TRIGGER_LENGTH
    if abs(along) >= 0.5:
        return 0.0
    return TRIGGER_DEPTH * math.cos(math.pi * along) ** 2 * math.cos(0.5 * math.pi * across / HALF_WIDTH)


def section_points(cells):
    """The quarter section from the symmetry plane y = 0 round the corner to z = 0: (y, z)."""
    step = HALF_WIDTH / cells
    top = [(j * step, HALF_WIDTH) for j in range(cells)]
    side = [(HALF_WIDTH, HALF_WIDTH - j * step) for j in range(cells + 1)]
    return top + side


class Mesh:
    """Nodes and shells of the quarter beam, numbered from 1."""

    def __init__(self, cells):
        self.cells = cells
        self.along = round(LENGTH / HALF_WIDTH) * cells
        self.nodes = []
        self.shells = []  # (part, node, node, node, node)
        self.number_of = {}  # (i along, j, k in the plate's grid) -> node
        self.add_tube()
        self.add_plate()

    def add_node(self, x, y, z):
        self.nodes.append((x, y, z))
        return len(self.nodes)

    def add_tube(self):
        around = section_points(self.cells)
        rings = []
        for i in range(self.along + 1):
            x = LENGTH * i / self.along
            ring = []
            for j, (y, z) in enumerate(around):
                top = j <= self.cells
                dz = trigger(LENGTH - x, y) if top and j != self.cells else 0.0
                dy = -trigger(LENGTH - x, z) if not top else 0.0
                ring.append(self.add_node(x, y + dy, z + dz))
            rings.append(ring)
        for lower, upper in zip(rings, rings[1:]):
            for j in range(len(around) - 1):
                self.shells.append((1, lower[j], upper[j], upper[j + 1], lower[j + 1]))
        for j, (y, z) in enumerate(around):
            self.number_of[self.grid_place(y, z)] = rings[0][j]

    def grid_place(self, y, z):
        return round(y / HALF_WIDTH * self.cells), round(z / HALF_WIDTH * self.cells)

    def add_plate(self):
        step = HALF_WIDTH / self.cells
        for k in range(self.cells):
            for j in range(self.cells):
                self.number_of[(j, k)] = self.add_node(0.0, j * step, k * step)
        for k in range(self.cells):
            for j in range(self.cells):
                corners = [(j, k), (j, k + 1), (j + 1, k + 1), (j + 1, k)]
                self.shells.append((2, *(self.number_of[c] for c in corners)))

    def plate_masses(self):
        """The quarter mass spread over the end plate by area: (node, mass)."""
        cell = QUARTER_MASS / self.cells**2
        share = lambda place: 0.5 if place in (0, self.cells) else 1.0
        return [(node, cell * share(j) * share(k)) for (j, k), node in sorted(self.number_of.items())]


def deck(mesh, formulation, points, cells_across):
    on_y = [n for n, (x, y, z) in enumerate(mesh.nodes, 1) if abs(y) < 1e-9]
    on_z = [n for n, (x, y, z) in enumerate(mesh.nodes, 1) if abs(z) < 1e-9]
    corner = mesh.number_of[(mesh.cells, mesh.cells)]
    cells = cells_across * mesh.cells // 6
    reach = cells_across * HALF_WIDTH / 6
    yield f"""*KEYWORD
$ Written by make_box_beam.py. Units: m, kg, s.
*TITLE
Box beam onto a rigid wall (Wang, Cheng & Yao 2000, example 1)
$ Cells of the size of the shells; the paper's are 60 x 8 x 8 over [0, 0.30] x [0, 0.04]^2.
$crumple method=linked-cell
$crumple cells={mesh.along},{cells},{cells}
$crumple domain=0,0.30,0,{reach:g},0,{reach:g}
$crumple expansion={EXPANSION * HALF_WIDTH / mesh.cells:g}
*PARAMETER
I elform  {formulation:10d}
I points  {points:10d}
*CONTROL_TERMINATION
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
   1.0E-05
*DATABASE_MATSUM
   1.0E-05
*DATABASE_RWFORC
   1.0E-05
*DATABASE_NODOUT
   1.0E-05
*DATABASE_HISTORY_NODE
{corner:10d}
*DATABASE_BINARY_D3PLOT
   2.0E-04
*PART
box beam
$      pid     secid       mid
         1         1         1
*PART
end plate, stiff and elastic: it only carries the mass
         2         2         2
*SECTION_SHELL
$    secid    elform      shrf       nip
         1   &elform  0.833333   &points
{THICKNESS:10g}{THICKNESS:10g}{THICKNESS:10g}{THICKNESS:10g}
*SECTION_SHELL
         2   &elform  0.833333         2
{PLATE_THICKNESS:10g}{PLATE_THICKNESS:10g}{PLATE_THICKNESS:10g}{PLATE_THICKNESS:10g}
*MAT_PLASTIC_KINEMATIC
$      mid        ro         e        pr      sigy      etan      beta
         1{DENSITY:10g}{YOUNGS_MODULUS:10.4g}{POISSONS_RATIO:10g}{YIELD_STRESS:10.4g}{TANGENT_MODULUS:10.4g}       1.0
         0         0         0
*MAT_ELASTIC
         2{DENSITY:10g}{YOUNGS_MODULUS:10.4g}{POISSONS_RATIO:10g}
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
{LENGTH:10g}       0.0       0.0{LENGTH - 0.1:10g}       0.0       0.0{WALL_FRICTION:10g}
*INITIAL_VELOCITY
$     nsid
         0
$       vx        vy        vz
{VELOCITY:10g}       0.0       0.0
*SET_NODE_LIST_TITLE
symmetry plane y = 0
         1"""
    yield from id_cards(on_y)
    yield """*SET_NODE_LIST_TITLE
symmetry plane z = 0
         2"""
    yield from id_cards(on_z)
    yield """*BOUNDARY_SPC_SET
$     nsid       cid      dofx      dofy      dofz     dofrx     dofry     dofrz
         1         0         0         1         0         1         0         1
         2         0         0         0         1         1         1         0
*ELEMENT_MASS"""
    yield from mass_cards(mesh.plate_masses())
    yield "*NODE"
    yield from node_cards(mesh.nodes)
    yield "*ELEMENT_SHELL"
    yield from shell_cards(mesh.shells)
    yield "*END"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--element-size", type=float, default=0.005, help="edge of the shells [m] (default 0.005)")
    parser.add_argument("--formulation", type=int, default=2, choices=(1, 2),
                        help="1 Hughes-Liu, as the paper; 2 Belytschko-Tsay (default)")
    parser.add_argument("--points", type=int, default=5, help="integration points through the thickness (default 5)")
    parser.add_argument("--cells-across", type=int, default=8,
                        help="cells of 5 mm in y and z (default 8, as the paper; the folds reach the tenth)")
    options = parser.parse_args()
    cells = round(HALF_WIDTH / options.element_size)
    if cells < 1 or abs(cells * options.element_size - HALF_WIDTH) > 1e-9:
        parser.error(f"the element size must divide {HALF_WIDTH} m")
    print("\n".join(deck(Mesh(cells), options.formulation, options.points, options.cells_across)))


if __name__ == "__main__":
    main()
