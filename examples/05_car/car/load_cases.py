# SPDX-License-Identifier: BSD-3-Clause
"""What the car runs against: a rigid wall, an offset deformable barrier of foam blocks (96/79/EC, without honeycomb's
cladding), a pole."""

from . import materials
from .deck import element_cards, id_list, node_cards, part_cards, row
from .mesh import Mesh, divide
from .parts import Parts

SPEEDS = {"wall": 56.0, "offset": 64.0, "pole": 48.0}  # [km/h]
GAP = 3.0  # before the bumper
POLE_RADIUS = 127.0
OVERLAP = 0.4
WIDTH = 1690.0
BARRIER_OFFSET = 7000000
BARRIER_PARTS = 7000


def wall(_):
    return ["*RIGIDWALL_PLANAR_ID", row(1) + " wall", row(0, 0, 0), row(-GAP, 0.0, 0.0, 100.0, 0.0, 0.0, 0.2)]


def pole(_):
    return ["*RIGIDWALL_GEOMETRIC_CYLINDER_ID", row(1) + " pole", row(0, 0, 0),
            row(-GAP - POLE_RADIUS, 0.0, -200.0, -GAP - POLE_RADIUS, 0.0, 1800.0, 0.2), row(POLE_RADIUS, 2000.0)]


def offset(size):
    """Blocks on the left (the driver's side): core 1000 x 650 x 450, bumper 1000 x 330 x 90 mm, 200 mm above the road. The
    nodes at the back are held."""
    mesh, parts = Mesh(), Parts()
    core, bumper = parts.solid("barrier core", "barrier core"), parts.solid("barrier bumper", "barrier bumper")
    mesh.joined = {bumper: core}
    inner = -WIDTH / 2 + OVERLAP * WIDTH
    length = 1.1 * size.cabin
    front = -GAP - 90.0
    zs = divide((200.0, 325.0, 655.0, 850.0), length)
    ys = divide((inner - 1000.0, inner), length)
    nodes = mesh.block(core, lambda x, y, z: (x, y, z), divide((front - 450.0, front), length), ys, zs)
    mesh.block(bumper, lambda x, y, z: (x, y, z), divide((front, -GAP), length), ys, [z for z in zs if 324 < z < 656])
    held = sorted({node for row_ in nodes[0] for node in row_})
    lines = ["*KEYWORD", *part_cards(parts), *node_cards(mesh), *element_cards(mesh), "*SET_NODE_LIST", row(1), *id_list(held),
             "*BOUNDARY_SPC_SET", row(1, 0, 1, 1, 1, 0, 0, 0), "*SET_NODE_LIST", row(2),
             *id_list(list(range(1, len(mesh.points) + 1))), "*SET_PART_LIST", row(1), row(core, bumper), "*END"]
    return lines


def barrier_cards():
    """Materials of the offset barrier, its contact with the car, and the wall behind it."""
    k = BARRIER_PARTS
    return [*materials.barrier_cards(), "*INCLUDE_TRANSFORM", "barrier.k",
            row(BARRIER_OFFSET, BARRIER_OFFSET, k, 0, k, 0, 0), row(k), row(0.0), row(0),
            "*CONTACT_INTERIOR", row(k + 1)]
