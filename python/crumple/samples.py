# SPDX-License-Identifier: BSD-3-Clause
"""Samples of parameters for studies: a list of dictionaries, name -> value."""
from __future__ import annotations

import itertools
from typing import Mapping, Sequence, Tuple

import numpy


def factorial(values: Mapping[str, Sequence[float]]) -> list[dict[str, float]]:
    """All combinations, the last parameter running fastest."""
    return [dict(zip(values, row)) for row in itertools.product(*values.values())]


def latin_hypercube(ranges: Mapping[str, Tuple[float, float]], n: int, seed: int = 1) -> list[dict[str, float]]:
    """n samples of which each parameter has one in each of n equal shares of its range, at a random place, and in random
    order; the same for the same seed. Source: M.D. McKay, R.J. Beckman, W.J. Conover, Technometrics 21(2), 1979."""
    if n < 1:
        raise ValueError(f"n is at least 1, not {n}.")
    random = numpy.random.default_rng(seed)
    columns = {}
    for name, (low, high) in ranges.items():
        share = (random.permutation(n) + random.random(n)) / n
        columns[name] = low + (high - low) * share
    return [{name: float(column[i]) for name, column in columns.items()} for i in range(n)]


def rows_of(samples: object) -> list[dict[str, float]]:
    """Samples in any form that sweep() takes: a list of dictionaries, a dictionary of columns, or a structured array."""
    if isinstance(samples, numpy.ndarray) and samples.dtype.names:
        return [{name: row[name].item() for name in samples.dtype.names} for row in samples]
    if isinstance(samples, Mapping):
        lengths = {len(column) for column in samples.values()}
        if len(lengths) != 1:
            raise ValueError("The columns of the samples have different lengths.")
        return [{name: column[i] for name, column in samples.items()} for i in range(lengths.pop())]
    rows = [dict(row) for row in samples]  # type: ignore[attr-defined]
    if rows and any(set(row) != set(rows[0]) for row in rows):
        raise ValueError("All samples have the same parameters.")
    return rows
