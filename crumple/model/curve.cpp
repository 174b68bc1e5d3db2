// SPDX-License-Identifier: BSD-3-Clause
#include "model/curve.hpp"

#include <algorithm>

namespace crumple::model {

double Curve::at(double x) const {
  if (x <= abscissa.front()) return ordinate.front();
  if (x >= abscissa.back()) return ordinate.back();
  const auto upper = std::upper_bound(abscissa.begin(), abscissa.end(), x) - abscissa.begin();
  const double fraction = (x - abscissa[upper - 1]) / (abscissa[upper] - abscissa[upper - 1]);
  return ordinate[upper - 1] + fraction * (ordinate[upper] - ordinate[upper - 1]);
}

}  // namespace crumple::model
