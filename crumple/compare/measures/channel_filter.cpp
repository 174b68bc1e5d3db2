// SPDX-License-Identifier: BSD-3-Clause
#include "compare/measures/channel_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/measures/resample.hpp"

namespace crumple::compare {

namespace {

/// The corner frequency of one pass over the class.
constexpr double corner = 2.0775;

struct Coefficients {
  double a0, a1, a2, b1, b2;
};

Coefficients coefficients_of(int cfc, double interval) {
  const double wa = std::tan(std::numbers::pi * cfc * corner * interval);
  const double base = 1 + std::numbers::sqrt2 * wa + wa * wa;
  const double a0 = wa * wa / base;
  return {a0, 2 * a0, a0, -2 * (wa * wa - 1) / base, (-1 + std::numbers::sqrt2 * wa - wa * wa) / base};
}

/// In place, as if the first value had always been there.
void pass(std::vector<double>& values, const Coefficients& c) {
  double x1 = values.front();
  double x2 = values.front();
  double y1 = values.front();
  double y2 = values.front();
  for (double& value : values) {
    const double x = value;
    const double y = c.a0 * x + c.a1 * x1 + c.a2 * x2 + c.b1 * y1 + c.b2 * y2;
    value = y;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
  }
}

}  // namespace

bool can_filter(int cfc, double interval) {
  return interval > 0 && cfc * corner * interval < 0.25;
}

std::vector<double> channel_filter(const std::vector<double>& values, int cfc, double interval) {
  if (values.size() < 3 || !can_filter(cfc, interval)) return values;
  const Coefficients c = coefficients_of(cfc, interval);
  const std::size_t last = values.size() - 1;
  // Two periods of the corner frequency, after which what the ends excite has died away.
  const auto wanted = static_cast<std::size_t>(std::min(1e9, std::ceil(2 / (cfc * corner * interval))));
  const std::size_t margin = std::min(last, std::max<std::size_t>(10, wanted));
  std::vector<double> extended(values.size() + 2 * margin);
  std::copy(values.begin(), values.end(), extended.begin() + static_cast<std::ptrdiff_t>(margin));
  for (std::size_t i = 1; i <= margin; ++i) {
    extended[margin - i] = 2 * values.front() - values[i];
    extended[margin + last + i] = 2 * values.back() - values[last - i];
  }
  pass(extended, c);
  std::reverse(extended.begin(), extended.end());
  pass(extended, c);
  std::reverse(extended.begin(), extended.end());
  const auto begin = extended.begin() + static_cast<std::ptrdiff_t>(margin);
  return {begin, begin + static_cast<std::ptrdiff_t>(values.size())};
}

bool filter_curve(Curve& curve, int cfc, double seconds_per_unit) {
  if (curve.times.size() < 3) return false;
  const CommonTimes even{curve.times.front(), curve.times.back(), curve.times.size()};
  const double interval = even.interval() * seconds_per_unit;
  if (!can_filter(cfc, interval)) return false;
  curve.values = channel_filter(resample(curve, even), cfc, interval);
  for (std::size_t i = 0; i < curve.times.size(); ++i) curve.times[i] = even.at(i);
  return true;
}

}  // namespace crumple::compare
