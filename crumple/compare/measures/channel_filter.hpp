// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "compare/curves/curve.hpp"

namespace crumple::compare {

/// Filters of SAE J211-1, appendix C: a two-pole Butterworth filter run forwards and backwards, which makes
/// it one of four poles without phase. The ends of the samples are continued by point reflection.
/// @param cfc channel frequency class [Hz]
/// @param interval between samples [s]
std::vector<double> channel_filter(const std::vector<double>& values, int cfc, double interval);

/// False where the samples are so few that the corner frequency (2.0775 times the class) is beyond a quarter
/// of their rate. `interval` in seconds.
bool can_filter(int cfc, double interval);

/// The curve at as many even times as it has points, through the filter. Returns false and leaves it as it is
/// if it has too few points for the class.
/// @param seconds_per_unit what one unit of the curve's time is [s]
bool filter_curve(Curve& curve, int cfc, double seconds_per_unit);

}  // namespace crumple::compare
