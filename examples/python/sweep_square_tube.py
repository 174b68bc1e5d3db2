#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A study: which of thickness, yield stress and speed decides how a square tube of steel is crushed? Runs a small tube for
samples of the three, fits quadratic polynomials to peak force, mean force and crushed length, and prints their first-order
and total Sobol indices. NumPy alone; a run takes half a second, for which the mesh is coarse: hourglass energy is 17 % of the
internal one, so that the forces are too high. Take it as a pattern.

    PYTHONPATH=../../build/python/python ./sweep_square_tube.py study       60 runs; later calls only what is missing
    PYTHONPATH=../../build/python/python ./sweep_square_tube.py study --runs 120 --jobs 4
"""
import argparse
import pathlib

import numpy

import crumple

RANGES = {"thick": (1.0, 1.6), "yield": (0.20, 0.40), "speed": (6.0, 12.0)}  # [mm, GPa, mm/ms]
END = 4.0  # [ms]

DECK = """*KEYWORD
*TITLE
square tube against a moving wall
*PARAMETER
R thick          1.2
R yield          0.3
R speed         10.0
*CONTROL_TERMINATION
{end:10.3f}
*PART
tube
         1         1         1
*SECTION_SHELL
         1         2  0.833333         5
&thick
*MAT_PLASTIC_KINEMATIC
         1   7.83E-6     207.0       0.3&yield           1.0       1.0
*CONTACT_AUTOMATIC_SINGLE_SURFACE
         0         0         0         0
       0.1       0.1

*BOUNDARY_SPC_SET
         1         0         1         1         1         1         1         1
*SET_NODE_LIST
         1
{held}
*RIGIDWALL_PLANAR_MOVING
         0
       0.0       0.0{top:10.1f}       0.0       0.0       0.0       0.3
      30.0&speed
*DATABASE_RWFORC
      0.01
*DATABASE_GLSTAT
      0.01
*DATABASE_BINARY_D3PLOT
       0.2
*NODE
{nodes}
*ELEMENT_SHELL
{shells}
*END
"""


def tube(side=40.0, length=120.0, across=6, along=18):
    """The deck of a tube of `across` elements a side and `along` along; one row is 0.4 mm inwards, where folding begins."""
    around = 4 * across
    corners = numpy.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]) * side - side / 2
    nodes, shells = [], []
    for k in range(along + 1):
        inwards = 1 - 0.8 / side if k == along - 2 else 1.0
        for i in range(around):
            wall, step = divmod(i, across)
            x, y = (corners[wall] + (corners[wall + 1] - corners[wall]) * step / across) * inwards
            nodes.append(f"{k * around + i + 1:8d}{x:16.6f}{y:16.6f}{k * length / along:16.6f}")
    for k in range(along):
        for i in range(around):
            low, high = k * around + 1, (k + 1) * around + 1
            row = (low + i, low + (i + 1) % around, high + (i + 1) % around, high + i)
            shells.append(f"{k * around + i + 1:8d}{1:8d}" + "".join(f"{node:8d}" for node in row))
    held = "\n".join("".join(f"{node:10d}" for node in range(first, first + 8)) for first in range(1, around + 1, 8))
    return DECK.format(end=END, held=held, top=length + 0.1, nodes="\n".join(nodes), shells="\n".join(shells))


def polynomial(x):
    """Terms 1, x_i, x_i x_j of points in [-1, 1]^d: shape (points, terms)."""
    d = x.shape[1]
    terms = [numpy.ones(len(x))] + [x[:, i] for i in range(d)]
    return numpy.column_stack(terms + [x[:, i] * x[:, j] for i in range(d) for j in range(i, d)])


def scaled(table):
    low, high = numpy.array([RANGES[name] for name in table.parameters]).T
    return 2 * (table.inputs() - low) / (high - low) - 1


def fit(x, y):
    """Coefficients by least squares, and Q2: the share of the variance that is predicted for a point left out."""
    terms = polynomial(x)
    coefficients = numpy.linalg.lstsq(terms, y, rcond=None)[0]
    leverage = numpy.einsum("ij,ji->i", terms, numpy.linalg.pinv(terms))
    left_out = (y - terms @ coefficients) / (1 - leverage)
    return coefficients, 1 - numpy.mean(left_out**2) / numpy.var(y)


def sobol(model, d, n=20000, seed=1):
    """First-order and total indices of a function of d even random numbers in [-1, 1], with the estimators of A. Saltelli
    et al., Computer Physics Communications 181 (2010), table 2 (b) and (f)."""
    random = numpy.random.default_rng(seed)
    a, b = random.uniform(-1, 1, (2, n, d))
    at_a, at_b = model(a), model(b)
    variance = numpy.var(numpy.concatenate([at_a, at_b]))
    first, total = [], []
    for i in range(d):
        mixed = a.copy()
        mixed[:, i] = b[:, i]
        at_mixed = model(mixed)
        first.append(numpy.mean(at_b * (at_mixed - at_a)) / variance)
        total.append(0.5 * numpy.mean((at_a - at_mixed) ** 2) / variance)
    return numpy.array(first), numpy.array(total)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=60)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    deck = options.folder / "square_tube.k"
    deck.write_text(tube())
    table = crumple.sweep(
        deck,
        crumple.latin_hypercube(RANGES, options.runs),
        {
            "peak force": crumple.peak("rwforc", "normal", wall=1, cfc=600),
            "mean force": crumple.mean("rwforc", "normal", wall=1),
            "crushed": crumple.peak("rwmotion", "uz", wall=1),
        },
        jobs=options.jobs,
        folder=options.folder,
    )
    x = scaled(table)[table.ok]
    print(f"{len(x)} of {options.runs} runs ended normally")
    print(f"{'response':12} {'mean':>8} {'Q2':>6}  " + "  ".join(f"{name + ' S, ST':>14}" for name in table.parameters))
    for name in table.responses:
        y = table[name][table.ok]
        coefficients, quality = fit(x, y)
        first, total = sobol(lambda points, c=coefficients: polynomial(points) @ c, x.shape[1])
        shares = "  ".join(f"{s:7.2f} {t:6.2f}" for s, t in zip(first, total))
        print(f"{name:12} {y.mean():8.3f} {quality:6.3f}  {shares}")


if __name__ == "__main__":
    main()
