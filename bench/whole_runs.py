#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whole runs of the program, timed: the box beam of the paper at 5, 2.5 and 1.25 mm, 25 and 256 tubes of 4000 shells
that fold with self-contact, a sheet of a million shells, 16 tubes filled with foam under a rigid press, a block of
solids, a small car in three sizes. Prints one line per run: time per element and cycle, in all and by stage, from run.json.

    bench/whole_runs.py build/release/crumple                        the quick ones, minutes
    bench/whole_runs.py build/release/crumple --all -t 2             every one, long
    bench/whole_runs.py build/release/crumple --only "tubes 100k" --cycles 2000
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "examples" / "support"))
from runs import run, write_deck  # noqa: E402

BOX_BEAM = HERE.parent / "examples" / "01_box_beam" / "make_box_beam.py"
CAR = HERE.parent / "examples" / "05_car" / "make_car.py"  # writes a folder, car.k in it
STAGES = ("elements", "contact_search", "contact_local", "contact_forces", "constraints", "integrate", "output")

# Name: (generator and its arguments, takes --cycles, part of the quick set).
RUNS = {
    "box beam 5 mm": ([BOX_BEAM], False, True),
    "box beam 2.5 mm": ([BOX_BEAM, "--element-size", "0.0025"], False, False),
    "box beam 1.25 mm": ([BOX_BEAM, "--element-size", "0.00125"], False, False),
    "tubes 100k": ([HERE / "make_decks.py", "tubes"], True, True),
    "tubes 1M": ([HERE / "make_decks.py", "tubes", "--rows", "16"], True, False),
    "sheet 1M": ([HERE / "make_decks.py", "sheet"], True, True),
    "filled 137k": ([HERE / "make_decks.py", "filled"], True, True),
    "block 8k": ([HERE / "make_decks.py", "block"], True, True),
    "car 20k": ([CAR, "--size", "20k"], True, True),
    "car 100k": ([CAR, "--size", "100k"], True, False),
    "car 400k": ([CAR, "--size", "400k"], True, False),
}


def write_car(folder, options):
    """The deck of the car in a folder."""
    subprocess.run([sys.executable, str(CAR), *map(str, options), "-o", str(folder)], check=True, stdout=subprocess.DEVNULL)
    return folder / "car.k"


def elements(record):
    return sum(record["elements"].values())


def nanoseconds(record):
    """ns per element and cycle: of the whole loop, and by stage."""
    scale = 1e9 / (elements(record) * record["cycles"])
    return scale * record["loop_seconds"], {stage: scale * record["timings"][stage] for stage in STAGES}


def add_options(parser):
    """What chooses the runs of results()."""
    parser.add_argument("program", help="the crumple program")
    parser.add_argument("--all", action="store_true", help="the long runs, too")
    parser.add_argument("--only", help="runs whose name holds this")
    parser.add_argument("--cycles", type=int, default=200, help="of tubes, sheet, blocks and cars (default 200; 0 is all)")
    parser.add_argument("--precision", choices=("mixed", "double"), help="(default both)")
    parser.add_argument("-t", "--threads", default="1")


def results(arguments):
    """Runs one after the other; (name, what is in run.json) as soon as each is done."""
    with tempfile.TemporaryDirectory() as folder:
        for name, (generator, limited, quick) in RUNS.items():
            if arguments.only is not None and arguments.only not in name:
                continue
            if arguments.only is None and not (quick or arguments.all):
                continue
            deck = Path(folder) / (name.replace(" ", "_") + ".k")
            limit = ["--cycles", arguments.cycles] if limited and arguments.cycles else []
            if generator[0] == CAR:
                deck = write_car(deck.with_suffix(""), [*generator[1:], *limit])
            else:
                write_deck(deck, generator[0], [*generator[1:], *limit])
            for precision in [arguments.precision] if arguments.precision else ["mixed", "double"]:
                options = ["-t", arguments.threads, "--precision", precision]
                yield name, run(arguments.program, deck, deck.with_suffix(".out"), options, wait_policy=None)


def print_head():
    print("ns per element-cycle\n" + f"{'run':17} {'':6} {'':8} {'t':>2} {'elements':>8} {'cycles':>8} {'all':>7}"
          + "".join(f" {stage.replace('contact_', '')[:7]:>7}" for stage in STAGES) + "  error")


def print_line(name, record):
    whole, stages = nanoseconds(record)
    print(f"{name:17} {record['precision']:6} {record['isa']:8} {record['threads']:2} {elements(record):8}"
          f" {record['cycles']:8} {whole:7.1f}" + "".join(f" {time:7.1f}" for time in stages.values())
          + f" {100 * record['energy']['error']:6.2f}%  {record['termination']}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_options(parser)
    print_head()
    for name, record in results(parser.parse_args()):
        print_line(name, record)


if __name__ == "__main__":
    main()
