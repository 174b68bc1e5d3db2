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
  double left = std::max(right - at_right, std::min(wall.lowest, right));
  double at_left = excess(left);
  // Regula falsi with the Illinois modification (M. Dowell, P. Jarratt, BIT 11, 1971, 168-174): on pieces of
  // a straight line it is exact. Where a light wall meets heavy nodes these are so unlike that halves are
  // needed as well.
  constexpr int most_iterations = 200;
  constexpr int halving_period = 4;
  const double tolerance =
      wall.tolerance * std::max({std::fabs(wall.velocity), std::fabs(left), std::fabs(right)});
  int last_side = 0;
  double best = std::fabs(at_left) < at_right ? left : right;
  double least = std::min(std::fabs(at_left), at_right);
  for (int iteration = 0; iteration < most_iterations && least > tolerance; ++iteration) {
    const bool halves = iteration % halving_period == halving_period - 1;
    const double middle =
        halves ? left + 0.5 * (right - left) : left - at_left * (right - left) / (at_right - at_left);
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
