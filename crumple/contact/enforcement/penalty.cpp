// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/penalty.hpp"

#include <algorithm>
#include <cmath>

#include "contact/tolerances.hpp"

namespace crumple::contact {

/// By how much the slope grows in a length, from half of the reach on [force/length^2].
double PenaltyLaw::growth() const {
  return (tolerances::stiffening - 1) * stiffness / (0.5 * reach);
}

/// Slope where it does not grow: up to half of the reach, or everywhere [force/length].
double PenaltyLaw::even_slope() const {
  return std::min(limit, reach > 0 ? stiffness : tolerances::stiffening * stiffness);
}

bool PenaltyLaw::grows() const {
  return reach > 0 && limit > stiffness;
}

bool PenaltyLaw::is_limited_at(double penetration) const {
  return grows() ? limit < stiffness + growth() * (penetration - 0.5 * reach) : limit <= even_slope();
}

double PenaltyLaw::force(double penetration) const {
  if (penetration <= 0) return 0;
  const double beyond = penetration - 0.5 * reach;
  if (!grows() || beyond <= 0) return even_slope() * penetration;
  const double ramp = std::min(beyond, (limit - stiffness) / growth());
  return stiffness * penetration + growth() * ramp * (0.5 * ramp + (beyond - ramp));
}

double PenaltyLaw::energy(double penetration) const {
  if (penetration <= 0) return 0;
  const double beyond = penetration - 0.5 * reach;
  const double even = 0.5 * even_slope() * penetration * penetration;
  if (!grows() || beyond <= 0) return even;
  const double ramp = std::min(beyond, (limit - stiffness) / growth());
  const double rest = beyond - ramp;
  return even + growth() * ramp * (ramp * ramp / 6 + 0.5 * rest * (ramp + rest));
}

double PenaltyLaw::penetration_of(double work, double most) const {
  constexpr int halvings = 50;
  if (!grows()) return std::min(most, std::sqrt(2 * work / even_slope()));
  double low = 0;
  double high = most;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (energy(middle) < work ? low : high) = middle;
  }
  return high;
}

double stability_budget(double step_scale, double stiffness_scale) {
  const double left = tolerances::budget_safety * 4 * (1 - step_scale * step_scale);
  return std::max(tolerances::smallest_budget,
                  std::min({left, tolerances::largest_budget,
                            tolerances::budget_over_stiffness_scale * stiffness_scale}));
}

double landing_factor(double depth, double square, double next) {
  if (depth >= 1) return 1;
  // With e = a (omega dt)^2, r the next step over this one, h = 1/2 (1 + r) and g the factor
  // e h^2 g^2 - (2 + e r) h g + a + r = 0.
  const double e = depth * square;
  const double half = 1 + 0.5 * e * next;
  const double root = std::sqrt(std::max(0.0, half * half - e * (next + depth)));
  return (next + depth) / (0.5 * (1 + next) * (half + root));
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
