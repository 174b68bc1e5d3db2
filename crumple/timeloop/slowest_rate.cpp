// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/slowest_rate.hpp"

#include <cmath>
#include <utility>

namespace crumple::timeloop {

std::optional<double> SlowestRate::observe(const domain::NodeFields& nodes, double factor) {
  const AlignedArray<math::Vec3>& third = nodes.velocity;
  std::optional<double> steady;
  if (!first_.empty()) {
    double change = 0;
    double motion = 0;
    for (Index i = 0; i < nodes.count(); ++i) {
      if (!nodes.is_free(i)) continue;
      const math::Vec3& v = second_[i];
      const math::Vec3 turn = (third[i] - factor * v) - (v - last_factor_ * first_[i]);
      change -= nodes.mass[i] * dot(v, turn);
      motion += nodes.mass[i] * dot(v, v);
    }
    const double before = std::exchange(estimate_, motion > 0 ? change / motion : 0);
    if (estimate_ > 0 && std::fabs(estimate_ - before) < tolerance_ * estimate_) steady = estimate_;
  }
  std::swap(first_, second_);
  second_ = third;
  last_factor_ = factor;
  return steady;
}

}  // namespace crumple::timeloop
