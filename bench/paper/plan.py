# SPDX-License-Identifier: BSD-3-Clause
"""What is run for docs/paper.md: the paper's examples and the variants of each."""

import re
from dataclasses import dataclass
from pathlib import Path

EXAMPLES_FOLDER = Path(__file__).resolve().parent.parent.parent / "examples"
METHODS = ("linked-cell", "bucket-sort", "position-code", "nbs", "production")
SCALAR_METHODS = ("linked-cell", "position-code", "production")
# (c - h) / edge and cell edge / edge that are tried; those of the decks are 0.2 (box beam), 0.3 (others) and about 1.
MARGINS = (0.05, 0.1, 0.2, 0.3, 0.5, 0.8, 1.2)
CELL_FACTORS = (0.5, 0.7, 1.0, 1.4, 2.0, 3.0, 4.5)


@dataclass(frozen=True)
class Example:
    """One of the paper's runs. Lengths in m, times in s."""

    name: str
    title: str
    generator: Path
    options: tuple
    edge: float  # of the shells (of the frame: in its front)
    thickness: float  # h: largest contact distance
    seconds: float  # what a run takes, roughly: for the time to go
    repeats: int
    meshes: tuple  # (options, edges of the deck over those of this mesh)
    short_end: tuple = ()  # options of runs of other meshes and settings
    paper_share: str = ""


def generator(folder, name):
    return EXAMPLES_FOLDER / folder / name


TUBES = generator("02_two_tubes", "make_two_tubes.py")
EXAMPLES = (
    Example("box beam", "box beam, 756 shells", generator("01_box_beam", "make_box_beam.py"), (), 0.005, 0.002, 1.8, 3,
            tuple((("--element-size", size), 0.005 / size) for size in (0.005, 0.03 / 9, 0.0025, 0.03 / 18)),
            ("--end", "0.006"), "14.8 %"),
    Example("tubes, coarse", "two tubes, 600 shells", TUBES, (), 0.031, 0.005, 0.25, 5, (), (), "11.5 %"),
    Example("tubes, fine", "two tubes, 1824 shells", TUBES, ("--around", 38, "--along", 24), 0.0178, 0.005, 0.6, 5,
            tuple((("--around", round(20 * f), "--along", round(15 * f)), round(f * 20 / 38, 2))
                  for f in (1, 2, 3, 5)), (), "11.7 %"),
    Example("frame", "vehicle frame, 4772 shells", generator("03_vehicle_frame", "make_vehicle_frame.py"), (), 0.02,
            0.004, 6.0, 1, tuple((("--rows", rows), rows / 5) for rows in (5, 6, 8, 10)), ("--end", "0.0094"), "7.3 %"),
)


@dataclass(frozen=True)
class Job:
    """A run, made `repeats` times. `key` names its result."""

    key: tuple
    example: Example
    deck_options: tuple
    run_options: tuple
    repeats: int
    seconds: float  # of one, roughly
    cell: float = 0  # edge of the cells; 0: that of the deck
    expansion: float = 0  # c; 0: that of the deck
    automatic: bool = False  # c and cells are left to the program, as in decks that do not name them

    @property
    def name(self):
        return " / ".join(map(str, self.key))


def method_jobs(example):
    for method in METHODS:
        yield Job(("method", example.name, method), example, example.options, ("--search", method), example.repeats,
                  example.seconds)
    for method in SCALAR_METHODS:
        yield Job(("scalar", example.name, method), example, example.options, ("--search", method, "--isa", "scalar"),
                  1, 4 * example.seconds)
    yield Job(("mixed", example.name, "production"), example, example.options,
              ("--search", "production", "--precision", "mixed"), example.repeats, 0.75 * example.seconds)
    yield Job(("automatic", example.name, "production"), example, example.options, ("--search", "production"),
              example.repeats, example.seconds, automatic=True)


def setting_job(kind, example, method, margin, factor):
    part = 0.5 if example.short_end else 1
    return Job((kind, example.name, method, margin, factor), example, example.options,
               ("--search", method, *example.short_end), min(3, example.repeats), part * example.seconds,
               factor * example.edge, example.thickness + margin * example.edge)


def setting_jobs(example):
    for method in ("linked-cell", "production"):
        for margin in MARGINS:
            yield setting_job("expansion", example, method, margin, 1.0)
    for factor in CELL_FACTORS:
        yield setting_job("cell", example, "linked-cell", 0.3, factor)


def map_jobs(example):
    for margin in MARGINS:
        for factor in CELL_FACTORS:
            yield setting_job("map", example, "linked-cell", margin, factor)


def mesh_jobs(example):
    part = 0.5 if example.short_end else 1
    for method in ("linked-cell", "production"):
        for options, finer in example.meshes:
            yield Job(("mesh", example.name, method, finer), example, options,
                      ("--search", method, *example.short_end), 1 if finer > 1 else example.repeats,
                      part * example.seconds * finer**3)


def all_jobs():
    jobs = []
    for example in EXAMPLES:
        jobs += [*method_jobs(example), *setting_jobs(example), *mesh_jobs(example)]
        if example.name == "tubes, fine":
            jobs += map_jobs(example)
    return jobs


def with_settings(deck, cell, expansion, automatic=False):
    """The deck with other cells over the same box, and another territory expansion; 0 leaves them as they are.
    `automatic` takes both out."""
    if automatic:
        return re.sub(r"^\$crumple (expansion|cells|domain)=.*\n", "", deck, flags=re.MULTILINE)
    if expansion:
        deck = re.sub(r"^\$crumple expansion=.*$", f"$crumple expansion={expansion:g}", deck, flags=re.MULTILINE)
    if cell:
        bounds = list(map(float, re.search(r"^\$crumple domain=(.*)$", deck, flags=re.MULTILINE)[1].split(",")))
        counts = [max(1, round((high - low) / cell)) for low, high in zip(bounds[::2], bounds[1::2])]
        deck = re.sub(r"^\$crumple cells=.*$", "$crumple cells=" + ",".join(map(str, counts)), deck,
                      flags=re.MULTILINE)
    return deck
