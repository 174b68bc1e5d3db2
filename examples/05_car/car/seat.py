# SPDX-License-Identifier: BSD-3-Clause
"""A front seat: frame of pan and back on two rails, cushions of foam. Its origin is its middle plane at the road below
the bumper, as the car's; it is put to its side by a transformation."""

from . import dimensions as d
from .mesh import Mesh, blend, divide
from .parts import Parts

OFFSET_Y = 355.0
HALF = 235.0
RAIL_BASE = d.FLOOR + 3 + 52 + 4
PAN = RAIL_BASE + 36 + 4
PROFILE = [(1690.0, PAN), (2140.0, PAN), (2175.0, PAN + 30), (2335.0, 900.0)]  # x, z of pan and back


def build(size):
    mesh, parts = Mesh(), Parts()
    frame = parts.sheet("seat frame", "high strength", 1.4)
    rail = parts.sheet("seat rails", "high strength", 2.0)
    foam = parts.solid("seat foam", "seat foam")
    mesh.joined = {foam: frame}
    length = 1.25 * size.cabin
    ys = divide((-HALF, -180, 180, HALF), length)
    xs = divide([p[0] for p in PROFILE[:2]], length)
    mesh.surface(frame, lambda x, y: (x, y, PAN), xs, ys)
    heights = divide((0.0, 1.0), length / 620)

    def back(t, y):
        x, z = blend(PROFILE[2], PROFILE[3], t)
        return (x, y, z)

    mesh.surface(frame, back, heights, ys)
    mesh.surface(frame, lambda t, y: (blend(PROFILE[1], PROFILE[2], t)[0], y, blend(PROFILE[1], PROFILE[2], t)[1]),
                 (0.0, 1.0), ys)
    layers = divide((0.0, 100.0), 0.8 * length)
    mesh.block(foam, lambda x, y, w: (x, y, PAN + w), [x for x in xs if x < 2080], ys, layers)
    upper = [t for t in heights if t > 0.24]
    layers = divide((-80.0, 0.0), 0.8 * length)
    mesh.block(foam, lambda y, t, w: (back(t, y)[0] + w, y, back(t, y)[2]), ys, upper, layers)
    for s in (1, -1):
        y = s * 180.0
        ring = [(y - 18, RAIL_BASE), (y + 18, RAIL_BASE), (y + 18, RAIL_BASE + 36), (y - 18, RAIL_BASE + 36)]
        mesh.sweep(rail, lambda x: [(x, a, b) for a, b in ring], divide((1690, d.B_PILLAR + 40), size.cabin), size.cabin,
                   closed=True)
    return mesh, parts
