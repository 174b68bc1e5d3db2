// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "compare/curves/curve.hpp"

namespace crumple::compare {

/// Evenly spaced times that both curves have.
struct CommonTimes {
  double start = 0;         ///< [time]
  double end = 0;           ///< [time]
  std::size_t samples = 0;  ///< with the ends
  double interval() const { return (end - start) / static_cast<double>(samples - 1); }
  /// Exactly the ends at the ends.
  double at(std::size_t sample) const;
};

/// Fewest and most samples that are chosen without the user's wish for an interval; most at all.
inline constexpr std::size_t fewest_samples = 101;
inline constexpr std::size_t most_chosen_samples = 2001;
inline constexpr std::size_t most_samples = 20001;

/// The range in which both curves have values, with the points of the curve that has more of them there, or
/// with the interval asked for [time]. Nothing if the curves share no span of time. Throws Error if the
/// interval is too short or longer than a tenth of the span.
std::optional<CommonTimes> common_times(const Curve& first, const Curve& second,
                                        std::optional<double> interval);

/// The curve at those times, by straight lines between its points.
std::vector<double> resample(const Curve& curve, const CommonTimes& times);

}  // namespace crumple::compare
