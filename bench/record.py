#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures, prints and appends what was measured to bench/results/<machine>.csv, with the commit and the machine.
On a quiet machine, with the program built from the commit that is checked out.

    bench/record.py runs build/release/crumple -t 1            whole runs; options as bench/whole_runs.py
    bench/record.py cycle build/bench/bench_shell_cycle mixed avx512 "1t "   a program that prints a table of cycles
"""

import argparse
import csv
import datetime
import os
import re
import subprocess
import sys
from pathlib import Path

import whole_runs

ROOT = Path(__file__).resolve().parent.parent
RESULTS = ROOT / "bench" / "results"
sys.path.insert(0, str(ROOT / "tools"))
from built_by import compiler_of  # noqa: E402

COLUMNS = ("date", "commit", "dirty", "processor", "processors", "caches", "memory_gib", "load", "compiler", "program",
           "case", "precision", "isa", "threads", "element_count", "cycles",
           "wall", "cpu", *whole_runs.STAGES,
           "energy_error", "state_hash")


def git(*words):
    return subprocess.run(["git", *words], cwd=ROOT, check=True, text=True, stdout=subprocess.PIPE).stdout.strip()


def caches():
    """As 'L1 Data 32K, L2 Unified 1024K, ...' of the first processor."""
    folders = sorted(Path("/sys/devices/system/cpu/cpu0/cache").glob("index*"))
    read = [[(folder / name).read_text().strip() for name in ("level", "type", "size")] for folder in folders]
    return ", ".join(f"L{level} {kind} {size}" for level, kind, size in read if kind != "Instruction")


def machine():
    """The columns that are the same for all rows of one call."""
    processors = Path("/proc/cpuinfo").read_text()
    # A virtual machine often hides which processor of a maker's it is; family and model tell.
    names = [re.search(rf"^{field}\s*:\s*(.*)$", processors, re.M) for field in ("model name", "cpu family", "model")]
    model, family, number = (name.group(1).strip() if name else "unknown" for name in names)
    memory = re.search(r"^MemTotal:\s*(\d+) kB", Path("/proc/meminfo").read_text(), re.M)
    others = [line for line in git("status", "--porcelain").splitlines() if "bench/results/" not in line]
    return {
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%MZ"),
        "commit": git("rev-parse", "--short=12", "HEAD"),
        "dirty": "yes" if others else "no",
        "processor": f"{model}, family {family} model {number}",
        "processors": len(os.sched_getaffinity(0)),
        "caches": caches(),
        "memory_gib": round(int(memory.group(1)) / 2**20) if memory else "",
        "load": f"{os.getloadavg()[0]:.2f}",
    }


def file_name(facts):
    """A name from the processor and its number, as amd_epyc_9b14_family_25_model_17_2."""
    words = re.sub(r"\((R|TM)\)|\bCPU\b|\bProcessor\b|@ *[0-9.]+ *GHz", " ", facts["processor"])
    return re.sub(r"[^a-z0-9]+", "_", f"{words} {facts['processors']}".lower()).strip("_")


def of_runs(arguments):
    """Rows of whole runs, printed as whole_runs.py prints them."""
    whole_runs.print_head()
    for name, record in whole_runs.results(arguments):
        whole_runs.print_line(name, record)
        whole, stages = whole_runs.nanoseconds(record)
        times = {"wall": whole, **stages}
        yield {"case": name, "element_count": whole_runs.elements(record), "cycles": record["cycles"],
               "energy_error": f"{record['energy']['error']:.2g}",
               **{key: record[key] for key in ("precision", "isa", "threads", "state_hash")},
               **{stage: f"{time:.2f}" for stage, time in times.items()}}


def of_table(text):
    """Rows of what a program of bench/ printed: a name of words, then four columns of ns per element-cycle."""
    for line in text.splitlines():
        found = re.match(r"(\S.*\S)" + 4 * r"\s+(\d+\.\d+)" + "$", line)
        if not found:
            continue
        name, (wall, cpu, elements, nodes) = found.group(1), found.groups()[1:]
        words = name.split()
        row = {"case": name, "wall": wall, "cpu": cpu, "elements": elements, "integrate": nodes}
        for column, known in (("precision", ("mixed", "double")), ("isa", ("scalar", "baseline", "avx2", "avx512"))):
            row[column] = next((word for word in words if word in known), "")
        row["threads"] = next((word[:-1] for word in words if re.fullmatch(r"\d+t", word)), "")
        yield row


def of_cycles(arguments):
    """Rows of a program of bench/; what it prints is printed."""
    done = subprocess.run([arguments.program, *arguments.words], check=True, text=True, stdout=subprocess.PIPE)
    print(done.stdout, end="")
    yield from of_table(done.stdout)


def append(path, rows):
    """Each row is in the file as soon as it is measured; the number of rows."""
    path.parent.mkdir(parents=True, exist_ok=True)
    written = 0
    for row in rows:
        with path.open("a", newline="") as stream:
            writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n")
            if stream.tell() == 0:
                writer.writeheader()
            writer.writerow(row)
        written += 1
    return written


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--machine", help="name of the file instead of one made from the processor's")
    kinds = parser.add_subparsers(required=True)
    runs = kinds.add_parser("runs", help="whole runs")
    whole_runs.add_options(runs)
    runs.set_defaults(measure=of_runs)
    cycle = kinds.add_parser("cycle", help="a program of bench/")
    cycle.add_argument("program", help="bench_shell_cycle or bench_solid_cycle")
    cycle.add_argument("words", nargs="*", help="only rows whose names hold these")
    cycle.set_defaults(measure=of_cycles)
    arguments = parser.parse_args()
    facts = machine()
    if float(facts["load"]) > 0.5:
        print(f"bench/record.py: the machine is busy (load {facts['load']}); times will be too long", file=sys.stderr)
    facts["compiler"] = compiler_of(arguments.program)
    facts["program"] = Path(arguments.program).name
    path = RESULTS / f"{arguments.machine or file_name(facts)}.csv"
    rows = append(path, ({**facts, **row} for row in arguments.measure(arguments)))
    print(f"{rows} rows appended to {path.relative_to(ROOT)}")
    return 0 if rows else 1


if __name__ == "__main__":
    sys.exit(main())
