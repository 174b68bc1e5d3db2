# SPDX-License-Identifier: BSD-3-Clause
"""Struts and lower arms in front, a twist beam axle behind: rigid bodies with joints, springs and dampers.

The wheels come from wheel.k; their hub nodes have the numbers HUB and HUB + 1 there."""

import math

from . import dimensions as d
from .mesh import add, blend, cross, minus, unit
from .powertrain import ARM_PIVOT, SUBFRAME
from .profiles import hat_beam, side_name

HUB = 900001  # number of a wheel's first hub node
OFFSETS = {name: 1000000 * (i + 1) for i, name in enumerate(d.WHEELS)}
HUB_WIDTH = 70.0
STRUT_TOP = (830.0, 585.0, 803.0)
STRUT_FOOT = (830.0, 622.0, 420.0)
BALL = (830.0, 655.0, 225.0)
PIVOT_REAR = (2840.0, 515.0, 330.0)


def bar(car, name, a, b, width, material="steel rigid"):
    """A rigid bar of square section from a to b."""
    part = car.parts.solid(name, material, touches=False)
    axis = unit(minus(b, a))
    e1 = unit(cross(axis, (1.0, 0.0, 0.0) if abs(axis[0]) < 0.8 else (0.0, 1.0, 0.0)))
    e2 = cross(axis, e1)
    car.mesh.block(part, lambda t, u, v: add(add(blend(a, b, t), e1, u), e2, v), (0.0, 0.5, 1.0), (-width / 2, width / 2),
                   (-width / 2, width / 2))
    return part


class Joints:
    """Nodes of joints are collected by the body that they belong to."""

    def __init__(self, car):
        self.car = car

    def pair(self, place, one, other):
        """Two nodes at a place, the first of the first body. A body is a list of nodes."""
        nodes = [self.car.mesh.node(place) for _ in range(2)]
        one.append(nodes[0])
        other.append(nodes[1])
        return nodes

    def spherical(self, place, one, other):
        self.car.joints.append(("SPHERICAL", self.pair(place, one, other), 5.0))

    def revolute(self, place, second, one, other, kind="REVOLUTE"):
        self.car.joints.append((kind, self.pair(place, one, other) + self.pair(second, one, other), 5.0))

    def hub(self, wheel, body):
        """The bearing of a wheel on a body."""
        axle, s = d.WHEELS[wheel]
        centre = (axle, s * d.TRACK / 2, d.TYRE_RADIUS)
        nodes = []
        for k in range(2):
            node = self.car.mesh.node(add(centre, (0.0, -s * HUB_WIDTH * k, 0.0)))
            body.append(node)
            nodes += [node, OFFSETS[wheel] + HUB + k]
        self.car.joints.append(("REVOLUTE", nodes, 5.0))


def mirrored(point, s):
    return (point[0], s * point[1], point[2])


def add_front(car, s):
    name, joints, mesh = side_name(s), Joints(car), car.mesh
    arm = bar(car, f"lower arm {name}", mirrored((930, ARM_PIVOT + 10, 250), s), mirrored(add(BALL, (8.0, -12.0, 0.0)), s), 34)
    knuckle = bar(car, f"knuckle {name}", mirrored((830, 655, 235), s), mirrored((830, 655, 400), s), 80)
    rod = bar(car, f"strut rod {name}", mirrored(blend(STRUT_FOOT, STRUT_TOP, 0.55), s),
              mirrored(blend(STRUT_FOOT, STRUT_TOP, 0.97), s), 20)
    of_arm, of_knuckle, of_rod, of_tower, of_frame = [], [], [], [], []
    of_tower += car.near(car.parts.number(f"strut tower {name}"), mirrored(STRUT_TOP, s), max(58.0, car.size.engine_bay))
    of_frame += car.near(car.parts.number("subframe"), mirrored((940, ARM_PIVOT, SUBFRAME[2]), s), 46.0)
    pivot = mirrored((905, ARM_PIVOT, 250), s), mirrored((975, ARM_PIVOT, 250), s)
    joints.revolute(*pivot, of_frame, of_arm)
    joints.spherical(mirrored(BALL, s), of_arm, of_knuckle)
    joints.revolute(mirrored(STRUT_FOOT, s), mirrored(blend(STRUT_FOOT, STRUT_TOP, 0.5), s), of_knuckle, of_rod, "CYLINDRICAL")
    joints.spherical(mirrored(STRUT_TOP, s), of_tower, of_rod)
    joints.hub(f"front {name}", of_knuckle)
    end = mesh.node(mirrored((935, 640, 262), s))
    of_knuckle.append(end)
    inner = mesh.node(mirrored((940, ARM_PIVOT, 262), s))
    of_frame.append(inner)
    car.rods.append((car.parts.number("rods"), end, inner))
    for title in ("front spring", "front damper"):
        part = car.parts.solid(title, title, touches=False)
        car.springs.append((part, of_tower[-1], of_knuckle[1]))
    for part, nodes in ((arm, of_arm), (knuckle, of_knuckle), (rod, of_rod)):
        car.extra_nodes.append((part, nodes))
    car.bodies += [(f"strut mount {name}", of_tower), (f"arm bushing {name}", of_frame)]


def add_rear(car):
    beam, _ = hat_beam(car, "twist beam", [(3060, y, 290) for y in (-470, 0, 470)], (0, 0, -1), 70, 60, "high strength", 3.0,
                       length=lambda _: car.size.cabin)
    for s in (1, -1):
        name, joints, mesh = side_name(s), Joints(car), car.mesh
        arm = bar(car, f"trailing arm {name}", mirrored(add(PIVOT_REAR, (12.0, 0.0, 0.0)), s), mirrored((3390, 575, 290), s), 46)
        of_arm, of_rail = [], []
        rail = car.parts.number(f"rear rail {name}")
        of_rail += car.near(rail, mirrored((PIVOT_REAR[0], d.RAIL_Y - 30, 320), s), 62.0)
        joints.revolute(mirrored(PIVOT_REAR, s), mirrored(add(PIVOT_REAR, (0.0, 60.0, 0.0)), s), of_rail, of_arm)
        joints.hub(f"rear {name}", of_arm)
        of_arm += [n for n in sorted(mesh.nodes_of(beam)) if s * mesh.point(n)[1] > 469]
        seat = min(mesh.nodes_of(rail), key=lambda n: math.dist(mesh.point(n), mirrored((3340, d.RAIL_Y - 40, 318), s)))
        foot = mesh.node(add(mesh.point(seat), (0.0, 0.0, -150.0)))
        of_arm.append(foot)
        for title in ("rear spring", "rear damper"):
            part = car.parts.solid(title, title, touches=False)
            car.springs.append((part, seat, foot))
        car.extra_nodes.append((arm, of_arm))
        car.bodies.append((f"trailing arm bushing {name}", of_rail))


def build(car):
    for s in (1, -1):
        add_front(car, s)
    add_rear(car)
