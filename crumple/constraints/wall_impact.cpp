// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/wall_impact.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::constraints {

double common_velocity(const SlidingWall& wall, const std::function<double(double)>& impulse) {
  // Momentum that is not accounted for, as a velocity of the wall; it grows with the velocity.
  const auto excess = [&](double velocity) {
    return velocity - wall.velocity + impulse(velocity) / wall.mass;
  };
  double right = std::min(wall.velocity, wall.highest);
  double at_right = excess(right);
  if (at_right <= 0) return right;
  double left = right - at_right;
  double at_left = excess(left);
  // Regula falsi with the Illinois modification (M. Dowell, P. Jarratt, BIT 11, 1971, 168-174): on pieces of
  // a straight line it is exact.
  constexpr int most_iterations = 100;
  const double tolerance =
      wall.tolerance * std::max({std::fabs(wall.velocity), std::fabs(left), std::fabs(right)});
  int last_side = 0;
  double best = std::fabs(at_left) < at_right ? left : right;
  double least = std::min(std::fabs(at_left), at_right);
  for (int iteration = 0; iteration < most_iterations && least > tolerance; ++iteration) {
    const double middle = left - at_left * (right - left) / (at_right - at_left);
    if (!(middle > left && middle < right)) break;
    const double at_middle = excess(middle);
    if (std::fabs(at_middle) < least) {
      best = middle;
      least = std::fabs(at_middle);
    }
    const int side = at_middle > 0 ? 1 : -1;
    (side > 0 ? right : left) = middle;
    (side > 0 ? at_right : at_left) = at_middle;
    if (side == last_side) (side > 0 ? at_left : at_right) *= 0.5;
    last_side = side;
  }
  return best;
}

}  // namespace crumple::constraints
