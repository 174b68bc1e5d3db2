# SPDX-License-Identifier: BSD-3-Clause
"""The body in front of the dash: bumper beam, crash boxes, rails with crush initiators, aprons, strut towers, upper
rails, radiator with its frame."""

import math

from . import dimensions as d
from .mesh import divide, frame_at
from .profiles import hat_beam, side_name

BEAM_DEPTH, BEAM_BOTTOM, BEAM_TOP = 48.0, 425.0, 545.0
BOX_END = 278.0
PLATE = 282.5
BOX = 430.0, 490.0, 433.0, 537.0  # y and z of the crash boxes
TOWER = 742.0, 918.0
TRIGGERS = (338.0, 418.0, 498.0)  # of the rails, one fold apart
TRIGGER_LENGTH, TRIGGER_DEPTH = 60.0, 3.0
UPPER_RAIL = [(262, 633, 700), (700, 655, 752), (1196, 703, 806)]


def beam_front(y):
    return 74.0 + 52.0 * (y / 600.0) ** 2


def rail_trigger(s):
    """Push of the rail's faces at the parameter of its path, which is straight up to 1 [mm]."""
    x = d.RAIL_FRONT + s * (d.RAIL[1][0] - d.RAIL_FRONT) if s <= 1 else math.inf
    return sum(TRIGGER_DEPTH * math.cos(math.pi * (x - at) / TRIGGER_LENGTH) ** 2
               for at in TRIGGERS if abs(x - at) < TRIGGER_LENGTH / 2)


def add_bumper(car):
    mesh, size = car.mesh, car.size
    part = car.sheet("bumper beam", "high strength", 1.6)

    def corners(y):
        x = beam_front(y)
        return [(x, y, BEAM_BOTTOM), (x, y, BEAM_TOP), (x + BEAM_DEPTH, y, BEAM_TOP), (x + BEAM_DEPTH, y, BEAM_BOTTOM)]

    mesh.sweep(part, corners, divide((-570, -460, 0, 460, 570), size.engine_bay), size.engine_bay, closed=True)
    for s in (1, -1):
        add_crash_box(car, s)


def add_crash_box(car, s):
    part = car.sheet(f"crash box {side_name(s)}", "mild", 1.6)
    inner, outer, low, high = BOX

    def corners(t):
        bead = 2.5 * math.cos(math.pi * (t - 0.3) / 0.4) ** 2 if 0.1 < t < 0.5 else 0.0
        corner_points = []
        for y, z, dy, dz in [(inner, low, 0, 0), (inner, (low + high) / 2, bead, 0), (inner, high, 0, 0),
                             ((inner + outer) / 2, high, 0, bead), (outer, high, 0, 0),
                             (outer, (low + high) / 2, -bead, 0), (outer, low, 0, 0), ((inner + outer) / 2, low, 0, -bead)]:
            front = beam_front(y) + BEAM_DEPTH + 4.0
            corner_points.append((front + t * (BOX_END - front), s * (y + dy), z + dz))
        return corner_points

    count = max(3, round((BOX_END - 165) / car.size.front))
    car.mesh.sweep(part, corners, [i / count for i in range(count + 1)], car.size.front, closed=True)
    plate = car.sheet(f"rail end plate {side_name(s)}", "high strength", 3.0)
    car.mesh.surface(plate, lambda y, z: (PLATE, s * y, z), divide((404, 430, 490, 516), car.size.front),
                     divide((402, 430, 540, 568), car.size.front))


def add_rails(car):
    """Front rails, which run on under the floor: thin where they shall fold, thick behind."""
    for s in (1, -1):
        path = [(x, s * (d.RAIL_Y - 2), z) for x, z, _ in d.RAIL]
        heights = [height for _, _, height in d.RAIL]
        name = side_name(s)

        def length(x):
            return car.size.front if x < 760 else (1.3 * car.size.front if x < 1420 else car.size.cabin)

        split = 0.62  # of the straight front part
        before = [path[0], tuple(a + split * (b - a) for a, b in zip(path[0], path[1]))]
        hat_beam(car, f"rail front {name}", before, (0, -s, 0), heights[:2], d.RAIL_DEPTH, "rail", 1.7,
                 plate=("rail", 1.4), length=length, trigger=lambda t: rail_trigger(split * t), gap=2.2,
                 section=1.1 * car.size.front)
        behind = [before[1], *path[1:]]
        hat_beam(car, f"rail {name}", behind, (0, -s, 0), heights, d.RAIL_DEPTH, "high strength", 2.4,
                 plate=("high strength", 2.0), length=length, gap=2.2, section=1.1 * car.size.front,
                 join=f"rail front {name}", split_walls=True)


def apron_height(x):
    """Lower edge of the apron: the rail's upper face [mm]."""
    return d.between([(x0, z + height / 2) for x0, z, height in d.RAIL], x)


def upper_rail_at(x):
    return d.between([(p[0], p[1]) for p in UPPER_RAIL], x), d.between([(p[0], p[2]) for p in UPPER_RAIL], x)


def add_aprons(car):
    """Inner wheel houses, strut towers between them, upper rails along their upper edges."""
    for s in (1, -1):
        name = side_name(s)
        hat_beam(car, f"upper rail {name}", [(x, s * y, z) for x, y, z in UPPER_RAIL], (0, s, 0), 62, 46,
                 "high strength", 1.2, plate=("mild", 1.0))

        def apron(x):
            y, z = upper_rail_at(x)
            low = apron_height(x) + 3
            return [(x, s * 494, low - 4), (x, s * 494, max(low + 30, 640)), (x, s * (y - 7), z - 24), (x, s * (y - 7), z + 26)]

        part = car.sheet(f"apron {name}", "mild", 1.0)
        car.mesh.sweep(part, apron, divide((345, TOWER[0] - 5), car.size.at), car.size.engine_bay)
        car.mesh.sweep(part, apron, divide((TOWER[1] + 5, 1138), car.size.at), car.size.engine_bay)

        def tower(x):
            y, z = upper_rail_at(x)
            low = apron_height(x) + 3
            return [(x, s * 494, low - 4), (x, s * 497, 690), (x, s * 535, 806), (x, s * 640, 795), (x, s * (y - 6), 780),
                    (x, s * (y - 6), z - 30)]

        part = car.sheet(f"strut tower {name}", "high strength", 2.0)
        car.mesh.sweep(part, tower, divide(TOWER, car.size.at), car.size.engine_bay)


def add_radiator(car):
    """Upper and lower member of its frame, and the radiator, which is a sheet with the mass of all coolers and fans."""
    hat_beam(car, "radiator upper member", [(300, y, 716) for y in (-622, 0, 622)], (1, 0, 0), 44, 34, "mild", 1.0,
             plate=("mild", 0.8), length=lambda _: car.size.engine_bay)
    hat_beam(car, "radiator lower member", [(303, y, 472) for y in (-424, 0, 424)], (1, 0, 0), 44, 34, "mild", 1.2,
             plate=("mild", 0.8), length=lambda _: car.size.engine_bay)
    part = car.sheet("radiator", "aluminium", 1.5, contact_thickness=8.0)
    car.mesh.surface(part, lambda y, z: (288, y, z), divide((-340, 340), 1.3 * car.size.engine_bay),
                     divide((335, 705), 1.3 * car.size.engine_bay))


def build(car):
    add_bumper(car)
    add_rails(car)
    add_aprons(car)
    add_radiator(car)


def rail_centre(x):
    """Height of the rail's centre line at x."""
    path = [(row[0], 0, row[1]) for row in d.RAIL]
    for i, (a, b) in enumerate(zip(path, path[1:])):
        if a[0] <= x <= b[0]:
            return frame_at(path, (0, 1, 0), i + (x - a[0]) / (b[0] - a[0]))[0][2]
    raise ValueError(x)
