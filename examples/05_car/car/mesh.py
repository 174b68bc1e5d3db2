# SPDX-License-Identifier: BSD-3-Clause
"""Nodes and elements: surfaces over a grid of parameters, and sections that are swept along a path."""

import math


def add(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    size = math.sqrt(dot(a, a))
    return tuple(x / size for x in a)


def blend(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def divide(breaks, length):
    """Values from the first break to the last that meet each one, about `length` (a number, or a function) apart."""
    values = [breaks[0]]
    for a, b in zip(breaks, breaks[1:]):
        size = length((a + b) / 2) if callable(length) else length
        count = max(1, round(abs(b - a) / size))
        values += [a + (b - a) * (i + 1) / count for i in range(count)]
    return values


class Mesh:
    """Nodes are numbered from 1 in the order in which they are made. Nodes of a part that lie at one place are one."""

    def __init__(self):
        self.points = []
        self.shells = []  # (part, four nodes)
        self.solids = []  # (part, eight nodes)
        self.beams = []  # (part, two nodes, third node or 0)
        self.places = {}
        self.joined = {}  # part -> the part whose nodes it shares where they lie at one place

    def node(self, point):
        """A node of its own."""
        self.points.append(tuple(float(x) for x in point))
        return len(self.points)

    def part_node(self, part, point):
        key = (self.joined.get(part, part), *(round(x * 10) for x in point))
        if key not in self.places:
            self.places[key] = self.node(point)
        return self.places[key]

    def point(self, node):
        return self.points[node - 1]

    def shell(self, part, nodes):
        """A shell; two equal neighbours make it a triangle, three nothing."""
        kept = [n for i, n in enumerate(nodes) if n != nodes[i - 1]]
        if len(kept) == 3:
            kept.append(kept[2])
        if len(kept) == 4 and len(set(kept)) > 2:
            self.shells.append((part, *kept))

    def surface(self, part, function, us, vs):
        """Shells on the points function(u, v); returns the grid of nodes."""
        grid = [[self.part_node(part, function(u, v)) for v in vs] for u in us]
        for one, other in zip(grid, grid[1:]):
            for j in range(len(vs) - 1):
                self.shell(part, (one[j], other[j], other[j + 1], one[j + 1]))
        return grid

    def sweep(self, part, corners, stations, length, closed=False):
        """Shells on the lines between the corners(s) of a section (points) as s takes the values of `stations`."""
        sections = [list(corners(s)) for s in stations]
        if closed:
            sections = [points + points[:1] for points in sections]
        counts = [max(1, round(max(math.dist(points[i], points[i + 1]) for points in sections) / length))
                  for i in range(len(sections[0]) - 1)]
        places = [i + (k / count) for i, count in enumerate(counts) for k in range(count)] + [float(len(counts))]

        def at(row, v):
            points, i = sections[row], min(int(v), len(counts) - 1)
            return blend(points[i], points[i + 1], v - i)

        return self.surface(part, at, range(len(stations)), places)

    def block(self, part, function, us, vs, ws):
        """Hexahedra on the points function(u, v, w)."""
        nodes = [[[self.part_node(part, function(u, v, w)) for w in ws] for v in vs] for u in us]
        for i in range(len(us) - 1):
            for j in range(len(vs) - 1):
                for k in range(len(ws) - 1):
                    a, b = nodes[i], nodes[i + 1]
                    self.solids.append((part, a[j][k], b[j][k], b[j + 1][k], a[j + 1][k], a[j][k + 1], b[j][k + 1],
                                        b[j + 1][k + 1], a[j + 1][k + 1]))
        return nodes

    def box(self, part, low, high, length):
        """Hexahedra that fill a box."""
        axes = [divide((a, b), length) for a, b in zip(low, high)]
        return self.block(part, lambda x, y, z: (x, y, z), *axes)

    def nodes_of(self, part):
        found = {n for shell in self.shells if shell[0] == part for n in shell[1:]}
        return found | {n for solid in self.solids if solid[0] == part for n in solid[1:]}


def frame_at(path, across, s):
    """Point and the direction across the path in the plane normal to `across`, at s in [0, number of legs]."""
    i = min(int(s), len(path) - 2)
    point = blend(path[i], path[i + 1], s - i)
    legs = [unit(minus(b, a)) for a, b in zip(path, path[1:])]
    if s == int(s) and 0 < s < len(legs):
        tangent = unit(add(legs[int(s) - 1], legs[int(s)]))
    else:
        tangent = legs[i]
    return point, unit(cross(across, tangent)), tangent


def path_stations(path, length):
    """Parameters along a path whose points are `length` (a function of x) apart."""
    stations = [0.0]
    for i, (a, b) in enumerate(zip(path, path[1:])):
        distance = math.dist(a, b)
        count = max(1, round(distance / length((a[0] + b[0]) / 2)))
        stations += [i + (k + 1) / count for k in range(count)]
    return stations


def unit_divisions_of(low, high, length):
    """At least three values from low to high."""
    count = max(2, round((high - low) / length))
    return [low + (high - low) * i / count for i in range(count + 1)]
