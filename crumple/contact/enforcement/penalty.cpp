// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/penalty.hpp"

#include <algorithm>
#include <cmath>

#include "contact/tolerances.hpp"

namespace crumple::contact {

double PenaltyLaw::force(double penetration) const {
  if (penetration <= 0) return 0;
  if (limit <= stiffness) return limit * penetration;
  const double half = 0.5 * reach;
  if (penetration <= half) return stiffness * penetration;
  const double growth = std::min(tolerances::stiffening * stiffness, limit) - stiffness;
  if (half <= 0) return (stiffness + growth) * penetration;
  // The slope grows by `rate` per length until it has grown by `growth`, which takes `ramp`.
  const double rate = (tolerances::stiffening - 1) * stiffness / half;
  const double ramp = growth / rate;
  const double beyond = penetration - half;
  const double on_ramp = std::min(beyond, ramp);
  return stiffness * penetration + rate * on_ramp * (0.5 * on_ramp + (beyond - on_ramp));
}

double stability_budget(double step_scale, double stiffness_scale) {
  const double left = tolerances::budget_safety * 4 * (1 - step_scale * step_scale);
  return std::max(tolerances::smallest_budget,
                  std::min({left, tolerances::largest_budget,
                            tolerances::budget_over_stiffness_scale * stiffness_scale}));
}

double landing_factor(double depth, double square) {
  if (depth >= 1) return 1;
  // 1/2 e g^2 - (1 + 1/2 e) g + 1/2 (1 + a) = 0 with e = a (omega dt)^2, g the factor.
  const double e = depth * square;
  const double half = 1 + 0.5 * e;
  return (1 + depth) / (half + std::sqrt(half * half - e * (1 + depth)));
}

double leaving_factor(double depth, double square) {
  // 1/2 e g^2 + g - 1/2 (1 + b) = 0
  const double e = depth * square;
  const double factor = (1 + depth) / (1 + std::sqrt(1 + e * (1 + depth)));
  return depth < 1 + e * factor ? factor : 1;
}

double passive_force(double energy, double speed, double inverse_mass, double step) {
  const double square = speed * speed + 2 * std::max(0.0, energy) * inverse_mass;
  return std::max(0.0, std::sqrt(square) - speed) / (step * inverse_mass);
}

double damping_factor(double fraction) {
  const double root = std::sqrt(1 + fraction * fraction) - fraction;
  return root * root;
}

double decay(double x) {
  constexpr int halvings_limit = 11;
  if (x >= 700) return 0;
  int halvings = 0;
  for (; x > 0.5 && halvings < halvings_limit; ++halvings) x *= 0.5;
  // Taylor series of exp(-x) by Horner's rule; 0.5^16 / 16! is far below the last bit.
  double sum = 1;
  for (int n = 16; n > 0; --n) sum = 1 - x / n * sum;
  for (; halvings > 0; --halvings) sum *= sum;
  return sum;
}

}  // namespace crumple::contact
