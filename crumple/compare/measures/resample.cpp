// SPDX-License-Identifier: BSD-3-Clause
#include "compare/measures/resample.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace crumple::compare {

namespace {

std::size_t points_between(const Curve& curve, double start, double end) {
  const auto first = std::lower_bound(curve.times.begin(), curve.times.end(), start);
  const auto last = std::upper_bound(curve.times.begin(), curve.times.end(), end);
  return static_cast<std::size_t>(last - first);
}

}  // namespace

double CommonTimes::at(std::size_t sample) const {
  const double share = static_cast<double>(sample) / static_cast<double>(samples - 1);
  return sample + 1 == samples ? end : start + share * (end - start);
}

std::optional<CommonTimes> common_times(const Curve& first, const Curve& second,
                                        std::optional<double> interval) {
  if (first.times.size() < 2 || second.times.size() < 2) return std::nullopt;
  CommonTimes times;
  times.start = std::max(first.times.front(), second.times.front());
  times.end = std::min(first.times.back(), second.times.back());
  if (!(times.end > times.start)) return std::nullopt;
  if (!interval) {
    const std::size_t points = std::max(points_between(first, times.start, times.end),
                                        points_between(second, times.start, times.end));
    times.samples = std::clamp(points, fewest_samples, most_chosen_samples);
    return times;
  }
  const double steps = std::floor((times.end - times.start) / *interval * (1 + 1e-12));
  if (!(steps >= 10) || steps >= static_cast<double>(most_samples))
    throw Error(fmt::format(
        "An interval of {} makes {:.3g} samples of the common time from {} to {}: 10 to {} are possible.",
        *interval, steps, times.start, times.end, most_samples - 1));
  times.samples = static_cast<std::size_t>(steps) + 1;
  times.end = std::min(times.end, times.start + steps * *interval);
  return times;
}

std::vector<double> resample(const Curve& curve, const CommonTimes& times) {
  std::vector<double> values(times.samples);
  for (std::size_t sample = 0; sample < values.size(); ++sample)
    values[sample] = value_at(curve, times.at(sample));
  return values;
}

}  // namespace crumple::compare
