# SPDX-License-Identifier: BSD-3-Clause
"""The text of docs/paper.md. Every figure comes from the results; what is said in words stays true whatever they are."""

import math
import textwrap

from plan import EXAMPLES, METHODS

AIM = 1.5  # global search of the production method [ns per element-cycle]
BUSY = 1.05
VERY_BUSY = 1.5

HEAD = """
F. Wang, J. Cheng & Z. Yao, *A contact searching algorithm for contact-impact problems*, Acta Mechanica Sinica 16(4), 2000,
in crumple: its three examples, run with its own search, with the conventional ones that it is compared with, and with
ours. `make paper` writes this page; do not edit it (`bench/paper/` holds the program). What is the paper's and what is ours
in each model: [box beam](../examples/01_box_beam/README.md), [two tubes](../examples/02_two_tubes/README.md),
[vehicle frame](../examples/03_vehicle_frame/README.md).
"""

SHAPES = """
## Deformed shapes

At the paper's times; colours are the largest plastic strain over the thickness.

| box beam, 6 ms | box beam, 12 ms |
|---|---|
| ![box beam, 6 ms](pictures/paper_box_beam_06ms.png) | ![box beam, 12 ms](pictures/paper_box_beam_12ms.png) |
| **two tubes, 2 x 300 shells, 6 ms** | **two tubes, 2 x 912 shells, 6 ms** |
| ![coarse tubes](pictures/paper_tubes_coarse_06ms.png) | ![fine tubes](pictures/paper_tubes_fine_06ms.png) |
| **vehicle frame, 18.8 ms** | **its front** |
| ![frame](pictures/paper_frame_19ms.png) | ![front of the frame](pictures/paper_frame_front_19ms.png) |
"""

SHARES = """
Global search over the time of the run, in percent; in brackets global and local search together, as the paper does not say which
of both its figures hold. Times are without writing results, of which runs this short have much. *Double* is the program as it comes, *scalar* has
elements without SIMD, in which the balance of costs is nearest to the paper's: a fast element makes any search's share
look large.
"""

COSTS = """
By method; all have the same cells and the same territory expansion c, that of the decks, and find the same candidates. *Search* is
building and asking the method alone, per segment and search; *all* is the stage "contact search" of a run, so with following
the motion that says when a search is due, candidates sorted by node and their first distances. *Visits* are nodes looked at by
segment and search.
"""

MEMORY = """
Eq. (12) of the paper: M = Ncell + N integers of four bytes, N the nodes that take part. Bytes are those that the method
reports after its last search (`run.json`, `search`), without its result.
"""

DENSITY = """
Eq. (11), T = k N: the same models with finer meshes; c and cells follow the edge (of tubes and frame; c of the box beam is 0.6
edges). The box beam and the frame run for half of their time. *Search* is building and asking the method, per segment and search; *visits* are the nodes that
it looks at, and do not depend on what else the machine does.
"""

PARAMETERS = """
Users of the algorithm choose the territory expansion c and the cells, and the paper says that there is an optimum. A larger c leaves more
motion before the next search is due, and gives each search more candidates; smaller cells are visited in larger
numbers and hold fewer nodes in vain. h is the largest contact distance, which c must exceed.
"""

PARAMETER_PICTURES = """
![Cost over the territory expansion](pictures/paper_expansion.png)

![Cost over the cells' edge](pictures/paper_cell_size.png)

Both at once, global search of the fine tubes in ns per element-cycle:

![Cost over both](pictures/paper_map.png)
"""

FRAME = """
## Displacement of the frame

The rear end of the left rail, in the direction of travel:

![Way and speed of the frame's rear end](pictures/paper_frame_displacement.png)
"""


def paragraph(text):
    """Lines of text as one paragraph of the page."""
    return "\n" + textwrap.fill(" ".join(text.split()), 118, break_long_words=False, break_on_hyphens=False) + "\n"


def table(columns, rows):
    lines = ["| " + " | ".join(columns) + " |", "|---" * len(columns) + "|"]
    return "\n" + "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def machine(results, about):
    text = paragraph(f"One thread of a machine with {about['cores']} processors ({about['processor']}), elements with "
            f"`{about['isa']}`, {about['date']}. Medians of 3 runs (box beam) and 5 (tubes) for the tables of methods; of the"
            " frame, and of finer meshes, one run.")
    busy = results.busy()
    if busy > BUSY:
        text += paragraph(f"**The machine was not quiet:** the runs took {busy:.1f} times as long as the processor worked on them. "
                 f"Counts hold, times {'say nothing' if busy > VERY_BUSY else 'are rough'}.")
    return text


def both_shares(result):
    return f"{result.share(result.global_seconds):.1f} ({result.share(result.global_seconds + result.local_seconds):.1f})"


def shares(results):
    rows = []
    for example in EXAMPLES:
        def cell(kind, method, example=example):
            return both_shares(results.get(kind, example.name, method))

        rows.append([example.title, example.paper_share, cell("method", "linked-cell"), cell("method", "position-code"),
                     cell("method", "production"), cell("scalar", "linked-cell"), cell("scalar", "position-code"),
                     cell("scalar", "production")])
    return "\n## Share of the contact search\n" + paragraph(SHARES) + table(["", "paper", "linked-cell, double", "position-code", "production", "linked-cell, scalar",
                           "position-code", "production"], rows) + paragraph(
        "The paper's conventional O(N log N) method took 13.9 % on its frame, where its own took 7.3 %. `linked-cell` is "
        "the paper's method as printed, `position-code` the conventional one with O(N log N).")


def costs(results):
    text = "\n## Cost of the global search\n" + paragraph(COSTS)
    for example in EXAMPLES:
        runs = {method: results.get("method", example.name, method) for method in METHODS}
        one = runs["linked-cell"]
        text += paragraph(f"**{example.title[0].upper()}{example.title[1:]}:** {one.cycles} cycles, {one.searches} searches, one in "
                 f"{one.cycles / one.searches:.0f} cycles; {one.values['candidates'] / one.searches:.0f} candidates a "
                 f"search; c = {1000 * one.search['expansion']:.2f} mm.")
        rows = [[f"`{method}`", f"{visits(run):.1f}",
                 f"{run.per_segment(run.values['find']):.0f}", f"{run.per_segment(run.global_seconds):.0f}",
                 f"{run.global_cost:.2f}", f"{run.both_cost:.2f}", f"{run.share(run.global_seconds):.1f} %",
                 f"{run.computing:.2f}"] for method, run in runs.items()]
        text += table(["method", "visits", "search [ns/segment]", "all [ns/segment]", "all [ns/element-cycle]",
                       "with local search", "share", "run [s]"], rows)
    equal = all(len({results.get("method", example.name, method).values["state_hash"] for method in METHODS}) == 1
                for example in EXAMPLES)
    return text + ("\nThe results of all methods are the same bit by bit (`state_hash`).\n" if equal
                   else "\n**The results of the methods differ** (`state_hash`): this is a fault.\n")


def aim(results):
    """The production method in double and mixed precision against what was asked of it."""
    rows = []
    for example in EXAMPLES:
        double = results.get("method", example.name, "production")
        mixed = results.get("mixed", example.name, "production")
        cost = min(double.global_cost, mixed.global_cost)
        find = double.per_element_cycle(double.values["find"])
        rows.append([example.title, f"{double.global_cost:.2f}", f"{mixed.global_cost:.2f}", f"{find:.2f}",
                     f"{double.per_element_cycle(double.contact_seconds):.1f}",
                     "yes" if max(double.global_cost, mixed.global_cost) <= AIM else "no" if cost > AIM else "in part"])
    return paragraph(f"**Production** was to cost at most {AIM} ns per element-cycle. Elements do not matter to it, so that double "
            "and mixed precision differ by chance alone.") + (
            table(["", "all, double", "all, mixed", "search alone", "all contact", "reached"], rows))


def memory(results):
    rows = []
    for example in EXAMPLES:
        runs = {method: results.get("method", example.name, method) for method in METHODS}
        search = runs["linked-cell"].search
        equation = 4 * (search["cells"] + search["participants"])
        rows.append([example.title, f"{search['cells']}", f"{search['participants']}", f"{equation}",
                     *(f"{run.search['bytes']} ({run.search['bytes'] / run.search['participants']:.0f})"
                       for run in runs.values())])
    return "\n## Memory\n" + paragraph(MEMORY) + table(["", "Ncell", "N", "4 (Ncell + N)", *(f"{method} (per node)" for method in METHODS)], rows)


def density(results):
    rows = []
    for example in EXAMPLES:
        for _, run in results.of("mesh", example.name, "linked-cell"):
            rows.append((example, run, "linked-cell"))
        for _, run in results.of("mesh", example.name, "production"):
            rows.append((example, run, "production"))
    lines = [[example.name.split(",")[0], f"`{method}`", f"{run.shells}", f"{run.cycles}", f"{run.cycles / run.searches:.0f}",
              f"{visits(run):.1f}", f"{run.per_segment(run.values['find']):.0f}", f"{run.global_cost:.2f}",
              f"{run.share(run.global_seconds):.1f} %", f"{100 * run.values['energy_error']:.1g} %"]
             for example, run, method in rows]
    picture = "\n![Cost and share over the number of shells](pictures/paper_density.png)\n"
    text = table(["", "method", "shells", "cycles", "cycles a search", "visits", "search [ns/segment]",
                  "all [ns/element-cycle]", "share", "energy error"], lines)
    return "\n## Mesh density\n" + paragraph(DENSITY) + picture + text + growth(results)


def visits(run):
    """Nodes looked at by segment and search."""
    return run.search["node_visits"] / run.shells / run.searches


def growth(results):
    """What becomes of the cost from the coarsest to the finest mesh."""
    lines = []
    for example in EXAMPLES:
        for method in ("linked-cell", "production"):
            runs = [run for _, run in results.of("mesh", example.name, method)]
            if len(runs) < 2:
                continue
            first, last = runs[0], runs[-1]
            per_segment = [run.per_segment(run.values["find"]) for run in (first, last)]
            logarithm = math.log(last.nodes) / math.log(first.nodes)
            lines.append(paragraph(
                f"- {example.name.split(',')[0]}, `{method}`: {last.shells / first.shells:.1f} times the shells; visits by "
                f"segment {visits(last) / visits(first):.2f} times, search by segment {per_segment[1] / per_segment[0]:.2f} "
                f"times, all by element-cycle {last.global_cost / first.global_cost:.2f} times, share "
                f"{first.share(first.global_seconds):.1f} % to {last.share(last.global_seconds):.1f} %. O(N log N) would be "
                f"{logarithm:.2f} times by segment.").replace("\n", "\n  ").strip())
    return paragraph("From the coarsest to the finest mesh, where 1.00 is T = k N exactly:") + "\n" + "\n".join(lines) + "\n"


def parameters(results):
    rows = []
    for example in EXAMPLES:
        line = [example.title]
        for method in ("linked-cell", "production"):
            runs = results.of("expansion", example.name, method)
            margin, best = min(((key[0], run) for key, run in runs), key=lambda entry: entry[1].both_cost)
            worst = max(run.both_cost for _, run in runs)
            line += [f"{margin:g}", f"{best.cycles / best.searches:.0f}", f"{best.both_cost:.2f}", f"{worst:.2f}"]
        runs = results.of("cell", example.name, "linked-cell")
        factor, best = min(((key[1], run) for key, run in runs), key=lambda entry: entry[1].values["find"])
        rows.append([*line, f"{factor:g}"])
    text = "\n## The two parameters\n" + paragraph(PARAMETERS) + PARAMETER_PICTURES + paragraph(
        "The best of the values tried (c by global and local search together in ns per element-cycle, cells by building and "
        "asking):")
    return text + table(["", "(c - h) / edge, linked-cell", "cycles a search", "best", "worst", "(c - h) / edge, production",
                         "cycles a search", "best", "worst", "cells' edge / edge"], rows) + paragraph(
        "Intervals are longer than the paper's 10 to 20 steps because a search is made when the relative motion since the last one has used "
        "up c - h, and not when eq. (10), which takes the largest speed for the whole interval, says so.")


def absolute(results):
    box = results.get("method", "box beam", "linked-cell")
    seconds = 35032
    return "\n## Then and now\n" + paragraph(
            f"The paper's box beam took 35 032 s on a Pentium III at 450 MHz. Here it takes {box.values['seconds']:.1f} s with "
            f"the paper's search, results written, {seconds / box.values['seconds']:.0f} times less. 14.8 % of that "
            f"time, {0.148 * seconds:.0f} s, was contact search; now global search takes {box.global_seconds:.2f} s and "
            f"global and local search {box.global_seconds + box.local_seconds:.2f} s. Neither its number of steps nor of searches is known, and "
            "the machines are 25 years apart.")


def checks(results):
    failed = sorted({(key[1], name) for key, value in results.values.items() if key[0] == "method"
                     for name in value["failed_checks"]})
    if not failed:
        return "\nAll checks at the end of these runs pass ([what they are](usage.md#checks)).\n"
    return "\nChecks that fail at the end of runs: " + "; ".join(f"{example}: {name}" for example, name in failed) + ".\n"


def text(results, about):
    parts = ("<!-- SPDX-License-Identifier: BSD-3-Clause -->\n# The paper's examples\n", paragraph(HEAD), machine(results, about), SHAPES, checks(results), shares(results), costs(results), aim(results),
             density(results), parameters(results), FRAME, memory(results), absolute(results))
    return "".join(parts)
