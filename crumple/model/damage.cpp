// SPDX-License-Identifier: BSD-3-Clause
#include "model/damage.hpp"

#include <algorithm>
#include <cstddef>

namespace crumple::model {

double CurveFamily::at(double of, double x) const {
  if (curve.size() == 1 || of <= value.front()) return curve.front().at(x);
  if (of >= value.back()) return curve.back().at(x);
  const auto upper =
      static_cast<std::size_t>(std::upper_bound(value.begin(), value.end(), of) - value.begin());
  const double fraction = (of - value[upper - 1]) / (value[upper] - value[upper - 1]);
  const double below = curve[upper - 1].at(x);
  return below + fraction * (curve[upper].at(x) - below);
}

CurveFamily constant_family(double ordinate) {
  return {{0}, {Curve{.id = 0, .abscissa = {0}, .ordinate = {ordinate}}}};
}

}  // namespace crumple::model
