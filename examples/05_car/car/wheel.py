# SPDX-License-Identifier: BSD-3-Clause
"""A wheel about the origin, its axis y, its outer side towards +y: rim and disc (rigid), tyre with the air in it."""

import math

from . import dimensions as d
from .mesh import Mesh, unit_divisions_of
from .parts import Parts
from .suspension import HUB, HUB_WIDTH

PRESSURE = 2.2e-4  # above the ambient one [GPa]
HALF = d.TYRE_WIDTH / 2
SECTION = [(d.RIM_RADIUS, -70), (225, -88), (258, -HALF), (288, -82), (d.TYRE_RADIUS, -58), (d.TYRE_RADIUS, 0),
           (d.TYRE_RADIUS, 58), (288, 82), (258, HALF), (225, 88), (d.RIM_RADIUS, 70)]


def turned(radius, y, angle):
    return (radius * math.cos(angle), y, radius * math.sin(angle))


def build(size):
    """Mesh, parts and hub nodes of a wheel."""
    mesh, parts = Mesh(), Parts()
    tyre = parts.sheet("tyre", "tyre", 8.0)
    rim = parts.sheet("rim", "rim", 6.0)
    disc = parts.sheet("wheel disc", "rim", 6.0)
    mesh.joined = {rim: tyre, disc: tyre}
    length = 1.3 * size.cabin
    count = max(20, 4 * round(2 * math.pi * d.TYRE_RADIUS / length / 4))
    angles = [2 * math.pi * i / count for i in range(count)] + [0.0]
    rows = []
    for a, b in zip(SECTION, SECTION[1:]):
        parts_of_leg = max(1, round(math.dist(a, b) / length))
        rows += [tuple(p + (q - p) * k / parts_of_leg for p, q in zip(a, b)) for k in range(parts_of_leg)]
    rows.append(SECTION[-1])
    mesh.surface(tyre, lambda angle, row: turned(*row, angle), angles, rows[::-1])  # normals outwards
    barrel = unit_divisions_of(-70, 70, length)
    mesh.surface(rim, lambda angle, y: turned(d.RIM_RADIUS, y, angle), angles, barrel)
    edge = min(barrel, key=lambda y: abs(y - 40))
    radii = unit_divisions_of(50, d.RIM_RADIUS, 1.3 * length)
    mesh.surface(disc, lambda angle, r: turned(r, edge, angle), angles, radii)
    hubs = [(HUB + k, (0.0, -HUB_WIDTH * k, 0.0)) for k in range(2)]
    return mesh, parts, hubs
