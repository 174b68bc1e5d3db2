# SPDX-License-Identifier: BSD-3-Clause
"""Keyword files: the car's body, its wheels and seats (each included with offsets and a transformation), the main file."""

from . import dimensions as d
from . import materials
from .materials import DIAMETERS, RIGID, SPRINGS, row
from .suspension import OFFSETS

SEAT_OFFSETS = {"right": 5000000, "left": 6000000}
PART_STEP = 1000  # numbers of parts, sections and sets of the k-th included file begin at k times this
SETS = {"touching": 1, "sheets": 2, "welds": 3, "foam": 4}
# Parts that fold: fully integrated shells, whose corners need no hourglass control.
CRUSHED = "crash box", "rail front", "upper rail", "radiator upper"


def file_number(offset):
    return offset // 1000000


def node_cards(mesh):
    yield "*NODE"
    for number, (x, y, z) in enumerate(mesh.points, 1):
        yield f"{number:8d}{x:16.9g}{y:16.9g}{z:16.9g}"


def element_cards(mesh):
    number = 0
    for keyword, elements in (("*ELEMENT_SHELL", mesh.shells), ("*ELEMENT_SOLID", mesh.solids)):
        if elements:
            yield keyword
        for element in elements:
            number += 1
            yield f"{number:8d}" + "".join(f"{value:8d}" for value in element)


def section_cards(part, mesh_kind, integrated=False):
    if part.material in DIAMETERS:
        return ["*SECTION_BEAM", row(part.number, 9, 1.0, 0, 1), row(DIAMETERS[part.material], DIAMETERS[part.material], 0.0, 0.0)]
    if part.material == "rod":
        return ["*SECTION_BEAM", row(part.number, 3), row(180.0)]
    if part.material in SPRINGS:
        return ["*SECTION_DISCRETE", row(part.number, 0)]
    if mesh_kind == "solid":
        return ["*SECTION_SOLID", row(part.number, 1)]
    points = 2 if part.material in RIGID else (3 if part.material in ("glass", "plastic", "tyre") else 5)
    full = (integrated or part.name.startswith(CRUSHED)) and part.material not in RIGID
    form = 16 if full else 2
    return ["*SECTION_SHELL", row(part.number, form, 0.833333, points), row(*[part.thickness] * 4)]


def part_cards(parts, integrated=False):
    for part in parts:
        kind = "shell" if part.thickness else "solid"
        yield from section_cards(part, kind, integrated)
        yield "*PART_CONTACT" if part.contact_thickness else "*PART"
        yield part.name
        yield row(part.number, part.number, materials.number(part.material))
        if part.contact_thickness:
            yield row(0.0, 0.0, 0.0, 0.0, part.contact_thickness)


def id_list(numbers):
    for at in range(0, len(numbers), 8):
        yield "".join(f"{number:10d}" for number in numbers[at:at + 8])


def set_cards(keyword, number, members):
    yield f"*SET_{keyword}_LIST"
    yield row(number)
    yield from id_list(members)


def body_file(car, integrated):
    """body.k: everything of the car but wheels, seats and controls."""
    yield "*KEYWORD"
    yield from part_cards(car.parts, integrated)
    yield from node_cards(car.mesh)
    yield from element_cards(car.mesh)
    yield "*ELEMENT_BEAM"
    number = 2000000
    for part, a, b in [*car.welds, *car.rods]:
        number += 1
        yield f"{number:8d}{part:8d}{a:8d}{b:8d}{0:8d}"
    yield "*ELEMENT_DISCRETE"
    for i, (part, a, b) in enumerate(car.springs):
        yield f"{3000001 + i:8d}{part:8d}{a:8d}{b:8d}"
    sets = 100
    for title, nodes in car.bodies:
        sets += 1
        yield from set_cards("NODE", sets, nodes)
        yield "*CONSTRAINED_NODAL_RIGID_BODY_TITLE"
        yield title
        yield row(800 + sets, 0, sets)
    for part, nodes in car.extra_nodes:
        sets += 1
        yield from set_cards("NODE", sets, nodes)
        yield "*CONSTRAINED_EXTRA_NODES_SET"
        yield row(part, sets)
    yield "*CONSTRAINED_RIGID_BODIES"
    yield row(car.parts.number("engine"), car.parts.number("gearbox"))
    for kind, nodes, factor in car.joints:
        yield f"*CONSTRAINED_JOINT_{kind}"
        yield row(*nodes, *[0] * (6 - len(nodes)), factor, 1.0)
    yield "*END"


def wheel_file(mesh, parts, hubs, pressure):
    yield "*KEYWORD"
    yield from part_cards(parts)
    yield from node_cards(mesh)
    for number, (x, y, z) in hubs:
        yield f"{number:8d}{x:16.9g}{y:16.9g}{z:16.9g}"
    yield from element_cards(mesh)
    rim, disc, tyre = (parts.number(name) for name in ("rim", "wheel disc", "tyre"))
    yield "*CONSTRAINED_RIGID_BODIES"
    yield row(rim, disc)
    yield from set_cards("NODE", 1, [number for number, _ in hubs])
    yield "*CONSTRAINED_EXTRA_NODES_SET"
    yield row(rim, 1)
    yield from set_cards("PART", 1, [tyre, rim])
    yield "*AIRBAG_SIMPLE_PRESSURE_VOLUME_ID"
    yield row(1) + "tyre"
    yield row(1, 1)
    yield row(pressure, 1.0)
    yield "*END"


def seat_file(mesh, parts):
    yield "*KEYWORD"
    yield from part_cards(parts)
    yield from node_cards(mesh)
    yield from element_cards(mesh)
    yield "*END"


def include(name, offset, transformation):
    k = file_number(offset) * PART_STEP
    return ["*INCLUDE_TRANSFORM", name, row(offset, offset, k, 0, k, 0, 0), row(k), row(0.0, 0.0, 0.0, 0.0), row(transformation)]


def transformations():
    """Wheels and seats: the left ones are the mirrored right ones."""
    lines = []
    for name, offset in OFFSETS.items():
        axle, s = d.WHEELS[name]
        lines += ["*DEFINE_TRANSFORMATION", row(file_number(offset))]
        if s < 0:
            lines.append(row("MIRROR", 0.0, 0.0, 0.0, 0.0, 1.0, 0.0))
        lines.append(row("TRANSL", axle, s * d.TRACK / 2, d.TYRE_RADIUS))
        lines += include("wheel.k", offset, file_number(offset))
    return lines


def seats(offset_y):
    lines = []
    for name, offset in SEAT_OFFSETS.items():
        lines += ["*DEFINE_TRANSFORMATION", row(file_number(offset)),
                  row("TRANSL", 0.0, offset_y if name == "right" else -offset_y, 0.0)]
        lines += include("seat.k", offset, file_number(offset))
    return lines
