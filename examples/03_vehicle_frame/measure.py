#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the vehicle frame in its variants and prints the table of README.md as Markdown.

    ./measure.py ../../build/release/crumple             all variants, some minutes
    ./measure.py ../../build/release/crumple --quick     the deck as it stands only
"""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
from runs import mean_wall_force, perturbed, print_table, rows_of  # noqa: E402

COLUMNS = ["absorbed [kJ]", "mean force [kN]", "way of the rear end [mm]", "its speed at the end [m/s]",
           "hourglass / internal [%]", "energy error [%]", "mid-surface cuts", "depth: largest / 99 %", "cycles",
           "CPU [s]"]

VARIANTS = [
    ("Belytschko-Tsay (the deck)", [], []),
    ("the same, mixed precision", [], ["--precision", "mixed"]),
    *perturbed(2),
    ("Hughes-Liu (the paper's element)", ["--formulation", "1"], []),
    ("fully integrated", ["--formulation", "16"], []),
    ("Belytschko-Tsay, 7 shells over the height", ["--rows", "7"], []),
    ("Belytschko-Tsay, 10 shells over the height", ["--rows", "10"], []),
]


def cells_of(record, folder):
    energy = record["energy"]
    rear = rows_of(folder / "nodout.csv")[-4]
    contact = record["contact"][0]
    return [f"{(energy['internal'] + energy['hourglass'] + energy['friction']) / 1000:.3f}",
            f"{mean_wall_force(folder) / 1000:.2f}", f"{-1000 * rear['ux']:.2f}", f"{-rear['vx']:.2f}",
            f"{100 * energy['hourglass'] / energy['internal']:.1f}", f"{100 * energy['error']:.1g}",
            f"{contact['intersections']}",
            f"{contact['largest_relative_depth']:.3f} / {contact['percentile_99_relative_depth']:.3f}",
            f"{record['cycles']}", f"{record['cpu_seconds']:.1f}"]


if __name__ == "__main__":
    print_table(__doc__, HERE / "make_vehicle_frame.py", COLUMNS, VARIANTS, cells_of)
