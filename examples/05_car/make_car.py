#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a small car of folded sheet panels that runs onto a wall, a deformable barrier or a pole: car.k and the files that
it includes.

    ./make_car.py -o car_20k                                  20 000 elements, 56 km/h onto a rigid wall
    ./make_car.py --size 100k --case offset -o car_offset     64 km/h, 40 % overlap
"""

import argparse
import pathlib
import sys

from car import dimensions, load_cases, main_file
from car.assembly import Assembly


def report(assembly, out=sys.stdout):
    shells, solids, beams = assembly.elements()
    print(f"{shells} shells, {solids} solids, {beams} beams (welds and rods), {len(assembly.car.mesh.points)} nodes of the body",
          file=out)
    p = assembly.properties
    print(f"meshed {assembly.bare_mass:.1f} kg, with trim {p['mass']:.1f} kg; centre x {p['x']:.1f} (behind the front axle"
          f" {p['x'] - dimensions.FRONT_AXLE:.1f}), y {p['y']:.1f}, z {p['z']:.1f} mm;"
          f" roll {p['roll'] / 1e6:.1f}, pitch {p['pitch'] / 1e6:.1f}, yaw {p['yaw'] / 1e6:.1f} kg m2", file=out)
    for one, other in assembly.welder.unused:
        print(f"no weld between {one} and {other}", file=out)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", choices=dimensions.SIZES, default="20k", help="elements, about (default 20k)")
    parser.add_argument("--case", choices=load_cases.SPEEDS, default="wall", help="what the car runs onto (default wall)")
    parser.add_argument("--end", type=float, default=main_file.Options.end_time, help="end of the run [ms] (default 100)")
    parser.add_argument("--cycles", type=int, default=0, help="end after so many steps (default 0: no limit)")
    parser.add_argument("--integrated", action="store_true", help="all shells fully integrated, not only where the car folds")
    parser.add_argument("--all-edges", action="store_true", help="contact of all edges, not only of free ones")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, help="folder for the files")
    parser.add_argument("-v", "--verbose", action="store_true", help="masses of parts and trim")
    options = parser.parse_args()
    assembly = Assembly(options.size, options.case)
    chosen = main_file.Options(options.end, options.cycles, options.integrated, options.all_edges)
    options.output.mkdir(parents=True, exist_ok=True)
    for name, lines in assembly.files(chosen):
        (options.output / name).write_text("\n".join(lines) + "\n")
    report(assembly)
    if options.verbose:
        for name, mass in sorted(assembly.part_masses.items(), key=lambda item: -item[1]):
            print(f"{mass:8.2f} + {assembly.trim_by_name.get(name, 0.0):7.2f} kg  {name}")


if __name__ == "__main__":
    main()
