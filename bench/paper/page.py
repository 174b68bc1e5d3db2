# SPDX-License-Identifier: BSD-3-Clause
"""docs/paper.md: page.template, whose words stay true whatever the results are, with every figure from these."""

import math
import string
from pathlib import Path

from plan import EXAMPLES, METHODS

TEMPLATE = Path(__file__).resolve().parent / "page.template"
AIM = 1.5  # global search of the production method [ns per element-cycle]
# Wall time over processor time of all runs.
BUSY = 1.05
VERY_BUSY = 1.5
PAPER_SECONDS = 35032  # of the box beam
PAPER_SHARE = 0.148
BOTH = ("linked-cell", "production")


def table(columns, rows):
    lines = ["| " + " | ".join(columns) + " |", "|---" * len(columns) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def visits(run):
    """Nodes looked at by segment and search."""
    return run.search["node_visits"] / run.shells / run.searches


def find_cost(run):
    """Building and asking, by segment and search [ns]."""
    return run.per_segment(run.values["find"])


def interval(run):
    """Cycles from a search to the next."""
    return run.cycles / run.searches


def global_share(run):
    return run.share(run.global_seconds)


def short_name(example):
    return example.name.split(",")[0]


def machine(results, about):
    text = (f"One thread of a machine with {about['cores']} processors ({about['processor']}), elements with `{about['isa']}`,\n"
            f"{about['date']}. Medians of 3 runs (box beam) and 5 (tubes) in the tables of methods; of the frame and of finer\n"
            "meshes one run.")
    busy = results.busy()
    if busy <= BUSY:
        return text
    return text + (f"\n\n**The machine was not quiet:** the runs took {busy:.1f} times as long as the processor worked on "
                   f"them.\nCounts hold, times {'say nothing' if busy > VERY_BUSY else 'are rough'}.")


def checks(results):
    failed = sorted({(key[1], name) for key, value in results.values.items() if key[0] == "method"
                     for name in value["failed_checks"]})
    if not failed:
        return "All checks at the end of these runs pass ([what they are](usage.md#checks))."
    return "Checks that fail at the end of runs: " + "; ".join(f"{example}: {name}" for example, name in failed) + "."


def shares(results):
    def cell(kind, example, method):
        run = results.get(kind, example.name, method)
        return f"{global_share(run):.1f} ({run.share(run.global_seconds + run.local_seconds):.1f})"

    methods = ("linked-cell", "position-code", "production")
    rows = [[example.title, example.paper_share, *(cell("method", example, method) for method in methods),
             *(cell("scalar", example, method) for method in methods)] for example in EXAMPLES]
    return table(["", "paper", *(f"{method}, double" for method in methods), *(f"{method}, scalar" for method in methods)],
                 rows)


def costs(results):
    parts = []
    for example in EXAMPLES:
        runs = {method: results.get("method", example.name, method) for method in METHODS}
        one = runs["linked-cell"]
        parts.append(f"**{example.title[0].upper()}{example.title[1:]}:** {one.cycles} cycles, {one.searches} searches, one in "
                     f"{interval(one):.0f} cycles; {one.values['candidates'] / one.searches:.0f} candidates a search; "
                     f"c = {1000 * one.search['expansion']:.2f} mm.")
        rows = [[f"`{method}`", f"{visits(run):.1f}", f"{find_cost(run):.0f}", f"{run.per_segment(run.global_seconds):.0f}",
                 f"{run.global_cost:.2f}", f"{run.both_cost:.2f}", f"{global_share(run):.1f} %", f"{run.computing:.2f}"]
                for method, run in runs.items()]
        parts.append(table(["method", "visits", "search [ns/segment]", "all [ns/segment]", "all [ns/element-cycle]",
                            "with local search", "share", "run [s]"], rows))
    return "\n\n".join(parts)


def same_bits(results):
    hashes = [{results.get("method", example.name, method).values["state_hash"] for method in METHODS}
              for example in EXAMPLES]
    if all(len(found) == 1 for found in hashes):
        return "The results of all methods are the same bit by bit (`state_hash`)."
    return "**The results of the methods differ** (`state_hash`): this is a fault."


def reached(results):
    """The production method in double and mixed precision, and with the c that it chooses, against what was asked of it."""
    rows = []
    for example in EXAMPLES:
        double, mixed, own = (results.get(kind, example.name, "production") for kind in ("method", "mixed", "automatic"))
        found = (double.global_cost, mixed.global_cost, own.global_cost)
        verdict = "yes" if max(found) <= AIM else "no" if min(found) > AIM else "in part"
        rows.append([example.title, f"{interval(double):.0f}", f"{double.global_cost:.2f}", f"{mixed.global_cost:.2f}",
                     f"{double.both_cost:.2f}", f"{1000 * own.search['expansion']:.2f}", f"{interval(own):.0f}",
                     f"{own.global_cost:.2f}", f"{own.both_cost:.2f}", verdict])
    return table(["", "cycles a search", "all, double", "all, mixed", "with local search", "own c [mm]", "cycles a search",
                  "all", "with local search", "reached"], rows)


def density(results):
    rows = [[short_name(example), f"`{method}`", f"{run.shells}", f"{run.cycles}", f"{interval(run):.0f}",
             f"{visits(run):.1f}", f"{find_cost(run):.0f}", f"{run.global_cost:.2f}", f"{global_share(run):.1f} %",
             f"{100 * run.values['energy_error']:.1g} %"]
            for example in EXAMPLES for method in BOTH for _, run in results.of("mesh", example.name, method)]
    return table(["", "method", "shells", "cycles", "cycles a search", "visits", "search [ns/segment]",
                  "all [ns/element-cycle]", "share", "energy error"], rows)


def growth(results):
    """What becomes of the cost from the coarsest to the finest mesh."""
    rows = []
    for example in (example for example in EXAMPLES if example.meshes):
        for method in BOTH:
            runs = [run for _, run in results.of("mesh", example.name, method)]
            first, last = runs[0], runs[-1]
            rows.append([short_name(example), f"`{method}`", f"{last.shells / first.shells:.1f}",
                         f"{visits(last) / visits(first):.2f}", f"{find_cost(last) / find_cost(first):.2f}",
                         f"{last.global_cost / first.global_cost:.2f}",
                         f"{global_share(first):.1f} % to {global_share(last):.1f} %",
                         f"{math.log(last.nodes) / math.log(first.nodes):.2f}"])
    return table(["", "method", "shells, times", "visits", "search by segment", "all by element-cycle", "share",
                  "O(N log N)"], rows)


def parameters(results):
    rows = []
    for example in EXAMPLES:
        line = [example.title]
        for method in BOTH:
            runs = results.of("expansion", example.name, method)
            margin, best = min(((key[0], run) for key, run in runs), key=lambda entry: entry[1].both_cost)
            worst = max(run.both_cost for _, run in runs)
            line += [f"{margin:g}", f"{interval(best):.0f}", f"{best.both_cost:.2f}", f"{worst:.2f}"]
        cells = results.of("cell", example.name, "linked-cell")
        factor = min(cells, key=lambda entry: entry[1].values["find"])[0][1]
        rows.append([*line, f"{factor:g}"])
    of_method = ("cycles a search", "best", "worst")
    return table(["", "(c - h) / edge, linked-cell", *of_method, "(c - h) / edge, production", *of_method,
                  "cells' edge / edge"], rows)


def memory(results):
    rows = []
    for example in EXAMPLES:
        searches = {method: results.get("method", example.name, method).search for method in METHODS}
        own = searches["linked-cell"]
        rows.append([example.title, f"{own['cells']}", f"{own['participants']}", f"{4 * (own['cells'] + own['participants'])}",
                     *(f"{search['bytes']} ({search['bytes'] / search['participants']:.0f})" for search in searches.values())])
    return table(["", "Ncell", "N", "4 (Ncell + N)", *METHODS], rows)


def text(results, about):
    """The page."""
    box = results.get("method", "box beam", "linked-cell")
    seconds = box.values["seconds"]
    return string.Template(TEMPLATE.read_text()).substitute(
        machine=machine(results, about), checks=checks(results), shares=shares(results), costs=costs(results),
        same_bits=same_bits(results), aim=f"{AIM:g}", reached=reached(results), density=density(results),
        growth=growth(results), parameters=parameters(results), memory=memory(results),
        then_seconds=f"{PAPER_SECONDS}", then_search=f"{PAPER_SHARE * PAPER_SECONDS:.0f}", now_seconds=f"{seconds:.1f}",
        faster=f"{PAPER_SECONDS / seconds:.0f}", now_global=f"{box.global_seconds:.2f}",
        now_both=f"{box.global_seconds + box.local_seconds:.2f}")
