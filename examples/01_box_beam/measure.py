#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the box beam in its variants and prints the tables of README.md as Markdown.

    ./measure.py ../../build/release/crumple             all variants, some minutes
    ./measure.py ../../build/release/crumple --quick     the deck as it stands only
"""

import argparse
import csv
import json
import pathlib
import resource
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
QUARTERS = 4


def rows_of(path):
    with open(path, newline="") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def crush_forces(folder):
    """Mean of the wall's normal force over the run and its largest value [N], of the whole beam."""
    rows = rows_of(folder / "rwforc.csv")
    impulse = sum(b["normal"] * (b["time"] - a["time"]) for a, b in zip(rows, rows[1:]))
    duration = rows[-1]["time"] - rows[0]["time"]
    return QUARTERS * impulse / duration, QUARTERS * max(row["normal"] for row in rows)


def absorbed_per_stroke(record, folder):
    """Mean crush force from the absorbed energy over the way of the rear end [N], and that way [m]."""
    rows = rows_of(folder / "nodout.csv")
    stroke = rows[-1]["ux"]
    energy = record["energy"]
    return QUARTERS * (energy["internal"] + energy["hourglass"] + energy["friction"]) / stroke, stroke


def run(program, deck_options, run_options, folder):
    deck = folder / "deck.k"
    deck.write_text(subprocess.run([HERE / "make_box_beam.py", *deck_options], check=True, text=True,
                                   capture_output=True).stdout)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "run", deck, "-o", folder / "out", "--quiet", *run_options], check=True,
                   capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    record = json.loads((folder / "out" / "run.json").read_text())
    record["cpu_seconds"] = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return record


def line(name, record, folder):
    energy = record["energy"]
    absorbed = QUARTERS * (energy["internal"] + energy["hourglass"]) / 1000
    mean, stroke = absorbed_per_stroke(record, folder)
    _, peak = crush_forces(folder)
    contact = record["contact"][0]
    return (f"| {name} | {absorbed:.4f} | {mean / 1000:.2f} | {peak / 1000:.0f} | {1000 * stroke:.0f} | "
            f"{100 * energy['hourglass'] / energy['internal']:.1f} | {100 * energy['error']:.1g} | "
            f"{contact['intersections']} | {contact['largest_relative_depth']:.3f} / "
            f"{contact['percentile_99_relative_depth']:.3f} | {record['cycles']} | {record['cpu_seconds']:.1f} |")


HEADER = ("| run | absorbed [kJ] | mean force [kN] | peak force [kN] | stroke [mm] | hourglass / internal [%] | "
          "energy error [%] | mid-surface cuts | depth: largest / 99 % | cycles | CPU [s] |\n" + "|---" * 11 + "|")


def variants(quick):
    yield "Belytschko-Tsay, 5 mm (the deck)", [], ["-t", "1"]
    if quick:
        return
    yield "the same, mixed precision", [], ["-t", "1", "--precision", "mixed"]
    yield "Hughes-Liu, 5 mm (the paper's element)", ["--formulation", "1"], ["-t", "1"]
    yield "Belytschko-Tsay, 2.5 mm", ["--element-size", "0.0025"], ["-t", "1"]
    yield "Hughes-Liu, 2.5 mm", ["--element-size", "0.0025", "--formulation", "1"], ["-t", "1"]
    for seed in range(1, 6):
        yield f"the deck, coordinates moved by 1e-9 (seed {seed})", [], ["--perturb", "1e-9", "--seed", str(seed)]


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
