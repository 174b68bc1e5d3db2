# SPDX-License-Identifier: BSD-3-Clause
"""Engine and gearbox (rigid, bolted together), their mounts, and the subframe."""

from .body_front import rail_centre
from .mesh import divide
from .profiles import side_name

ENGINE = (436.0, -322.0, 318.0), (800.0, 70.0, 790.0)
GEARBOX = (520.0, 78.0, 285.0), (830.0, 335.0, 600.0)
BLOCK = 57.6  # length of the elements of rigid blocks, in all sizes
MOUNT = 590.0, 690.0
SUBFRAME = 895.0, 985.0, 246.0, 300.0  # x and z
ARM_PIVOT = 350.0


def add_engine(car):
    for name, (low, high) in (("engine", ENGINE), ("gearbox", GEARBOX)):
        part = car.parts.solid(name, "engine")
        car.mesh.box(part, low, high, BLOCK)
    for s, block in ((1, GEARBOX), (-1, ENGINE)):
        end = max(abs(block[0][1]), abs(block[1][1]))
        part = car.sheet(f"engine mount {side_name(s)}", "high strength", 3.5)
        xs = divide(MOUNT, car.size.engine_bay)
        ys = divide((end + 8, 432, 484), car.size.engine_bay)
        car.mesh.surface(part, lambda x, y: (x, s * y, 546.0), xs, ys)
        car.mesh.surface(part, lambda x, z: (x, s * (end + 8), z), xs, divide((500, 546), car.size.engine_bay))
        inner = [n for n in sorted(car.mesh.nodes_of(part)) if abs(car.mesh.point(n)[1]) < end + 9]
        car.extra_nodes.append((car.parts.number("engine"), inner))


def add_subframe(car):
    front, rear, low, high = SUBFRAME
    size = car.size.engine_bay
    part = car.sheet("subframe", "high strength", 2.2)
    car.mesh.sweep(part, lambda y: [(front, y, low), (front, y, high), (rear, y, high), (rear, y, low)],
                   divide((-484, -430, 430, 484), size), size, closed=True)
    for s in (1, -1):
        column = car.sheet(f"subframe mount {side_name(s)}", "high strength", 2.5)

        def corners(t):
            points = []
            for x, y in ((905, 438), (905, 480), (972, 480), (972, 438)):
                top = rail_centre(x) - 66 - 8
                points.append((x, s * y, high + 5 + t * (top - high - 5)))
            return points

        count = max(2, round(90 / size))
        car.mesh.sweep(column, corners, [i / count for i in range(count + 1)], size, closed=True)


def add_torque_rod(car):
    """From the engine's rear to the subframe."""
    nodes = [n for n in car.mesh.nodes_of(car.parts.number("subframe"))]
    target = (SUBFRAME[0], 0.0, SUBFRAME[3])
    foot = min(nodes, key=lambda n: sum((a - b) ** 2 for a, b in zip(car.mesh.point(n), target)))
    end = car.mesh.node((ENGINE[1][0] + 5, car.mesh.point(foot)[1], 350.0))
    car.extra_nodes.append((car.parts.number("engine"), [end]))
    car.rods.append((car.parts.sheet("rods", "rod", 0.0, touches=False), end, foot))


def build(car):
    add_engine(car)
    add_subframe(car)
    add_torque_rod(car)
