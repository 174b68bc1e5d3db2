# SPDX-License-Identifier: BSD-3-Clause
"""The head injury criterion."""
from __future__ import annotations

import math

import numpy

from .result import Result
from .signals import cfc_filter

STANDARD_GRAVITY = 9.80665  # [m/s^2], ISO 80000-3


def hic(time: numpy.ndarray, acceleration: numpy.ndarray, window: float = 0.015) -> float:
    """HIC = max over t1 < t2 <= t1 + window of (t2 - t1) (1/(t2 - t1) int_t1^t2 a dt)^2.5.

    `time` [s], `acceleration`: resultant at the centre of gravity of the head [g], shape (n,); `window` [s]: 0.015 is
    HIC15, 0.036 is HIC36. The acceleration is linear between samples; t1 and t2 are samples, or one of them is and the
    other a window away. The filter of the class 1000 (cfc_filter) is the caller's.

    Source: J. Versace, A Review of the Severity Index, SAE 710881 (1971); 49 CFR 571.208, S6.2 (HIC15 and HIC36).
    """
    t = numpy.asarray(time, float)
    a = numpy.asarray(acceleration, float)
    if t.ndim != 1 or t.shape != a.shape or len(t) < 2:
        raise ValueError("hic needs two arrays of the same length, at least 2.")
    if not numpy.all(numpy.diff(t) > 0):
        raise ValueError("The times of hic must ascend.")
    if not window > 0:
        raise ValueError(f"The window is a positive time [s], not {window}.")
    integral = numpy.concatenate([[0.0], numpy.cumsum(0.5 * (a[1:] + a[:-1]) * numpy.diff(t))])

    def best(duration: numpy.ndarray, gain: numpy.ndarray) -> float:
        fits = (duration > 0) & (duration <= window * (1 + 1e-12)) & (gain > 0)
        return float(numpy.max(gain[fits] ** 2.5 / duration[fits] ** 1.5)) if fits.any() else 0.0

    largest = 0.0
    for apart in range(1, len(t)):
        duration = t[apart:] - t[:-apart]
        if duration.min() > window * (1 + 1e-12):
            break
        largest = max(largest, best(duration, integral[apart:] - integral[:-apart]))
    if t[-1] - t[0] > window:
        for ends in (t[t + window <= t[-1]] + window, t[t - window >= t[0]]):
            gain = _integral_to(ends, t, a, integral) - _integral_to(ends - window, t, a, integral)
            largest = max(largest, best(numpy.full(len(ends), window), gain))
    return largest


def _integral_to(ends: numpy.ndarray, t: numpy.ndarray, a: numpy.ndarray, integral: numpy.ndarray) -> numpy.ndarray:
    """Of the curve through the samples, from its beginning."""
    at = numpy.clip(numpy.searchsorted(t, ends, side="right") - 1, 0, len(t) - 2)
    past = ends - t[at]
    slope = (a[at + 1] - a[at]) / (t[at + 1] - t[at])
    return integral[at] + past * (a[at] + 0.5 * slope * past)


def hic_of_result(result: Result, node: int, window: float = 0.015, cfc: int = 1000) -> float:
    """HIC of a node of nodout.csv (*DATABASE_HISTORY_NODE), from the filtered components of its acceleration. `cfc`: 0
    does not filter. Needs known units (Result(folder, units="kg, mm, ms")); raises ValueError without."""
    rows = result.history("nodout").select(node=node)
    if not rows.rows:
        raise ValueError(f"{result.folder / 'nodout.csv'} has no node {node}.")
    seconds = result.units.si("time")
    gravity = result.units.si("acceleration") / STANDARD_GRAVITY
    time = rows["time"]
    square = 0.0
    for name in ("ax", "ay", "az"):
        values = rows[name]
        even, values = cfc_filter(rows["time"], values, cfc, seconds) if cfc else (rows["time"], values)
        time = even
        square = square + (gravity * values) ** 2
    if not math.isfinite(numpy.sum(square)):
        return math.nan
    return hic(seconds * time, numpy.sqrt(square), window)
