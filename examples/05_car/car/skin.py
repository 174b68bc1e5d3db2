# SPDX-License-Identifier: BSD-3-Clause
"""What is seen from outside: fascias, bonnet, fenders, doors, quarters, boot lid, glass."""

import math

from . import dimensions as d
from .body_front import upper_rail_at
from .mesh import blend, divide
from .profiles import side_name, tray, unit_divisions

FENDER = 398.0, 1242.0
DOORS = {"front": (1254.0, 2212.0), "rear": (2226.0, 3040.0)}
DOOR_BOTTOM = 354.0


def fascia_front(y, z):
    x = 8 + 235 * (abs(y) / 745) ** 4.5
    return x + 55 * ((z - 480) / 230) ** 2 if z > 480 else x + 35 * ((480 - z) / 230) ** 2


def arch(x, axle, base):
    """Lower edge of a panel with a wheel arch."""
    inside = d.ARCH_RADIUS ** 2 - (x - axle) ** 2
    return max(base, d.TYRE_RADIUS + math.sqrt(inside)) if inside > 0 else base


def arch_breaks(begin, end, axle):
    reach = math.sqrt(d.ARCH_RADIUS ** 2 - 20 ** 2)
    return sorted({begin, end, *(x for x in (axle - reach, axle - 0.75 * reach, axle, axle + 0.75 * reach, axle + reach)
                                 if begin < x < end)})


def add_fascias(car):
    part = car.sheet("front fascia", "plastic", 3.0)
    size = car.size.rear

    def front(t, v):
        """t from -1 to 1 over the front, beyond along the sides; v from the lower edge to the bonnet."""
        y = max(-1.0, min(1.0, t)) * 745
        beyond = max(0.0, abs(t) - 1)
        x = fascia_front(abs(y), 480)
        z = 225 + v * (d.bonnet(x + beyond * (390 - x) + 40) - 10 - 225)
        x = fascia_front(abs(y), z)
        x += beyond * (390 - x)
        return (x, math.copysign(abs(y) + beyond * (d.side(390, z) - 745), t), z)

    count = max(4, round(1600 / size))
    sides = max(2, round(140 / size))
    ts = [-2 + i / sides for i in range(sides)] + [-1 + 2 * i / count for i in range(count)] + [
        1 + i / sides for i in range(sides + 1)]
    car.mesh.surface(part, front, ts, unit_divisions(500, size))
    part = car.sheet("rear fascia", "plastic", 3.0)
    car.mesh.surface(part, lambda y, z: (4300 - 110 * (abs(y) / 745) ** 4 - 25 * ((z - 450) / 200) ** 2, y, z),
                     divide((-742, 742), size), divide((265, 655), size))


def bonnet_lead(y):
    """Leading edge of the bonnet."""
    return 92 + 235 * (abs(y) / 745) ** 4.5


def bonnet_point(u, v):
    t = 2 * v - 1
    rear = d.BONNET_REAR
    lead = bonnet_lead(t * 680)
    x = lead + u * (rear - lead)
    half = d.side(x, d.bonnet(x)) - 30
    return (x, t * half, d.bonnet(x) + 6 + d.BONNET_CROWN * (1 - t * t) * min(1.0, 0.35 + u)), (0, 0, -1)


def add_bonnet(car):
    us, vs = unit_divisions(1000, car.size.engine_bay * 1.2), unit_divisions(1400, car.size.engine_bay * 1.4)
    outer = car.sheet("bonnet", "mild", 0.7)
    car.mesh.surface(outer, lambda u, v: bonnet_point(u, v)[0], us, vs)
    inner = car.sheet("bonnet inner", "mild", 0.6)

    def depth(u, v):
        crease = 14 * math.exp(-((u - 0.45) / 0.05) ** 2)  # where the bonnet shall fold
        return 22 - crease

    car.mesh.surface(inner, tray(bonnet_point, depth), us, vs)


def add_fenders(car):
    for s in (1, -1):
        def section(x):
            top = d.bonnet(x)
            low = min(arch(x, d.FRONT_AXLE, 300), top - 60)
            y_rail, z_rail = upper_rail_at(x)
            rows = [(d.side(x, z), z) for z in (low + (top - low) * k / 4 for k in range(5))]
            return [(x, s * y, z) for y, z in [*rows, (d.side(x, top) - 26, top - 3), (max(y_rail + 34, 768 if x > 1150 else 0), z_rail + 36)]]

        part = car.sheet(f"fender {side_name(s)}", "mild", 0.7)
        car.mesh.sweep(part, section, divide(arch_breaks(*FENDER, d.FRONT_AXLE), car.size.rear), car.size.rear)


def glass_top(x):
    """Upper edge of side glass: below the frame of the roof."""
    path = [(p[0], p[2]) for p in d.ROOF_FRAME]
    return d.between(path, x) - 46 * (1.35 if x < 1890 or x > 3110 else 1.0)


def add_doors(car):
    for s in (1, -1):
        for title, (begin, end) in DOORS.items():
            name = f"{title} door {side_name(s)}"

            def outer(u, v):
                z = DOOR_BOTTOM + v * (d.BELT - 5 - DOOR_BOTTOM)
                x = begin + u * (end - begin)
                if title == "rear":
                    x = begin + u * (min(end, d.REAR_AXLE - math.sqrt(max(0.0, 375 ** 2 - (z - d.TYRE_RADIUS) ** 2)) + 20)
                                     - begin)
                return (x, s * d.side(x, z), z), (0, -s, 0)

            us, vs = unit_divisions(end - begin, car.size.cabin), unit_divisions(d.BELT - DOOR_BOTTOM, car.size.cabin)
            car.mesh.surface(car.sheet(f"{name} outer", "mild", 0.7), lambda u, v: outer(u, v)[0], us, vs)
            car.mesh.surface(car.sheet(f"{name} inner", "mild", 0.9), tray(outer, lambda u, v: 42.0), us, vs)
            add_door_beam(car, name, s, begin, end)
            add_side_glass(car, f"{title} side glass {side_name(s)}", s, begin, end)


def add_door_beam(car, name, s, begin, end):
    """The tube against side impacts, which carries the door in a frontal one."""
    part = car.sheet(f"{name} beam", "ultra high strength", 2.0)
    ring = [(16 * math.cos(a * math.pi / 2), 16 * math.sin(a * math.pi / 2)) for a in range(4)]
    rise = -0.10 if name.startswith("front") else 0.02

    def corners(x):
        z = 640 + rise * (x - begin)
        y = d.side(x, z) - 24
        return [(x, s * (y + a), z + b) for a, b in ring]

    last = end if name.startswith("front") else end - 60
    inset = 0.125 * (end - begin)  # where the inner panel has its full depth
    car.mesh.sweep(part, corners, divide((begin + inset, last - inset), car.size.cabin), 30, closed=True)


def add_side_glass(car, name, s, begin, end):
    part = car.sheet(name, "glass", 3.5)
    begin, end = max(begin, 1330.0) + 25, (end - 30 if end < 2300 else 3400.0)

    def point(x, v):
        low = d.BELT + (16 if end > 2300 else 1)
        z = low + v * (glass_top(x) - low)
        return (x, s * (d.side(x, z) - 8), z)

    height = 400
    car.mesh.surface(part, point, divide((begin, end), car.size.rear), unit_divisions(height, car.size.rear))


def add_quarters(car):
    for s in (1, -1):
        def section(x):
            low = arch(x, d.REAR_AXLE, 300)
            top = d.BELT + 5 - 20 * max(0.0, (x - 3600) / 600)
            rows = [(d.side(x, z), z) for z in (low + (top - low) * k / 4 for k in range(5))]
            return [(x, s * y, z) for y, z in [*rows, (d.side(x, top) - 60, top + 4)]]

        part = car.sheet(f"quarter {side_name(s)}", "mild", 0.7)
        car.mesh.sweep(part, section, divide(arch_breaks(3062, 4150, d.REAR_AXLE), car.size.rear), car.size.rear)


def add_boot_lid(car):
    part = car.sheet("boot lid", "mild", 0.8)
    outline = [(3622, 948), (3900, 952), (4150, 938), (4205, 905), (4228, 700)]
    car.mesh.sweep(part, lambda y: [(x, y, z + 14 * (1 - (y / 655) ** 2)) for x, z in outline],
                   divide((-655, 655), car.size.rear), car.size.rear)


def add_screens(car):
    """Windscreen and rear window: outside of the pillars' upper flanges."""
    def screen(name, low, high, low_half, high_half, thickness, bulge):
        part = car.sheet(name, "glass", thickness)

        def point(u, v):
            t = 2 * v - 1
            x, z = blend(low, high, u)
            half = low_half + (high_half - low_half) * u
            return (x - bulge * (1 - t * t), t * half, z + abs(bulge) * 0.25 * (1 - t * t))

        length = math.dist(low, high)
        car.mesh.surface(part, point, unit_divisions(length, car.size.rear), unit_divisions(2 * high_half, car.size.rear))

    screen("windscreen", (1206, 956), (1894, 1409), 716, 590, 5.0, 30)
    screen("rear window", (3592, 920), (3110, 1402), 688, 590, 4.0, -20)


def build(car):
    add_fascias(car)
    add_bonnet(car)
    add_fenders(car)
    add_doors(car)
    add_quarters(car)
    add_boot_lid(car)
    add_screens(car)
