# SPDX-License-Identifier: BSD-3-Clause
"""Runs the examples of F. Wang, J. Cheng & Z. Yao (2000) with every search method, and writes
docs/paper.md with its pictures. One thread, held to one processor; the machine should be quiet.

    make paper                                                  builds, then the next line
    python3 bench/paper build/release/crumple                   everything, about ten minutes
    python3 bench/paper build/release/crumple --only "method / tubes"    prints these runs, writes no page
    python3 bench/paper build/release/crumple --page-only       the page again from the last results
"""

import argparse
import importlib.util
import json
import os
import platform
import sys
import time
from pathlib import Path

import page
import pictures
from plan import EXAMPLES, EXAMPLES_FOLDER, all_jobs, with_settings
from results import Result, Results, kept, median_of

sys.path.insert(0, str(EXAMPLES_FOLDER / "support"))
from runs import run, write_deck  # noqa: E402

ROOT = EXAMPLES_FOLDER.parent


def processor_name():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def about(program_record):
    return {"processor": processor_name(), "cores": os.cpu_count(), "date": time.strftime("%Y-%m-%d"),
            "isa": program_record["isa"], "threads": 1}


def do(job, program, core, work):
    """The median result of a job."""
    deck = work / "deck.k"
    write_deck(deck, job.example.generator, job.deck_options)
    deck.write_text(with_settings(deck.read_text(), job.cell, job.expansion, job.automatic))
    options = ["-t", "1", *job.run_options]
    return median_of([kept(run(program, deck, work / "out", options, core)) for _ in range(job.repeats)])


def clock(seconds):
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


def do_all(jobs, program, work):
    """Results of the jobs; says how far it is."""
    core = max(os.sched_getaffinity(0))
    results = Results()
    start = time.monotonic()
    expected = sum(job.repeats * job.seconds for job in jobs)
    done = 0.0
    for number, job in enumerate(jobs, 1):
        values = do(job, program, core, work)
        results.values[job.key] = values
        done += job.repeats * job.seconds
        elapsed = time.monotonic() - start
        result = Result(values)
        print(f"[{number:3}/{len(jobs)}] {job.name:52} {values['loop']:7.2f} s, search {result.global_cost:6.2f} ns "
              f"per element-cycle, {result.share(result.global_seconds):4.1f} %; "
              f"to go {clock(elapsed * (expected / done - 1))}", flush=True)
    return results


def main():
    parser = argparse.ArgumentParser(prog="bench/paper", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, help="the crumple program")
    parser.add_argument("--only", help="runs whose name holds this; writes no page")
    parser.add_argument("--page-only", action="store_true", help="no runs: the page from the results of the last ones")
    parser.add_argument("--work", type=Path, default=ROOT / "out" / "paper", help="folder of the runs [out/paper]")
    arguments = parser.parse_args()
    if not arguments.only and importlib.util.find_spec("matplotlib") is None:
        sys.exit(f"bench/paper: {sys.executable} has no matplotlib for the pictures; on Debian install python3-matplotlib "
                 "and call /usr/bin/python3 bench/paper")
    arguments.work.mkdir(parents=True, exist_ok=True)
    stored = arguments.work / "results.json"
    if arguments.only:
        do_all([job for job in all_jobs() if arguments.only in job.name], arguments.program, arguments.work)
        return
    if not arguments.page_only:
        results = do_all(all_jobs(), arguments.program, arguments.work)
        results.write(stored, about(next(iter(results.values.values()))))
        for example in EXAMPLES:
            pictures.run_for_shapes(example, arguments.program, arguments.work)
    results = Results.read(stored)
    folder = ROOT / "docs" / "pictures"
    pictures.draw_shapes(arguments.work, folder)
    pictures.draw_curves(results, arguments.work, folder)
    (ROOT / "docs" / "paper.md").write_text(page.text(results, json.loads(stored.read_text())["about"]))
    print("Written: docs/paper.md, docs/pictures/paper_*.png")


main()
