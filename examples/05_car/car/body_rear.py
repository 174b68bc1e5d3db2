# SPDX-License-Identifier: BSD-3-Clause
"""The body behind the front seats: heel board and rear floor, rear rails, inner quarters, seat back, shelf, rear panel."""

from . import dimensions as d
from .mesh import divide
from .profiles import hat_beam, side_name


def floor_outline():
    """x and z of the floor beside the tunnel, and over it, where the heel board begins above the tunnel."""
    floor, foot = d.REAR_FLOOR, d.FLOOR + 5
    rear = [(2600, floor), (3140, floor), (3170, floor - 12), (4171, floor - 12)]
    heel = d.TUNNEL_HEIGHT + 6
    over = [(2556 + 44 * (heel - foot) / (floor - foot), heel), *rear]
    return [(2528, foot), (2556, foot), *over], over


def add_floor(car):
    size, edge = car.size.rear, d.TUNNEL_WIDTH + 12
    part = car.sheet("rear floor", "mild", 0.9)
    beside, over = floor_outline()
    car.mesh.sweep(part, lambda y: [(x, y, z) for x, z in over], divide((-edge, edge), size), size)
    for s in (1, -1):
        car.mesh.sweep(part, lambda y: [(x, s * y, z) for x, z in beside], divide((edge, d.REAR_WIDTH), size), size)
        add_rail(car, s)


def add_rail(car, s):
    """Rear rail and inner quarter of a side."""
    path = [(x, s * (d.RAIL_Y - 2), z) for x, z, _ in d.REAR_RAIL]
    hat_beam(car, f"rear rail {side_name(s)}", path, (0, -s, 0), [row[2] for row in d.REAR_RAIL], d.RAIL_DEPTH,
             "high strength", 1.8, plate=("high strength", 1.6), length=lambda x: 0.8 * car.size.at(x), gap=2.2)
    part = car.sheet(f"inner quarter {side_name(s)}", "mild", 0.8)
    car.mesh.surface(part, lambda x, z: (x, s * (d.REAR_WIDTH + 7), z), divide((2625, 4168), car.size.rear),
                     divide((396, 892), car.size.rear))


def add_cross_members(car):
    for title, x, z in (("front", 2960.0, d.REAR_FLOOR - 3), ("rear", 3640.0, d.REAR_FLOOR - 15)):
        hat_beam(car, f"rear cross member {title}", [(x, y, z) for y in (-426, 0, 426)], (0, 0, -1), 80, 55,
                 "high strength", 1.4, length=lambda _: car.size.cabin)


def add_panels(car):
    mesh, size, width = car.mesh, car.size.rear, d.REAR_WIDTH
    part = car.sheet("rear seat back", "mild", 0.8)
    mesh.surface(part, lambda y, z: (3128 + 0.12 * (z - 420), y, z), divide((-width, width), size), divide((421, 893), size))
    part = car.sheet("shelf", "mild", 0.9)
    mesh.surface(part, lambda x, y: (x, y, d.SHELF), divide((3165, 3606), size), divide((-745, 745), size))
    part = car.sheet("rear panel", "mild", 0.9)
    mesh.surface(part, lambda y, z: (d.REAR_PANEL, y, z), divide((-670, 670), size), divide((300, 868), size))
    part = car.sheet("rear bumper beam", "high strength", 1.6)
    mesh.sweep(part, lambda y: [(x, y, z) for x, z in ((4190, 320), (4232, 320), (4232, 430), (4190, 430))],
               divide((-540, 540), size), size, closed=True)


def add_tank(car):
    mesh, tank = car.mesh, car.sheet("fuel tank", "mild", 1.2)
    low, high = (2620, -330, 190), (2875, 330, 385)
    xs, ys, zs = (divide((a, b), car.size.rear) for a, b in zip(low, high))
    for z in (low[2], high[2]):
        mesh.surface(tank, lambda x, y, z=z: (x, y, z), xs, ys)
    for y in (low[1], high[1]):
        mesh.surface(tank, lambda x, z, y=y: (x, y, z), xs, zs)
    for x in (low[0], high[0]):
        mesh.surface(tank, lambda y, z, x=x: (x, y, z), ys, zs)


def build(car):
    add_floor(car)
    add_cross_members(car)
    add_panels(car)
    add_tank(car)
