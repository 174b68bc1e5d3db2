# SPDX-License-Identifier: BSD-3-Clause
"""Curves of crumple's CSV histories over time."""

import csv
import sys

ENERGIES = ["total", "kinetic", "internal", "hourglass", "contact", "friction", "rigidwall", "damping", "external_work",
            "eroded"]
ABSORBED = ["internal", "hourglass", "contact", "friction", "rigidwall"]
# Columns that tell items of one time apart, by table.
KEYS = {"part", "wall", "interface", "node"}
# Distinct also in grey and for the colour-blind (Okabe & Ito, 2008).
COLOURS = ["#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#8c8c8c", "#b8a500", "#7a4b9a"]


def read(path):
    """Rows by item: {item: {column: [values]}}. A table without items has one, named ''."""
    with open(path, newline="") as stream:
        rows = csv.DictReader(stream)
        key = next((name for name in rows.fieldnames if name in KEYS), None)
        items = {}
        for row in rows:
            item = items.setdefault(f"{key} {row[key]}" if key else "", {})
            for name, text in row.items():
                try:
                    item.setdefault(name, []).append(float(text))
                except ValueError:
                    pass
    return items


def panels_of(path, items, columns):
    """[(title, columns)], one per axes."""
    first = next(iter(items.values()), {})
    if columns:
        chosen = columns.split(",")
        unknown = [name for name in chosen if name not in first]
        if unknown:
            sys.exit(f"tools/picture: {path} has no column {', '.join(unknown)}; it has {', '.join(first)}")
        return [(path.stem, chosen)]
    if "kinetic" in first and "part" not in first:
        used = [name for name in ENERGIES if any(first[name])]
        # Kinetic energy would hide what is absorbed: that gets axes of its own.
        return [("energies", used), ("where the energy went", [name for name in ABSORBED if any(first[name])])]
    if "normal" in first:
        return [("force on rigid walls, mean over each interval", ["normal"])]
    if "internal" in first:
        return [("internal energy by part", ["internal"]), ("hourglass energy by part", ["hourglass"])]
    if "ux" in first:
        return [("displacement", ["ux", "uy", "uz"]), ("velocity", ["vx", "vy", "vz"])]
    return [(path.stem, [name for name in first if name not in KEYS | {"time", "mass"}])]


def plot(path, output, columns, logarithmic):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    items = read(path)
    panels = [panel for panel in panels_of(path, items, columns) if panel[1]]
    if not panels:
        return
    figure, all_axes = pyplot.subplots(len(panels), 1, figsize=(8, 1 + 3.2 * len(panels)), squeeze=False, sharex=True)
    for axes, (title, names) in zip(all_axes[:, 0], panels):
        curves = [(name if not item else item if len(names) == 1 else f"{item} {name}", values["time"], values[name])
                  for item, values in items.items() for name in names]
        for number, (label, time, values) in enumerate(curves[:40]):
            # An energy has the same colour in every panel.
            place = ENERGIES.index(label) if label in ENERGIES else number
            axes.plot(time, values, label=label, color=COLOURS[place % len(COLOURS)], linewidth=1.4)
        axes.set_title(title, loc="left", fontsize=11)
        axes.grid(color="#e0e0e0", linewidth=0.7)
        axes.set_axisbelow(True)
        axes.spines[["top", "right"]].set_visible(False)
        axes.margins(x=0)
        if logarithmic:
            axes.set_yscale("log")
        if 1 < len(curves) <= 20:
            axes.legend(frameon=False, fontsize=9, loc="center left", bbox_to_anchor=(1.0, 0.5))
    all_axes[-1, 0].set_xlabel("time")
    figure.savefig(output, dpi=130, bbox_inches="tight", facecolor="white")
    pyplot.close(figure)
    print(output)
