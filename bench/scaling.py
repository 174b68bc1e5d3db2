#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Scaling on paper: time of a cycle over elements and ranks, from what bench/record.py has stored of one machine and
from assumptions on the network, which are arguments. A rank is one thread; there are none yet.

    bench/scaling.py bench/results/MACHINE.csv [--precision double]
"""

import argparse
import csv
import math
from pathlib import Path

ELEMENTS = (10_000, 100_000, 1_000_000, 10_000_000, 100_000_000)
RANKS = (1, 16, 128, 1024)
CYCLES = 100_000  # of a crash of 0.1 s with steps of 1 us
# A node's sum of force and moment in double, with padding.
BYTES_PER_NODE = 64


def latest(path, precision):
    """The last row of each case with one thread."""
    with open(path, newline="") as stream:
        return {row["case"]: row for row in csv.DictReader(stream)
                if row["precision"] == precision and row["threads"] == "1"}


class Constants:
    """Nanoseconds per element-cycle of one thread."""

    def __init__(self, rows):
        def of(case, *stages):
            return sum(float(rows[case][stage]) for stage in stages)
        self.in_cache = of("box beam 5 mm", "elements", "integrate")
        self.in_memory = of("tubes 100k", "elements", "integrate")
        self.search = of("tubes 100k", "contact_search")
        self.contact = of("box beam 5 mm", "contact_local", "contact_forces")

    def cycle(self, elements, cached):
        """Of so many elements, all of them as much in contact as a folding tube [s]. Between what fits into the cache
        and twice that the cost of an element rises in proportion."""
        outside = min(1.0, max(0.0, elements / cached - 1))
        element = self.in_cache + outside * (self.in_memory - self.in_cache)
        return 1e-9 * elements * (element + self.search + self.contact)


def exchange(elements, ranks, arguments):
    """Forces of shared nodes, ghosts of contact, and the smallest step [s]. A rank has a patch of shells as square as
    can be: 4 sqrt(n) nodes along its rim, as many again for contact."""
    if ranks == 1:
        return 0.0
    shared = 2 * 4 * math.sqrt(elements)
    return (2 * arguments.neighbours * arguments.latency + shared * BYTES_PER_NODE / arguments.bandwidth
            + math.ceil(math.log2(ranks)) * arguments.latency)


def hours(seconds):
    return f"{seconds / 3600:.3g} h" if seconds >= 360 else f"{seconds / 60:.2g} min"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path)
    parser.add_argument("--precision", choices=("mixed", "double"), default="mixed")
    parser.add_argument("--cached", type=float, default=20_000, help="elements that fit into a core's cache [20000]")
    parser.add_argument("--latency", type=float, default=2e-6, help="of a message [2e-6 s]")
    parser.add_argument("--bandwidth", type=float, default=1e10, help="of a rank's messages [1e10 bytes/s]")
    parser.add_argument("--neighbours", type=int, default=8, help="of a rank [8]")
    arguments = parser.parse_args()
    constants = Constants(latest(arguments.results, arguments.precision))
    print(f"ns per element-cycle: {constants.in_cache:.1f} in the cache, {constants.in_memory:.1f} in memory, "
          f"search {constants.search:.1f}, contact {constants.contact:.1f}\n")
    print(f"Time of {CYCLES} cycles, in brackets the share of the exchange.\n")
    print("| elements | " + " | ".join(f"{ranks} rank{'s' if ranks > 1 else ''}" for ranks in RANKS) + " |")
    print("|---" * (len(RANKS) + 1) + "|")
    for elements in ELEMENTS:
        cells = []
        for ranks in RANKS:
            own = elements / ranks
            work = constants.cycle(own, arguments.cached)
            talk = exchange(own, ranks, arguments)
            cells.append(f"{hours(CYCLES * (work + talk))} ({100 * talk / (work + talk):.2g} %)")
        print(f"| {elements:.0e} | ".replace("e+0", "e") + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
