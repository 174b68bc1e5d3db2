# SPDX-License-Identifier: BSD-3-Clause
"""The car as it is put together, and what all of its sheet is made of: hats with flanges, closing plates, curved panels."""

import math

from .dimensions import FLANGE
from .mesh import Mesh, add, blend, frame_at, path_stations, unit
from .parts import Parts


def side_name(s):
    return "right" if s > 0 else "left"


class Car:
    """What the builders fill."""

    def __init__(self, size):
        self.size = size
        self.mesh = Mesh()
        self.parts = Parts()
        self.bodies = []  # nodal rigid bodies: (title, nodes)
        self.extra_nodes = []  # (part, nodes) of rigid parts
        self.joints = []  # (kind, nodes, stiffness factor)
        self.springs = []  # (part, node, node)
        self.rods = []  # (part, node, node) trusses
        self.welds = []  # (part, node, node)
        self.inertia = {}  # rigid parts: part -> (mass, centre, Ixx, Iyy, Izz)
        self.monitors = {}  # title -> node

    def sheet(self, name, material, thickness, **more):
        return self.parts.sheet(name, material, thickness, **more)

    def near(self, part, point, radius):
        """Nodes of a part within a distance of a point."""
        return [n for n in sorted(self.mesh.nodes_of(part)) if math.dist(self.mesh.point(n), point) <= radius]


def hat_corners(path, across, widths, depths, flange, trigger, split_walls):
    """Corners of a hat over the parameter of the path: flange, wall, top, wall, flange. `trigger(s)` pushes the walls
    outwards and the top inwards."""
    def corners(s):
        point, upwards, _ = frame_at(path, across, s)
        i = min(int(s), len(path) - 2)
        width = widths[i] + (widths[i + 1] - widths[i]) * (s - i)
        depth = depths[i] + (depths[i + 1] - depths[i]) * (s - i)
        push = trigger(s)
        rows = [(-width / 2 - flange, 0), (-width / 2, 0), (-width / 2 - push, depth / 2), (-width / 2, depth),
                (0, depth - push), (width / 2, depth), (width / 2 + push, depth / 2), (width / 2, 0),
                (width / 2 + flange, 0)]
        if trigger is no_trigger and not split_walls:
            rows = [rows[k] for k in (0, 1, 3, 5, 7, 8)]
        return [add(add(point, upwards, w), across, d) for w, d in rows]
    return corners


def rounded(path, *values, bend=55.0):
    """A path with its corners rounded by quadratic curves that begin and end `bend` from them (less on short legs), and values
    that are given at its points likewise."""
    rows = [[*point, *(v[i] for v in values)] for i, point in enumerate(path)]
    result = [rows[0]]
    for before, corner, after in zip(rows, rows[1:], rows[2:]):
        lengths = math.dist(before[:3], corner[:3]), math.dist(after[:3], corner[:3])
        ends = [blend(corner, other, min(0.45, bend / length)) for other, length in zip((before, after), lengths)]
        for k in range(5):
            t = k / 4
            result.append(blend(blend(ends[0], corner, t), blend(corner, ends[1], t), t))
    result.append(rows[-1])
    return [tuple(row[:3]) for row in result], *([row[3 + i] for row in result] for i in range(len(values)))


def no_trigger(_):
    return 0.0


def hat_beam(car, name, path, across, widths, depths, material, thickness, plate=None, length=None, flange=FLANGE,
             trigger=no_trigger, gap=None, section=None, join=None,
             split_walls=False):
    """A hat that opens against `across` along a path of points in the plane of its flanges, with a closing plate
    (material, thickness) behind it. Returns the parts. With `join` it shares its nodes with the beam of that name where
    they meet."""
    across = unit(across)
    widths = [widths] * len(path) if isinstance(widths, (int, float)) else widths
    depths = [depths] * len(path) if isinstance(depths, (int, float)) else depths
    path, widths, depths = rounded(path, widths, depths)
    length = length or car.size.at
    stations = path_stations(path, length)
    section = section or min(length((path[0][0] + path[-1][0]) / 2), 1.2 * max(depths))
    part = car.sheet(name, material, thickness)
    if join:
        car.mesh.joined[part] = car.parts.number(join)
    car.mesh.sweep(part, hat_corners(path, across, widths, depths, flange, trigger, split_walls),
                   stations, section)
    if plate is None:
        return part, None
    closing = car.sheet(f"{name} plate", plate[0], plate[1])
    if join:
        car.mesh.joined[closing] = car.parts.number(f"{join} plate")
    distance = gap or max(2.0, 0.6 * (thickness + plate[1]))

    def edges(s):
        point, upwards, _ = frame_at(path, across, s)
        i = min(int(s), len(path) - 2)
        half = (widths[i] + (widths[i + 1] - widths[i]) * (s - i)) / 2
        base = add(point, across, -distance)
        return [add(base, upwards, w) for w in (-half - flange, -half, half, half + flange)]

    car.mesh.sweep(closing, edges, stations, section)
    return part, closing


def tray(outer, depth, flat=2.5, border=0.10):
    """An inner panel: `flat` behind the outer surface along its border, `depth(u, v)` behind it within. `outer(u, v)` gives
    the point and the direction inwards; u and v go from 0 to 1."""
    def inner(u, v):
        point, inwards = outer(u, v)
        edge = min(u, 1 - u, v, 1 - v)
        share = min(1.0, max(0.0, edge / border - 0.35) / 0.65)
        return add(point, inwards, flat + (depth(u, v) - flat) * share * share * (3 - 2 * share))
    return inner


def unit_divisions(length, size):
    count = max(2, round(length / size))
    return [i / count for i in range(count + 1)]
