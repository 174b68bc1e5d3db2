# SPDX-License-Identifier: BSD-3-Clause
"""car.k: controls, outputs, materials, sets, contacts, the includes, and the motion of the car."""

from dataclasses import dataclass

from . import materials
from .deck import PART_STEP, SETS, file_number, row, seats, set_cards, transformations
from .load_cases import BARRIER_PARTS, SPEEDS, barrier_cards, pole, wall
from .seat import OFFSET_Y

FRAMES = 50


@dataclass(frozen=True)
class Options:
    end_time: float = 100.0
    cycles: int = 0  # at most, 0 is no limit
    integrated: bool = False  # all deformable shells fully integrated
    all_edges: bool = False  # of shells touch, not only free ones

STEP = {"20k": 2.2e-3, "100k": 9.0e-4, "400k": 4.5e-4}  # *CONTROL_TIMESTEP DT2MS [ms]
# Intervals of the histories [ms].
HISTORIES = {"GLSTAT": 0.1, "MATSUM": 0.5, "RWFORC": 0.1, "RCFORC": 0.1, "SLEOUT": 0.5, "NODOUT": 0.05, "JNTFORC": 0.5,
             "SWFORC": 0.5, "ABSTAT": 0.5}


def histories(end_time):
    lines = [line for name, interval in HISTORIES.items() for line in (f"*DATABASE_{name}", row(interval, 2))]
    return [*lines, "*DATABASE_BINARY_D3PLOT", row(end_time / FRAMES)]


def controls(title, size, options, mesh_size):
    return f"""*KEYWORD
$ Written by make_car.py. Units: kg, mm, ms, kN, GPa.
*TITLE
{title}
*CONTROL_TERMINATION
{row(options.end_time, options.cycles)}
*CONTROL_TIMESTEP
$   dtinit    tssfac      isdo    tslimt     dt2ms
{row(0.0, 0.9, 0, 0.0, -STEP[size])}
*CONTROL_ENERGY
{row(2, 2, 2, 2)}
*CONTROL_SHELL
$   wrpang     esort     irnxx    istupd    theory       bwc
{row(20.0, 1, -1, 1, 2, 1)}
*CONTROL_HOURGLASS
{row(4, 0.01)}
*CONTROL_ACCURACY
$      osu       inn
{row(1, 2)}
*CONTROL_CONTACT
{row(0.1, 0.0, 2, 1, 1, 0, 1)}
{row(0, 0, 0, 0, 0.0)}
{row(0.0)}
$   ignore
{row(1)}
""".splitlines() + histories(options.end_time) + materials.cards(mesh_size.pitch)


def outputs(car):
    """Accelerometers: at B pillars, in the tunnel, on the engine."""
    yield "*ELEMENT_SEATBELT_ACCELEROMETER"
    for i, nodes in enumerate(car.monitors.values()):
        yield row(i + 1, *nodes, 0, 0, 0.0)


def part_sets(car, instances, barrier):
    """`instances`: (offset of the file, parts, whether they are sheet that welds are tied to)."""
    touching = [p.number for p in car.parts if p.touches]
    sheets = [p.number for p in car.parts if p.touches and p.thickness and p.material not in materials.RIGID]
    foam = []
    for offset, parts in instances:
        base = file_number(offset) * PART_STEP
        touching += [base + p.number for p in parts]
        sheets += [base + p.number for p in parts if p.thickness and p.material == "high strength"]
        foam += [base + p.number for p in parts if p.material == "seat foam"]
    if barrier:
        touching += [BARRIER_PARTS + k for k in (1, 2)]
    welds = [p.number for p in car.parts if p.material in materials.DIAMETERS]
    for name, members in (("touching", touching), ("sheets", sheets), ("welds", welds), ("foam", foam)):
        yield from set_cards("PART", SETS[name], members)


def contacts(all_edges):
    keyword = "*CONTACT_AUTOMATIC_GENERAL_INTERIOR_ID" if all_edges else "*CONTACT_AUTOMATIC_GENERAL_ID"
    return [keyword, row(1) + "car", row(SETS["touching"], 0, 2), row(0.15, 0.15, 0.0, 0.0, 20.0),
            row(1.0), row(1, 0.1), row(0.0), row(0, 1),
            "*CONTACT_SPOTWELD_ID", row(2) + "welds", row(SETS["welds"], SETS["sheets"], 2, 2), row(0.0), row(1.0),
            "*CONTACT_INTERIOR", row(SETS["foam"])]


def motion(case):
    speed = -SPEEDS[case] / 3.6
    exempt = BARRIER_PARTS + 2 if case == "offset" else 0
    return ["*INITIAL_VELOCITY", row(0, exempt), row(speed, 0.0, 0.0), *([row(0.0, 0.0, 0.0)] if exempt else [])]


def masses(trim):
    yield "*ELEMENT_MASS_PART"
    for number, mass in sorted(trim.items()):
        yield f"{number:8d}{mass:16.6f}"


def main_file(car, size, case, instances, trim, options):
    title = {"wall": "rigid wall", "offset": "offset deformable barrier", "pole": "pole"}[case]
    yield from controls(f"Small car, {size} elements, onto a {title} at {SPEEDS[case]:g} km/h", size, options, car.size)
    yield from outputs(car)
    yield from part_sets(car, instances, case == "offset")
    yield from contacts(options.all_edges)
    yield from motion(case)
    yield from masses(trim)
    yield from {"wall": wall, "pole": pole}[case](car.size) if case != "offset" else barrier_cards()
    yield from ["*INCLUDE", "body.k", *transformations(), *seats(OFFSET_Y), "*END"]
