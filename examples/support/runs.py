# SPDX-License-Identifier: BSD-3-Clause
"""Decks written by their generators, run by the program, and what the run left."""

import argparse
import csv
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time


def write_deck(path, generator, options=()):
    """Writes what a generator (a Python script) prints with these options."""
    with open(path, "w") as deck:
        subprocess.run([sys.executable, str(generator), *map(str, options)], stdout=deck, check=True)


def run(program, deck, folder, options=(), core=None, wait_policy="passive"):
    """run.json of a run, with `cpu_seconds` and `seconds` of the whole program added. `core` is the processor that it
    is held to. Threads that wait leave the processor to others, unless times of several are measured: then
    `wait_policy` is None, what users have. Throws CalledProcessError, and shows what the program said, unless it ends
    normally."""
    pinned = [] if core is None else ["taskset", "-c", str(core)]
    environment = os.environ | ({"OMP_WAIT_POLICY": wait_policy} if wait_policy else {})
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    done = subprocess.run([*pinned, str(program), "run", str(deck), "-o", str(folder), "--quiet", *options],
                          capture_output=True, text=True, env=environment)
    seconds = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        print(done.stderr, file=sys.stderr)
        done.check_returncode()
    record = json.loads((folder / "run.json").read_text())
    record["seconds"] = seconds
    record["cpu_seconds"] = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return record


def rows_of(path):
    """Rows of a history, numbers by the names of their columns."""
    with open(path, newline="") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def mean_wall_force(folder):
    """Impulse of the normal force on the walls over the time of the run."""
    rows = rows_of(folder / "rwforc.csv")
    impulse = sum(b["normal"] * (b["time"] - a["time"]) for a, b in zip(rows, rows[1:]))
    return impulse / (rows[-1]["time"] - rows[0]["time"])


def print_table(description, generator, columns, variants, cells_of):
    """The main function of a measure.py: runs variants (name, options of the generator, options of the run) one after
    another, prints a Markdown table. `cells_of` makes a row's cells of a record and its folder. --quick: the first one."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the crumple program")
    parser.add_argument("--quick", action="store_true", help="the first row only")
    options = parser.parse_args()
    print("| " + " | ".join(["run", *columns]) + " |\n" + "|---" * (len(columns) + 1) + "|")
    for name, deck_options, run_options in variants[:1] if options.quick else variants:
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            write_deck(folder / "deck.k", generator, deck_options)
            record = run(options.program, folder / "deck.k", folder / "out", run_options)
            print("| " + " | ".join([name, *cells_of(record, folder / "out")]) + " |", flush=True)


def perturbed(count):
    """Variants whose coordinates are moved at random by 1e-9 of the model's size."""
    return [(f"the same, coordinates moved by 1e-9 (seed {seed})", [], ["--perturb", "1e-9", "--seed", str(seed)])
            for seed in range(1, count + 1)]
