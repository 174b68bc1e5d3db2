# SPDX-License-Identifier: BSD-3-Clause
"""Welds between sheets that need no matching nodes: from a node of one sheet to the nearest point of the other.

Each end of a weld beam has a node of its own, which lies on its sheet; *CONTACT_SPOTWELD ties it there. Elements at nodes
of rigid bodies take no welds: a node cannot follow a deformable sheet and a rigid body at once."""

import math
from collections import defaultdict

from .mesh import add, cross, dot, minus

CELL = 80.0
KINDS = ("spot", "seam", "bolt")
SHORTEST = 0.8  # of a weld beam [mm]


def nearest_in_triangle(p, a, b, c):
    """Nearest point of a triangle (C. Ericson, Real-Time Collision Detection, 2004, 5.1.5)."""
    ab, ac, ap = minus(b, a), minus(c, a), minus(p, a)
    d1, d2 = dot(ab, ap), dot(ac, ap)
    if d1 <= 0 and d2 <= 0:
        return a
    bp = minus(p, b)
    d3, d4 = dot(ab, bp), dot(ac, bp)
    if d3 >= 0 and d4 <= d3:
        return b
    if d1 * d4 - d3 * d2 <= 0 <= d1 and d3 <= 0:
        return add(a, ab, d1 / (d1 - d3))
    cp = minus(p, c)
    d5, d6 = dot(ab, cp), dot(ac, cp)
    if d6 >= 0 and d5 <= d6:
        return c
    if d5 * d2 - d1 * d6 <= 0 <= d2 and d6 <= 0:
        return add(a, ac, d2 / (d2 - d6))
    if d3 * d6 - d5 * d4 <= 0 and d4 >= d3 and d5 >= d6:
        return add(b, minus(c, b), (d4 - d3) / (d4 - d3 + d5 - d6))
    normal = cross(ab, ac)
    size = dot(normal, normal)
    if size == 0:
        return a
    return add(p, normal, -dot(ap, normal) / size)


class Sheet:
    """The shells of a part, in cells, with their four triangles about the mean of the corners."""

    def __init__(self, mesh, part, place, rigid):
        shells = [shell[1:] for shell in mesh.shells if shell[0] == part]
        near_rigid = {n for shell in shells if rigid.intersection(shell) for n in shell}
        self.nodes = {}  # usable nodes -> place
        self.cells = defaultdict(list)
        for shell in shells:
            points = [place(mesh.point(n)) for n in shell]
            for n, point in zip(shell, points):
                if n not in near_rigid:
                    self.nodes[n] = point
            if near_rigid.intersection(shell):
                continue
            middle = tuple(sum(x) / 4 for x in zip(*points))
            if shell[2] == shell[3]:
                triangles = [points[:3]]
            else:
                triangles = [(points[i], points[(i + 1) % 4], middle) for i in range(4)]
            low = [min(x) for x in zip(*points)]
            high = [max(x) for x in zip(*points)]
            ranges = [range(int(a // CELL), int(b // CELL) + 1) for a, b in zip(low, high)]
            for i in ranges[0]:
                for j in ranges[1]:
                    for k in ranges[2]:
                        self.cells[i, j, k].append(triangles)

    def nearest(self, point, reach):
        """The nearest point within reach and its distance, or None."""
        best, found = reach, None
        ranges = [range(int((x - reach) // CELL), int((x + reach) // CELL) + 1) for x in point]
        for i in ranges[0]:
            for j in ranges[1]:
                for k in ranges[2]:
                    for triangles in self.cells.get((i, j, k), ()):
                        for triangle in triangles:
                            place = nearest_in_triangle(point, *triangle)
                            distance = math.dist(place, point)
                            if distance < best:
                                best, found = distance, place
        return found


class Welder:
    """Makes weld beams in the mesh of the car. `places` maps a name to (mesh, part, transformation of points)."""

    def __init__(self, car, places):
        self.car, self.places, self.sheets = car, places, {}
        self.rigid = {n for _, nodes in car.bodies for n in nodes} | {n for _, nodes in car.extra_nodes for n in nodes}
        self.parts = {kind: car.parts.solid(f"welds: {kind}", f"weld {kind}", touches=False) for kind in KINDS}
        self.unused = []  # connections that found no place

    def sheet(self, name):
        if name not in self.sheets:
            mesh, part, place = self.places[name]
            self.sheets[name] = Sheet(mesh, part, place, self.rigid if mesh is self.car.mesh else set())
        return self.sheets[name]

    def join(self, one, other, reach, kind="spot", pitch=None):
        """Welds from nodes of a sheet to another sheet within reach, no nearer to each other than the pitch."""
        pitch = pitch or self.car.size.pitch
        first, second = self.sheet(one), self.sheet(other)
        taken, count = defaultdict(list), 0
        for node in sorted(first.nodes, key=lambda n: first.nodes[n]):
            point = first.nodes[node]
            cell = tuple(int(x // pitch) for x in point)
            around = [p for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)
                      for p in taken.get((cell[0] + i, cell[1] + j, cell[2] + k), ())]
            if any(math.dist(p, point) < 0.97 * pitch for p in around):
                continue
            end = second.nearest(point, reach)
            if end is None or math.dist(end, point) < SHORTEST:
                continue
            taken[cell].append(point)
            self.car.welds.append((self.parts[kind], self.car.mesh.node(point), self.car.mesh.node(end)))
            count += 1
        if count == 0:
            self.unused.append((one, other))
        return count
