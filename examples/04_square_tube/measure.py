#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the square tube in its variants and prints the table of README.md as Markdown.

    ./measure.py ../../build/release/crumple             all variants, some minutes
    ./measure.py ../../build/release/crumple --quick     the deck as it stands only
"""

import argparse
import csv
import json
import pathlib
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent

HEADER = ("| run | absorbed [J] | mean force [kN] | hourglass / internal [%] | energy error [%] | cycles | "
          "ns per element-cycle |\n" + "|---" * 7 + "|")


def mean_force(folder):
    """Impulse on the wall over the time of the run [kN]."""
    with open(folder / "rwforc.csv", newline="") as file:
        rows = [(float(row["time"]), float(row["normal"])) for row in csv.DictReader(file)]
    impulse = sum(force * (later - time) for (time, force), (later, _) in zip(rows, rows[1:]))
    return impulse / (rows[-1][0] - rows[0][0])


def run(program, deck_options, run_options, folder):
    deck = folder / "deck.k"
    deck.write_text(subprocess.run([HERE / "make_square_tube.py", *deck_options], check=True, text=True,
                                   capture_output=True).stdout)
    subprocess.run([program, "run", deck, "-o", folder / "out", "--quiet", *run_options], check=True,
                   capture_output=True)
    return json.loads((folder / "out" / "run.json").read_text())


def line(name, record, folder):
    energy = record["energy"]
    absorbed = energy["internal"] + energy["hourglass"] + energy["friction"]
    return (f"| {name} | {absorbed:.2f} | {mean_force(folder):.4f} | "
            f"{100 * energy['hourglass'] / energy['internal']:.1f} | {100 * energy['error']:.1g} | "
            f"{record['cycles']} | {record['ns_per_element_cycle']:.0f} |")


def variants(quick):
    yield "Belytschko-Tsay, 5 mm, double (the deck)", [], []
    if quick:
        return
    for seed in range(1, 6):
        yield f"the same, coordinates moved by 1e-9 (seed {seed})", [], ["--perturb", "1e-9", "--seed", str(seed)]
    yield "mixed precision", [], ["--precision", "mixed"]
    for number, name in ((10, "Belytschko-Wong-Chiang"), (1, "Hughes-Liu"), (6, "Hughes-Liu, selectively reduced"),
                         (16, "fully integrated")):
        yield name, ["--formulation", str(number)], []


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    print(HEADER)
    for name, deck_options, run_options in variants(options.quick):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            record = run(options.program, deck_options, run_options, folder)
            print(line(name, record, folder / "out"), flush=True)


if __name__ == "__main__":
    main()
