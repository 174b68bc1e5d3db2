#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a folding shell structure absorbs, one change at a time (docs/theory/hourglass.md).

    bench/folding_study.py --program build/release/crumple --times 0.004,0.008,0.012 deck.k
    bench/folding_study.py ... --only "as it is;ELFORM 16" --end 0.0107 --plot curves.svg deck.k
    bench/folding_study.py ... --ls-dyna-defaults deck.k     viscous control, constant thickness where the deck is silent

The deck has one *CONTACT_AUTOMATIC_SINGLE_SURFACE at most, shells of ELFORM 2, numbers in fixed columns. Prints a
Markdown table: energy absorbed (internal, hourglass, friction, contact) at the times, hourglass over internal energy,
the highest force on the rigid wall and its mean.
"""
import argparse
import csv
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ABSORBED = ["internal", "hourglass", "contact", "friction", "rigidwall"]


def card(*fields):
    return "".join(f"{field:>10}" for field in fields) + "\n"


def with_card(text, cards):
    """The deck with cards before its first part."""
    return text.replace("*PART\n", cards + "*PART\n", 1)


def without(text, keyword):
    return re.sub(rf"^\*{keyword}[^\n]*\n(?:[^*\n][^\n]*\n|\n)*", "", text, flags=re.M)


def hourglass(form, coefficient):
    def change(text):
        return with_card(without(text, "CONTROL_HOURGLASS"), "*CONTROL_HOURGLASS\n" + card(form, coefficient))
    return change


def section(column, value):
    """Another entry in a column (from 1) of the first card of every *SECTION_SHELL."""
    def change(text):
        def replaced(found):
            line = found[2].ljust(10 * column)
            return found[1] + line[:10 * (column - 1)] + f"{value:>10}" + line[10 * column:].rstrip() + "\n"
        return re.sub(r"^(\*SECTION_SHELL\n)([^*\n]*)\n", replaced, text, flags=re.M)
    return change


def thickness_change(istupd):
    def change(text):
        return with_card(without(text, "CONTROL_SHELL"), "*CONTROL_SHELL\n" + card("", "", 0, istupd))
    return change


def half_step(text):
    return with_card(without(text, "CONTROL_TIMESTEP"), "*CONTROL_TIMESTEP\n" + card("", 0.45))


def frictionless_wall(text):
    before = r"^(\*RIGIDWALL_PLANAR(?:_ID\n[^\n]*)?\n[^\n]*\n[^\n]{60})"
    return re.sub(before + r"[^\n]*", r"\g<1>        0.", text, flags=re.M)


def both(*changes):
    def change(text):
        for one in changes:
            text = one(text)
        return text
    return change


VARIANTS = {
    "as it is": lambda text: text,
    "IHQ 1, QM 0.1": hourglass(1, 0.1),
    "IHQ 4, QM 0.05": hourglass(4, 0.05),
    "IHQ 4, QM 0.1": hourglass(4, 0.1),
    "IHQ 4, QM 0.67": hourglass(4, 0.67),
    "ELFORM 10": section(2, 10),
    "ELFORM 16": section(2, 16),
    "ELFORM 16, ISTUPD 1": both(section(2, 16), thickness_change(1)),
    "ISTUPD 1": thickness_change(1),
    "ISTUPD 0": thickness_change(0),
    "IHQ 4, QM 0.05, ISTUPD 1": both(hourglass(4, 0.05), thickness_change(1)),
    "IHQ 4, QM 0.67, ISTUPD 1": both(hourglass(4, 0.67), thickness_change(1)),
    "LS-DYNA's defaults": both(hourglass(1, 0.1), thickness_change(0)),
    "9 points": section(4, 9),
    "shear factor 1": section(3, 1.0),
    "no friction at the wall": frictionless_wall,
    "no self-contact": lambda text: without(text, "CONTACT_AUTOMATIC_SINGLE_SURFACE"),
    "half the step": half_step,
    "double": lambda text: text,
}


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as stream:
        return [{name: float(text) for name, text in row.items()} for row in csv.DictReader(stream)]


def run(arguments, name, text, folder):
    deck = folder / "deck.k"
    deck.write_text(text, encoding="utf-8")
    command = [arguments.program, "run", deck, "-o", folder / "out", "-t", "1", "-q",
               "--precision", "double" if name == "double" else "mixed"]
    if arguments.ls_dyna_defaults:
        command.append("--ls-dyna-defaults")
    if arguments.end:
        command += ["--end", str(arguments.end)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if not (folder / "out" / "glstat.csv").exists():
        sys.exit(f"{name}: {done.stdout}{done.stderr}")
    return rows_of(folder / "out" / "glstat.csv"), rows_of(folder / "out" / "rwforc.csv")


def cells_of(times, energies, walls):
    cells = []
    for time in times:
        row = min(energies, key=lambda at: abs(at["time"] - time))
        near = abs(row["time"] - time) < 0.02 * time
        cells.append(f"{sum(row[part] for part in ABSORBED):.3g}" if near else "-")
    impulse = sum(old["normal"] * (new["time"] - old["time"]) for old, new in zip(walls, walls[1:]))
    last = energies[-1]
    return cells + [f"{100 * last['hourglass'] / last['internal']:.1f} %", f"{max(row['normal'] for row in walls):.4g}",
                    f"{impulse / walls[-1]['time']:.4g}"]


def plot(path, curves):
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "crumple"
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(8, 4.5))
    for name, energies in curves.items():
        absorbed = [sum(row[part] for part in ABSORBED) for row in energies]
        axes.plot([row["time"] for row in energies], absorbed, label=name)
    axes.set_xlabel("time")
    axes.set_ylabel("energy absorbed")
    axes.grid(color="#e0e0e0")
    axes.legend(frameon=False)
    figure.savefig(path, bbox_inches="tight", metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--times", required=True, help="at which energies are compared, separated by commas")
    parser.add_argument("--end", type=float, help="end time instead of the deck's")
    parser.add_argument("--only", help=f"variants, separated by semicolons: {'; '.join(VARIANTS)}")
    parser.add_argument("--ls-dyna-defaults", action="store_true", help="as the program's option, for all variants")
    parser.add_argument("--plot", help="picture of the energy absorbed over time")
    parser.add_argument("deck", type=Path)
    arguments = parser.parse_args()
    times = [float(time) for time in arguments.times.split(",")]
    names = arguments.only.split(";") if arguments.only else list(VARIANTS)
    text = arguments.deck.read_text(encoding="utf-8")
    print("| variant | " + " | ".join(f"{time:g}" for time in times) + " | hourglass / internal | peak | mean |")
    print("|---" * (len(times) + 4) + "|")
    curves = {}
    for name in names:
        with tempfile.TemporaryDirectory() as folder:
            curves[name], walls = run(arguments, name, VARIANTS[name](text), Path(folder))
        print(f"| {name} | " + " | ".join(cells_of(times, curves[name], walls)) + " |", flush=True)
    if arguments.plot:
        plot(arguments.plot, curves)


if __name__ == "__main__":
    main()
