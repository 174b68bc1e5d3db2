# SPDX-License-Identifier: BSD-3-Clause
"""The cabin: dash with toe board, cowl, floor with tunnel and cross members, sills, pillars, roof, instrument panel."""

import math

from . import dimensions as d
from .mesh import divide
from .profiles import hat_beam, side_name

DASH_EDGE = 686.0


def add_dash(car):
    """Dash and toe board, with an opening over the tunnel and flanges beside the hinge pillars."""
    part = car.sheet("dash", "high strength", 1.2)
    size = 0.8 * car.size.cabin
    x, floor = d.DASH, d.FLOOR
    high = [(x, d.DASH_TOP), (x, 700), (x, 432)]
    beside = high + [(1340, floor + 5), (1368, floor + 5)]
    edge = d.TUNNEL_WIDTH + 10
    for s in (1, -1):
        car.mesh.sweep(part, lambda y: [(px, s * y, pz) for px, pz in beside], divide((edge, DASH_EDGE), size), size)
        car.mesh.sweep(part, lambda px: [(px, s * DASH_EDGE, d.DASH_TOP), (px, s * DASH_EDGE, 700), (px, s * DASH_EDGE, 432)],
                       divide((x, 1305), size), size)
    above = d.TUNNEL_HEIGHT + 7

    def over(y):
        return [(px, y, pz) for px, pz in high] + [(1214, 0.94 * y, above), (1368, 0.94 * y, above)]

    car.mesh.sweep(part, over, divide((-edge, edge), size), size)
    hat_beam(car, "cowl", [(1196, y, d.DASH_TOP + 8) for y in (-688, 0, 688)], (0, 0, 1), 92, 52, "mild", 1.2,
             plate=("mild", 1.0), length=lambda _: car.size.cabin, gap=4)


def add_floor(car):
    part = car.sheet("floor", "mild", 1.0)
    z, top, edge, tunnel = d.FLOOR, d.TUNNEL_HEIGHT, d.FLOOR_EDGE, d.TUNNEL_WIDTH
    section = [(-edge, z + 26), (-edge, z), (-tunnel, z), (-tunnel + 20, top), (tunnel - 20, top), (tunnel, z), (edge, z),
               (edge, z + 26)]
    car.mesh.sweep(part, lambda x: [(x, py, pz) for py, pz in section], divide((d.FLOOR_FRONT, d.FLOOR_REAR), car.size.at),
                   car.size.cabin)
    for s in (1, -1):
        for title, x in (("front", 1720.0), ("rear", d.B_PILLAR)):
            hat_beam(car, f"seat cross member {title} {side_name(s)}", [(x, s * y, z + 3) for y in (118, 683)], (0, 0, 1),
                     96, 52, "high strength", 1.2, length=lambda _: car.size.cabin)
        for title, x in (("front", 1440.0), ("rear", 2470.0)):
            hat_beam(car, f"torque box {title} {side_name(s)}", [(x, s * y, z - 3) for y in (497, 686)], (0, 0, -1),
                     96, 62, "high strength", 1.6, length=lambda _: 0.7 * car.size.cabin)


def add_sills(car):
    for s in (1, -1):
        path = [(x, s * d.SILL_Y, d.SILL_CENTRE) for x in d.SILL_ENDS]
        hat_beam(car, f"sill {side_name(s)}", path, (0, s, 0), d.SILL_HEIGHT, d.SILL_DEPTH, "ultra high strength", 1.4,
                 plate=("high strength", 1.4))


def add_pillars(car):
    for s in (1, -1):
        name, out = side_name(s), (0, s, 0)
        hat_beam(car, f"hinge pillar {name}", [(d.HINGE_PILLAR, s * y, z) for y, z in ((698, 337), (701, 932))], out, 92, 52,
                 "high strength", 1.6, plate=("high strength", 1.4))
        hat_beam(car, f"B pillar {name}", [(x, s * y, z) for x, y, z in
                                           ((d.B_PILLAR, 699, 337), (d.B_PILLAR, 703, 900), (d.B_PILLAR + 12, 569, 1352))],
                 out, [112, 104, 84], [50, 48, 36], "ultra high strength", 1.6, plate=("high strength", 1.2))
        hat_beam(car, f"roof frame {name}", [(x, s * y, z) for x, y, z in d.ROOF_FRAME], out, 46, 38,
                 "ultra high strength", 1.4, plate=("high strength", 1.2), flange=12.0)


def roof_height(x):
    top = [(p[0], p[2] + 40.5) for p in d.ROOF_FRAME[1:6]]
    return d.between([(1880, top[0][1] + 9), *top[1:4], (3095, top[4][1] + 12)], x)


def add_roof(car):
    part = car.sheet("roof", "mild", 0.8)
    length = car.size.rear

    def point(x, y):
        crown = 34 * (1 - (y / 590) ** 2) * min(1.0, (x - 1800) / 250, (3200 - x) / 250)
        return (x, y, roof_height(x) + crown)

    car.mesh.surface(part, point, divide((1905, 3085), length), divide((-588, 588), length))
    for title, x in (("front header", 1945.0), ("middle bow", d.B_PILLAR + 12), ("rear header", 3045.0)):
        path = [(x, y, roof_height(x) - 15 + 30 * (1 - (y / 590) ** 2) * min(1.0, (x - 1800) / 250, (3200 - x) / 250))
                for y in (-545, -270, 0, 270, 545)]
        hat_beam(car, f"roof {title}", path, (0, 0, -1), 60, 22, "mild", 1.0, length=lambda _: car.size.cabin)


def add_instrument_panel(car):
    """A steel tube between the hinge pillars, and the panel of plastic around it."""
    tube = car.sheet("instrument panel beam", "high strength", 1.6)
    ring = [(1290 + 30 * math.cos(a * math.pi / 3), 800 + 30 * math.sin(a * math.pi / 3)) for a in range(6)]
    car.mesh.sweep(tube, lambda y: [(x, y, z) for x, z in ring], divide((-680, 680), car.size.cabin), 40, closed=True)
    panel = car.sheet("instrument panel", "plastic", 3.0)
    outline = [(1262, 912), (1400, 905), (1450, 860), (1452, 780), (1400, 690), (1330, 670)]
    car.mesh.sweep(panel, lambda y: [(x, y, z) for x, z in outline], divide((-670, 670), car.size.rear), car.size.rear)


def build(car):
    add_dash(car)
    add_floor(car)
    add_sills(car)
    add_pillars(car)
    add_roof(car)
    add_instrument_panel(car)
