# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of docs/paper.md: deformed shapes by tools/picture, curves by matplotlib."""

import subprocess
import sys

from plan import EXAMPLES, EXAMPLES_FOLDER, MARGINS, CELL_FACTORS

sys.path.insert(0, str(EXAMPLES_FOLDER / "support"))
from runs import rows_of, run, write_deck  # noqa: E402

PICTURE = EXAMPLES_FOLDER.parent / "tools" / "picture"
TUBE_VIEW = ("--view=-0.6,-1.6,0.7",)
BOX = ("--mirror", "y", "--mirror", "z", "--wall", "x=0.3")
FRAME = ("--view=0.9,-1.6,0.8",)
# Name of the picture, example, time of the frame, options of tools/picture.
SHAPES = (
    ("box_beam_06ms", "box beam", 0.006, BOX),
    ("box_beam_12ms", "box beam", 0.012, BOX),
    ("tubes_coarse_06ms", "tubes, coarse", 0.006, TUBE_VIEW),
    ("tubes_fine_06ms", "tubes, fine", 0.006, TUBE_VIEW),
    ("frame_19ms", "frame", 0.0188, FRAME),
    ("frame_front_19ms", "frame", 0.0188, (*FRAME, "--centre", "0.3,0,0", "--zoom", "3.2")),
)
# Distinct also in grey and for the colour-blind (Okabe & Ito, 2008).
COLOURS = {"box beam": "#000000", "tubes, coarse": "#56B4E9", "tubes, fine": "#0072B2", "tubes": "#0072B2",
           "frame": "#D55E00"}
STYLES = {"linked-cell": "-", "production": "--"}


def folder_of(example_name, work):
    return work / example_name.replace(", ", "_").replace(" ", "_")


def run_for_shapes(example, program, work):
    """A run as the deck has it, whose frames and histories are kept."""
    deck = work / "deck.k"
    write_deck(deck, example.generator, example.options)
    run(program, deck, folder_of(example.name, work), ["-t", "1"])


def draw_shapes(work, folder):
    for name, example, time, options in SHAPES:
        subprocess.run([PICTURE, folder_of(example, work), "--time", str(time), "--size", "800x520", *options,
                        "--output", folder / f"paper_{name}.png"], check=True, stdout=subprocess.DEVNULL)


def new_axes(columns, xlabel, ylabel, width=5.0):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, all_axes = pyplot.subplots(1, columns, figsize=(width * columns, 3.8), squeeze=False)
    for axes in all_axes[0]:
        axes.grid(color="#e0e0e0", linewidth=0.7)
        axes.set_axisbelow(True)
        axes.spines[["top", "right"]].set_visible(False)
        axes.set_xlabel(xlabel)
    all_axes[0, 0].set_ylabel(ylabel)
    return figure, list(all_axes[0])


def save(figure, folder, name):
    figure.savefig(folder / f"paper_{name}.png", dpi=110, bbox_inches="tight", facecolor="white")


def draw_curves(results, work, folder):
    draw_expansion(results, folder)
    draw_cells(results, folder)
    draw_map(results, folder)
    draw_density(results, folder)
    draw_frame_history(work, folder)


def draw_expansion(results, folder):
    figure, axes = new_axes(2, "(c - h) / edge", "ns per element-cycle", 5.5)
    for example in EXAMPLES:
        for method, style in STYLES.items():
            runs = results.of("expansion", example.name, method)
            margins = [key[0] for key, _ in runs]
            label = example.name if method == "linked-cell" else f"{example.name}, production"
            for place, cost in zip(axes, ("global_cost", "both_cost")):
                place.plot(margins, [getattr(result, cost) for _, result in runs], style, marker="o", markersize=3,
                           color=COLOURS[example.name], label=label)
    for place, title in zip(axes, ("global search", "global and local search")):
        place.set_title(title, loc="left", fontsize=11)
        place.set_xscale("log")
        place.set_yscale("log")
    axes[-1].legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    save(figure, folder, "expansion")


def draw_cells(results, folder):
    figure, (axes,) = new_axes(1, "edge of the cells / edge of the shells", "build and query [ns per segment]")
    for example in EXAMPLES:
        runs = results.of("cell", example.name, "linked-cell")
        axes.plot([key[1] for key, _ in runs], [result.per_segment(result.values["find"]) for _, result in runs],
                  marker="o", markersize=3, color=COLOURS[example.name], label=example.name)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.legend(frameon=False, fontsize=9)
    save(figure, folder, "cell_size")


def draw_map(results, folder):
    """Global search of the fine tubes over both parameters."""
    figure, (axes,) = new_axes(1, "edge of the cells / edge of the shells", "(c - h) / edge", 6.0)
    costs = [[results.get("map", "tubes, fine", "linked-cell", margin, factor).global_cost for factor in CELL_FACTORS]
             for margin in MARGINS]
    axes.grid(visible=False)
    image = axes.imshow(costs, origin="lower", cmap="viridis_r", aspect="auto")
    for row, line in enumerate(costs):
        for column, cost in enumerate(line):
            axes.text(column, row, f"{cost:.1f}", ha="center", va="center", fontsize=8,
                      color="white" if cost > (max(map(max, costs)) + min(map(min, costs))) / 2 else "black")
    axes.set_xticks(range(len(CELL_FACTORS)), [f"{factor:g}" for factor in CELL_FACTORS])
    axes.set_yticks(range(len(MARGINS)), [f"{margin:g}" for margin in MARGINS])
    figure.colorbar(image, label="ns per element-cycle")
    save(figure, folder, "map")


def draw_density(results, folder):
    figure, axes = new_axes(3, "shells", "ns per element-cycle", 4.2)
    for example in EXAMPLES:
        for method, style in STYLES.items():
            runs = [result for _, result in results.of("mesh", example.name, method)]
            if not runs:
                continue
            name = example.name.split(",")[0]
            label = name if method == "linked-cell" else f"{name}, production"
            costs = ([result.global_cost for result in runs],
                     [result.per_segment(result.values["find"]) for result in runs],
                     [result.share(result.global_seconds) for result in runs])
            for place, values in zip(axes, costs):
                place.plot([result.shells for result in runs], values, style, marker="o", markersize=3,
                           color=COLOURS[name], label=label)
    for place, title in zip(axes, ("global search", "build and query", "global search, share of the time")):
        place.set_title(title, loc="left", fontsize=11)
        place.set_xscale("log")
        place.set_ylim(bottom=0)
    axes[1].set_ylabel("ns per segment")
    axes[2].set_ylabel("%")
    figure.tight_layout()
    axes[2].legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    save(figure, folder, "density")


def draw_frame_history(work, folder):
    rows = rows_of(folder_of("frame", work) / "nodout.csv")
    node = rows[0]["node"]
    rear = [row for row in rows if row["node"] == node]
    time = [1000 * row["time"] for row in rear]
    figure, axes = new_axes(2, "time [ms]", "displacement [mm]")
    axes[0].plot(time, [-1000 * row["ux"] for row in rear], color=COLOURS["frame"])
    axes[0].set_title("way of the rear end", loc="left", fontsize=11)
    axes[1].plot(time, [-row["vx"] for row in rear], color=COLOURS["frame"])
    axes[1].set_title("its speed", loc="left", fontsize=11)
    axes[1].set_ylabel("m/s")
    figure.tight_layout()
    save(figure, folder, "frame_displacement")
