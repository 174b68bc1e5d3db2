#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the box beam in its variants and prints the tables of README.md as Markdown.

    ./measure.py ../../build/release/crumple             all variants, some minutes
    ./measure.py ../../build/release/crumple --quick     the deck as it stands only
"""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
from runs import perturbed, print_table, rows_of  # noqa: E402

QUARTERS = 4

COLUMNS = ["absorbed [kJ]", "mean force [kN]", "peak force [kN]", "stroke [mm]", "hourglass / internal [%]",
           "energy error [%]", "mid-surface cuts", "depth: largest / 99 %", "cycles", "CPU [s]"]

VARIANTS = [
    ("Belytschko-Tsay, 5 mm (the deck)", [], ["-t", "1"]),
    ("the same, mixed precision", [], ["-t", "1", "--precision", "mixed"]),
    ("Hughes-Liu, 5 mm (the paper's element)", ["--formulation", "1"], ["-t", "1"]),
    ("Belytschko-Tsay, 2.5 mm", ["--element-size", "0.0025"], ["-t", "1"]),
    ("Hughes-Liu, 2.5 mm", ["--element-size", "0.0025", "--formulation", "1"], ["-t", "1"]),
    *perturbed(5),
]


def peak_force(folder):
    """Largest normal force on the wall [N], of the whole beam."""
    return QUARTERS * max(row["normal"] for row in rows_of(folder / "rwforc.csv"))


def absorbed_per_stroke(record, folder):
    """Mean crush force from the absorbed energy over the way of the rear end [N], and that way [m]."""
    rows = rows_of(folder / "nodout.csv")
    stroke = rows[-1]["ux"]
    energy = record["energy"]
    return QUARTERS * (energy["internal"] + energy["hourglass"] + energy["friction"]) / stroke, stroke


def cells_of(record, folder):
    energy = record["energy"]
    absorbed = QUARTERS * (energy["internal"] + energy["hourglass"]) / 1000
    mean, stroke = absorbed_per_stroke(record, folder)
    contact = record["contact"][0]
    return [f"{absorbed:.4f}", f"{mean / 1000:.2f}", f"{peak_force(folder) / 1000:.0f}", f"{1000 * stroke:.0f}",
            f"{100 * energy['hourglass'] / energy['internal']:.1f}", f"{100 * energy['error']:.1g}",
            f"{contact['intersections']}",
            f"{contact['largest_relative_depth']:.3f} / {contact['percentile_99_relative_depth']:.3f}",
            f"{record['cycles']}", f"{record['cpu_seconds']:.1f}"]


if __name__ == "__main__":
    print_table(__doc__, HERE / "make_box_beam.py", COLUMNS, VARIANTS, cells_of)
