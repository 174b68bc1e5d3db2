#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Curves of a result with numpy and matplotlib: energies, and the force on each rigid wall over time.

    ./curves.py ../../square_tube.out        writes curves.png into the folder
"""
import pathlib
import sys

import matplotlib
import numpy

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def main():
    folder = pathlib.Path(sys.argv[1])
    energies = numpy.genfromtxt(folder / "glstat.csv", delimiter=",", names=True)
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4))
    for name in ("kinetic", "internal", "hourglass", "contact", "friction", "total"):
        left.plot(energies["time"], energies[name], label=name)
    left.set(xlabel="time", ylabel="energy")
    left.legend()
    if (folder / "rwforc.csv").exists():
        walls = numpy.genfromtxt(folder / "rwforc.csv", delimiter=",", names=True)
        for wall in numpy.unique(walls["wall"]):
            rows = walls[walls["wall"] == wall]
            right.plot(rows["time"], rows["normal"], label=f"wall {wall:.0f}")
        right.set(xlabel="time", ylabel="normal force")
        right.legend()
    figure.tight_layout()
    figure.savefig(folder / "curves.png", dpi=120)
    print(folder / "curves.png")


main()
