# SPDX-License-Identifier: BSD-3-Clause
"""Curves over time: even samples and the filters of crash tests."""
from __future__ import annotations

from typing import Tuple

import numpy

from . import _crumple


def even_samples(time: numpy.ndarray, values: numpy.ndarray) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """The curve at as many even times as it has points, by linear interpolation."""
    time = numpy.asarray(time, float)
    even = numpy.linspace(time[0], time[-1], len(time))
    return even, numpy.interp(even, time, numpy.asarray(values, float))


def cfc_filter(
    time: numpy.ndarray, values: numpy.ndarray, cfc: int, seconds: float = 1.0
) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """The filter of SAE J211-1, appendix C, for a channel frequency class `cfc` [Hz] (60, 180, 600, 1000): two poles after
    Butterworth, run forwards and backwards. The same as of `crumple compare --cfc`. `time` in units of `seconds` s (1e-3:
    ms); the samples are made even first. Returns times and filtered values.

    Source: SAE J211-1, Instrumentation for Impact Test, Part 1, Electronic Instrumentation, appendix C. The gain at
    the frequency f is 1 / (1 + (tan(pi f T) / tan(pi 2.0775 cfc T))^4) with the sampling interval T: -3 dB at 5/3 of the
    class. Raises ValueError where samples are too few for the class.
    """
    even, samples = even_samples(time, values)
    if len(even) < 3:
        raise ValueError(f"A filter needs at least 3 samples; there are {len(even)}.")
    interval = (even[-1] - even[0]) / (len(even) - 1) * seconds
    return even, _crumple.channel_filter(samples, int(cfc), interval)
