# SPDX-License-Identifier: BSD-3-Clause
"""Responses: one number of a result, for studies. Each function here makes a function of a Result, so that it can be
given to sweep(); any other function of a Result will do as well."""
from __future__ import annotations

from typing import Callable, Iterable, Optional, Sequence, Union

import numpy

from .result import History, Result
from .signals import cfc_filter

Response = Callable[[Result], float]


def _curve(result: Result, history: str, column: str, cfc: Optional[int], select: dict) -> tuple:
    rows: History = result.history(history).select(**select)
    if not rows.rows:
        raise ValueError(f"{result.folder / (history + '.csv')} has no rows with {select}.")
    time, values = rows["time"].astype(float), rows[column].astype(float)
    if len(time) > 1 and numpy.any(numpy.diff(time) <= 0):
        raise ValueError(f"{history}.csv has several rows per time: select one item, as wall=1 or part=2.")
    if cfc:
        time, values = cfc_filter(time, values, cfc, result.units.si("time"))
    return time, values


def peak(history: str, column: str, *, cfc: Optional[int] = None, **select: Union[int, str]) -> Response:
    """The largest absolute value of a column: `peak("rwforc", "normal", wall=1, cfc=60)`. With `cfc` through the filter
    of SAE J211, for which units must be known."""

    def response(result: Result) -> float:
        return float(numpy.max(numpy.abs(_curve(result, history, column, cfc, select)[1])))

    return response


def mean(
    history: str,
    column: str,
    *,
    start: Optional[float] = None,
    end: Optional[float] = None,
    **select: Union[int, str],
) -> Response:
    """The mean over time of a column, from `start` to `end` [time] or over all: the integral of the curve through the
    points, over its duration."""

    def response(result: Result) -> float:
        time, values = _curve(result, history, column, None, select)
        first = time[0] if start is None else max(start, time[0])
        last = time[-1] if end is None else min(end, time[-1])
        if not last > first:
            raise ValueError(f"{history}.csv has no rows between {start} and {end}.")
        inside = (time > first) & (time < last)
        at = numpy.concatenate([[first], time[inside], [last]])
        curve = numpy.interp(at, time, values)
        return float(numpy.sum(0.5 * (curve[1:] + curve[:-1]) * numpy.diff(at)) / (last - first))

    return response


def absorbed(part: Optional[int] = None) -> Response:
    """The internal energy at the end [energy], of the model or of a part (its id)."""

    def response(result: Result) -> float:
        select = {} if part is None else {"part": part}
        return float(_curve(result, "glstat" if part is None else "matsum", "internal", None, select)[1][-1])

    return response


def intrusion(
    nodes: Union[int, Iterable[int]],
    reference: Union[int, Iterable[int], None] = None,
    direction: Optional[Sequence[float]] = None,
) -> Response:
    """How far nodes (ids) move at most [length], over all frames: the mean of their displacements, less that of the
    nodes `reference`, along `direction` (of any length), or its magnitude. Frames come seldom: *DATABASE_BINARY_D3PLOT
    sets how often."""
    moving = _ids(nodes)
    fixed = _ids(reference) if reference is not None else None
    along = None
    if direction is not None:
        along = numpy.asarray(direction, float)
        along = along / numpy.linalg.norm(along)

    def response(result: Result) -> float:
        largest = 0.0
        for frame in result.frames:
            places = {int(node): place for place, node in enumerate(frame.node_ids)}
            displacements = frame.displacements.astype(float)
            motion = _mean_of(displacements, places, moving)
            if fixed is not None:
                motion = motion - _mean_of(displacements, places, fixed)
            largest = max(largest, float(numpy.linalg.norm(motion) if along is None else motion @ along))
        return largest

    return response


def _ids(nodes: Union[int, Iterable[int]]) -> list:
    return [int(nodes)] if numpy.ndim(nodes) == 0 else [int(node) for node in nodes]  # type: ignore[arg-type]


def _mean_of(displacements: numpy.ndarray, places: dict, nodes: list) -> numpy.ndarray:
    missing = [node for node in nodes if node not in places]
    if missing:
        raise ValueError(f"The frames have no node {missing[0]}.")
    return displacements[[places[node] for node in nodes]].mean(axis=0)
