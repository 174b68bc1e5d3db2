# SPDX-License-Identifier: BSD-3-Clause
"""The whole car: body, instances of wheel and seat, welds, trim; and its files."""

from . import (body_cabin, body_front, body_rear, connections, deck, load_cases, main_file, masses, powertrain, seat, skin,
               suspension, wheel)
from . import dimensions as d
from .mesh import add
from .profiles import Car
from .welds import Welder


class Instance:
    """A file that is included in another place."""

    def __init__(self, name, offset, mesh, parts, place):
        self.name, self.offset, self.mesh, self.parts, self.place = name, offset, mesh, parts, place


def wheel_place(name):
    axle, s = d.WHEELS[name]
    return lambda p: (p[0] + axle, s * p[1] + s * d.TRACK / 2, p[2] + d.TYRE_RADIUS)


def instances_of(size):
    wheel_mesh, wheel_parts, hubs = wheel.build(size)
    seat_mesh, seat_parts = seat.build(size)
    found = [Instance(f"wheel {name}", offset, wheel_mesh, wheel_parts, wheel_place(name))
             for name, offset in suspension.OFFSETS.items()]
    for name, offset in deck.SEAT_OFFSETS.items():
        y = seat.OFFSET_Y if name == "right" else -seat.OFFSET_Y
        found.append(Instance(f"seat {name}", offset, seat_mesh, seat_parts, lambda p, y=y: add(p, (0.0, y, 0.0))))
    return found, hubs


def full_name(instance, part):
    """Name of a part of an instance: wheel front left rim, seat left frame."""
    return part if not instance else f"{instance} {part.removeprefix('seat ')}"


class Assembly:
    def __init__(self, size_name, case="wall"):
        self.size_name, self.case = size_name, case
        self.car = car = Car(d.SIZES[size_name])
        for builder in (body_front, body_cabin, body_rear, skin, powertrain, suspension):
            builder.build(car)
        self.instances, self.hubs = instances_of(car.size)
        self.weld()
        self.monitor()
        self.weigh()

    def weld(self):
        places = {p.name: (self.car.mesh, p.number, lambda x: x) for p in self.car.parts if p.touches and p.thickness}
        for instance in self.instances:
            if instance.name.startswith("seat"):
                for p in instance.parts:
                    if p.thickness:
                        places[full_name(instance.name, p.name)] = (instance.mesh, p.number, instance.place)
        self.welder = Welder(self.car, places)
        connections.weld_all(self.welder)

    def monitor(self):
        """Nodes of accelerometers with two neighbours each."""
        mesh, number = self.car.mesh, self.car.parts.number
        for title, part, point in (("B pillar left", "sill left plate", (d.B_PILLAR, -d.SILL_Y, 275)),
                                   ("B pillar right", "sill right plate", (d.B_PILLAR, d.SILL_Y, 275)),
                                   ("tunnel", "floor", (1850, 0, d.TUNNEL_HEIGHT)), ("engine", "engine", (640, -120, 790)),
                                   ("dash left", "dash", (d.DASH, -400, 500)), ("bumper", "bumper beam", (72, 0, 485))):
            nodes = sorted(mesh.nodes_of(number(part)),
                           key=lambda n: sum((a - b) ** 2 for a, b in zip(mesh.point(n), point)))
            first = nodes[0]
            along = next(n for n in nodes[1:] if abs(mesh.point(n)[0] - mesh.point(first)[0]) > 2) if title != "bumper" else nodes[1]
            other = next(n for n in nodes[1:] if n not in (first, along))
            self.car.monitors[title] = first, along, other

    def weigh(self):
        """Trim by number of part, and the mass properties with it."""
        fixed = masses.beam_moments(self.car)
        movable, numbers = {}, {}
        groups = [("", 0, self.car.mesh, self.car.parts, lambda p: p)]
        groups += [(i.name, deck.file_number(i.offset) * deck.PART_STEP, i.mesh, i.parts, i.place) for i in self.instances]
        self.part_masses = {}
        for prefix, base, mesh, parts, place in groups:
            for number, moments in masses.part_moments(mesh, parts, place).items():
                name = parts.of(number).name
                full = full_name(prefix, name)
                fixed.added(moments)
                self.part_masses[full] = moments.sums[0]
                if full in masses.TRIM:
                    movable[full], numbers[full] = moments, base + number
        missing = set(masses.TRIM) - set(movable)
        assert not missing, missing
        self.bare_mass = fixed.sums[0]
        self.trim_by_name = masses.solve_trim(fixed, movable)
        for name, mass in self.trim_by_name.items():
            fixed.added(movable[name], mass / movable[name].sums[0])
        self.trim = {numbers[name]: mass for name, mass in self.trim_by_name.items()}
        self.properties = fixed.about_centre()

    def elements(self):
        """Numbers of shells, solids and beams with all instances."""
        meshes = [self.car.mesh, *(i.mesh for i in self.instances)]
        return (sum(len(m.shells) for m in meshes), sum(len(m.solids) for m in meshes),
                len(self.car.welds) + len(self.car.rods))

    def files(self, options):
        """Names and lines."""
        by_kind = {i.name.split()[0]: i for i in self.instances}
        yield "car.k", main_file.main_file(self.car, self.size_name, self.case, [(i.offset, i.parts) for i in self.instances],
                                           self.trim, options)
        yield "body.k", deck.body_file(self.car, options.integrated)
        yield "wheel.k", deck.wheel_file(by_kind["wheel"].mesh, by_kind["wheel"].parts, self.hubs, wheel.PRESSURE)
        yield "seat.k", deck.seat_file(by_kind["seat"].mesh, by_kind["seat"].parts)
        if self.case == "offset":
            yield "barrier.k", load_cases.offset(self.car.size)
