#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the square tube in its variants and prints the table of README.md as Markdown.

    ./measure.py ../../build/release/crumple             all variants, some minutes
    ./measure.py ../../build/release/crumple --quick     the deck as it stands only
"""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
from runs import mean_wall_force, perturbed, print_table  # noqa: E402

COLUMNS = ["absorbed [J]", "mean force [kN]", "hourglass / internal [%]", "energy error [%]", "cycles",
           "ns per element-cycle"]

VARIANTS = [
    ("Belytschko-Tsay, 5 mm, double (the deck)", [], []),
    *perturbed(5),
    ("mixed precision", [], ["--precision", "mixed"]),
    ("Belytschko-Wong-Chiang", ["--formulation", "10"], []),
    ("Hughes-Liu", ["--formulation", "1"], []),
    ("Hughes-Liu, selectively reduced", ["--formulation", "6"], []),
    ("fully integrated", ["--formulation", "16"], []),
]


def cells_of(record, folder):
    energy = record["energy"]
    absorbed = energy["internal"] + energy["hourglass"] + energy["friction"]
    return [f"{absorbed:.2f}", f"{mean_wall_force(folder):.4f}",
            f"{100 * energy['hourglass'] / energy['internal']:.1f}", f"{100 * energy['error']:.1g}",
            f"{record['cycles']}", f"{record['ns_per_element_cycle']:.0f}"]


if __name__ == "__main__":
    print_table(__doc__, HERE / "make_square_tube.py", COLUMNS, VARIANTS, cells_of)
