// SPDX-License-Identifier: BSD-3-Clause
#include "report/quantiser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crumple::report {

void Range::add(double value) {
  if (!std::isfinite(value)) return;
  low = empty ? value : std::min(low, value);
  high = empty ? value : std::max(high, value);
  empty = false;
}

Quantiser::Quantiser(const Range& range, int bits) : low_(range.low), last_((1 << bits) - 1) {
  step_ = (range.high - range.low) / (last_ - 1);
}

std::uint16_t Quantiser::code(double value) const {
  if (!std::isfinite(value)) return 0;
  if (!(step_ > 0)) return 1;
  const double place = std::round((value - low_) / step_);
  return static_cast<std::uint16_t>(1 + std::clamp(place, 0.0, static_cast<double>(last_ - 1)));
}

double Quantiser::value(std::uint16_t code) const {
  return low_ + step_ * (code - 1);
}

double Quantiser::bound() const {
  const double high = low_ + step_ * (last_ - 1);
  return 0.5 * step_ +
         4 * std::numeric_limits<double>::epsilon() * std::max(std::fabs(low_), std::fabs(high));
}

}  // namespace crumple::report
