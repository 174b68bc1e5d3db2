#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes docs/validation.md: models of others with the results of other codes, what crumple finds now, how far that is
off, and how far its own runs scatter.

    make validation DECKS=folder                      the same as the next line, after a build
    bench/validation.py --program build/release/crumple --decks folder
    bench/validation.py ... --only square_tube_crush --runs 0    one model, without its scatter

The decks are not part of crumple: `folder` holds double_chamber/main.k and square_tube_crush/generate.py, a script that
writes the deck for an edge length. `--runs 4` is what the page was made with. Takes about half an hour on two processors.
"""
import argparse
import csv
import json
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from folding_study import ABSORBED, VARIANTS, rows_of

PAGE = Path(__file__).resolve().parent.parent / "docs" / "validation.md"
HEAD = """<!-- SPDX-License-Identifier: BSD-3-Clause -->
<!-- Written by bench/validation.py: do not edit. -->
# Validation

Models that were made and run by others, in other codes. The decks are run as they are, and with other choices. What a
deck leaves open about shells is thickness change and the hourglass stiffness of the material, as in Abaqus/Explicit and
OpenRadioss; LS-DYNA's defaults are constant thickness and viscous control
([hourglass control](theory/hourglass.md#which-form-to-take)). A percentage is the deviation from the reference. "3b5ed1e" is
crumple before contact, hourglass control and stable steps were reworked. "Scatter" is the range of {runs} runs whose nodes
differ by 1e-6 of the model's size. Mixed precision; `make validation DECKS=folder` writes this page.
"""


@dataclass
class Run:
    """Histories of one run, in the units of its deck."""
    energies: list
    walls: list
    steps: list
    cuts: float

    def at(self, time):
        return min(self.energies, key=lambda row: abs(row["time"] - time))

    def absorbed(self, time):
        return sum(self.at(time)[part] for part in ABSORBED)

    def peak(self):
        return max(abs(row["normal"]) for row in self.walls)

    def mean_force(self):
        pairs = zip(self.walls, self.walls[1:])
        return sum(0.5 * (a["normal"] + b["normal"]) * (b["time"] - a["time"]) for a, b in pairs) / self.walls[-1]["time"]

    def smallest_step(self):
        return min(row["dt"] for row in self.steps) / self.steps[0]["dt"]

    def lowest_contact(self):
        largest = max(row["internal"] for row in self.energies)
        return min(row["contact"] for row in self.energies) / largest


@dataclass
class Quantity:
    name: str
    reference: float
    before: str  # at 3b5ed1e
    of: object   # of a Run
    digits: int = 0


@dataclass
class Model:
    name: str
    deck: str
    edge: str
    text: str
    variants: list
    quantities: list


def crush_time(crush):
    """When the end of double_chamber has moved so far [mm]: its speed grows over 5 ms, then is 1500 mm/s."""
    return 0.0025 + crush / 1500


def work_at(crush, reference, before="-"):
    return Quantity(f"work at {crush} mm, J", reference, before, lambda run: run.absorbed(crush_time(crush)) / 1e3)


MODELS = [
    Model("double_chamber", "main.k", "", """Aluminium profile with T-junctions and a stepped end, 7820 shells of 5 mm,
crushed by 71 mm in 50 ms. Reference: Abaqus/Explicit, S4R (github.com/magnufoy/Surrogate-modeling,
MEAN_VALUES_2/CRUSHING_1). At 3b5ed1e contact made energy from 13.5 ms on.""",
          ["as it is", "LS-DYNA's defaults", "ELFORM 16"],
          [Quantity("peak force, kN", 202.8, "156.6", lambda run: run.peak() / 1e3, 1), work_at(5, 251.9),
           work_at(10, 683, "516"), work_at(20, 2205), work_at(40, 4957), work_at(70, 8611)]),
    Model("square_tube_crush", "generate.py", "6", """Square tube, 60 x 60 x 1.5 mm, thrown onto a wall by a mass, 2000
shells of 6 mm, 12 ms. Reference: OpenRadioss, its one-point shell.""",
          ["as it is", "ISTUPD 0", "LS-DYNA's defaults"],
          [Quantity("mean force, kN", 29.3, "34.6", lambda run: run.mean_force() / 1e3, 1),
           Quantity("internal and hourglass energy, J", 5326, "6264",
                    lambda run: (run.energies[-1]["internal"] + run.energies[-1]["hourglass"]) / 1e3)]),
    Model("square_tube_crush", "generate.py", "3", """The same with 8000 shells of 3 mm. Reference: OpenRadioss, QEPH.""",
          ["as it is", "ISTUPD 0", "ELFORM 16"],
          [Quantity("mean force, kN", 25.6, "26.3", lambda run: run.mean_force() / 1e3, 1),
           Quantity("internal and hourglass energy, J", 4637, "4769",
                    lambda run: (run.energies[-1]["internal"] + run.energies[-1]["hourglass"]) / 1e3)]),
]


FACTS = {
    "lowest contact / largest internal energy": lambda run: f"{run.lowest_contact():.1e}",
    "hourglass / internal energy": lambda run: f"{100 * run.energies[-1]['hourglass'] / run.energies[-1]['internal']:.1f} %",
    "smallest step / first": lambda run: f"{run.smallest_step():.2f}",
    "mid-surface cuts at the end": lambda run: f"{run.cuts:.0f}",
}


def deck_of(model, folder):
    path = folder / model.name / model.deck
    if path.suffix == ".k":
        return path.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as out:
        deck = Path(out) / "deck.k"
        subprocess.run([sys.executable, path, model.edge, deck], check=True, stdout=subprocess.DEVNULL)
        return deck.read_text(encoding="utf-8")


def histories(folder):
    with open(folder / "timestep.csv", newline="", encoding="utf-8") as stream:
        steps = [{"dt": float(row["dt"])} for row in csv.DictReader(stream)]
    contacts = json.loads((folder / "run.json").read_text(encoding="utf-8"))["contact"]
    cuts = sum(contact["intersections"] - contact["initial_intersections"] for contact in contacts)
    return Run(rows_of(folder / "glstat.csv"), rows_of(folder / "rwforc.csv"), steps, cuts)


def call(program, command, deck, out, *more):
    done = subprocess.run([program, command, deck, "-o", out, "-q", "--precision", "mixed", *more],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{deck}: {done.stdout}{done.stderr}")


def run_of(program, text):
    with tempfile.TemporaryDirectory() as folder:
        deck = Path(folder) / "deck.k"
        deck.write_text(text, encoding="utf-8")
        call(program, "run", deck, Path(folder) / "out")
        return histories(Path(folder) / "out")


def scatter_of(program, text, runs):
    with tempfile.TemporaryDirectory() as folder:
        deck = Path(folder) / "deck.k"
        deck.write_text(text, encoding="utf-8")
        call(program, "scatter", deck, Path(folder) / "out", "--runs", str(runs), "-t", "2")
        return [histories(path) for path in sorted((Path(folder) / "out").glob("run_*")) if path.is_dir()]


def value_cell(quantity, run):
    found = quantity.of(run)
    return f"{found:.{quantity.digits}f} ({100 * (found / quantity.reference - 1):+.0f} %)"


def table(model, runs, scattered):
    heads = ["", "reference", "3b5ed1e", *runs] + (["scatter, as it is"] if scattered else [])
    lines = ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    for quantity in model.quantities:
        cells = [quantity.name, f"{quantity.reference:g}", quantity.before]
        cells += [value_cell(quantity, run) for run in runs.values()]
        if scattered:
            values = [quantity.of(run) for run in scattered]
            cells.append(f"{min(values):.{quantity.digits}f} to {max(values):.{quantity.digits}f}")
        lines.append("| " + " | ".join(cells) + " |")
    empty = [""] if scattered else []
    for name, text_of in FACTS.items():
        lines.append("| " + " | ".join([name, "", "", *(text_of(run) for run in runs.values()), *empty]) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--decks", type=Path, required=True)
    parser.add_argument("--only", help="name of a model; prints its tables instead of writing the page")
    parser.add_argument("--runs", type=int, default=8, help="of the scatter; 0 for none [8]")
    arguments = parser.parse_args()
    page = HEAD.format(runs=arguments.runs)
    for model in MODELS:
        if arguments.only and model.name != arguments.only:
            continue
        text = deck_of(model, arguments.decks)
        runs = {}
        for name in model.variants:
            runs[name] = run_of(arguments.program, VARIANTS[name](text))
        scattered = scatter_of(arguments.program, text, arguments.runs) if arguments.runs > 1 and model.edge != "3" else []
        title = model.name + (f", {model.edge} mm" if model.edge else "")
        page += f"\n## {title}\n\n{model.text}\n\n{table(model, runs, scattered)}\n"
        print(f"{title}: done", file=sys.stderr, flush=True)
    if arguments.only:
        print(page)
    else:
        PAGE.write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
