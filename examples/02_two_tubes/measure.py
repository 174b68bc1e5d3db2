#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the two tubes in their variants and prints the table of README.md as Markdown.

    ./measure.py ../../build/release/crumple             all variants, a minute
    ./measure.py ../../build/release/crumple --quick     the coarse deck as it stands only
"""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
from runs import perturbed, print_table, rows_of  # noqa: E402

COLUMNS = ["absorbed [kJ]", "speed apart [m/s]", "difference of the tubes' energies [%]", "momentum along x",
           "hourglass / internal [%]", "energy error [%]", "mid-surface cuts", "cycles", "CPU [s]"]

FINE = ["--around", "38", "--along", "24"]
VARIANTS = [
    ("coarse: 20 x 15 shells", [], []),
    *perturbed(2),
    ("the same, Hughes-Liu (the paper's element)", ["--formulation", "1"], []),
    ("fine: 38 x 24 shells", FINE, []),
    ("the same, mixed precision", FINE, ["--precision", "mixed"]),
    ("the same, Hughes-Liu", [*FINE, "--formulation", "1"], []),
    ("76 x 48 shells", ["--around", "76", "--along", "48"], []),
]


def cells_of(record, folder):
    energy = record["energy"]
    rows = rows_of(folder / "matsum.csv")
    first, second = rows[-2:]
    start = rows[0]["mass"] * rows[0]["vx"]
    momentum = (first["mass"] * first["vx"] + second["mass"] * second["vx"]) / start
    unlike = abs(first["internal"] - second["internal"]) / first["internal"]
    return [f"{(energy['internal'] + energy['hourglass'] + energy['friction']) / 1000:.4f}",
            f"{second['vx'] - first['vx']:.3f}", f"{100 * unlike:.1g}", f"{abs(momentum):.1g}",
            f"{100 * energy['hourglass'] / energy['internal']:.1f}", f"{100 * energy['error']:.1g}",
            f"{record['contact'][0]['intersections']}", f"{record['cycles']}", f"{record['cpu_seconds']:.1f}"]


if __name__ == "__main__":
    print_table(__doc__, HERE / "make_two_tubes.py", COLUMNS, VARIANTS, cells_of)
