// SPDX-License-Identifier: BSD-3-Clause
#include "contact/tied/cohesive_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace crumple::contact {
namespace {

double square_of(double value) {
  return value * value;
}

}  // namespace

double CohesiveLaw::used(double across, double along, const CohesiveStiffness& stiffness) const {
  double square = 0;
  if (failure_.normal_strength > 0) square += across * square_of(stiffness.normal / failure_.normal_strength);
  if (failure_.shear_strength > 0) square += along * square_of(stiffness.shear / failure_.shear_strength);
  return square;
}

CohesiveLaw::Range CohesiveLaw::range(double opening, double sliding,
                                      const CohesiveStiffness& stiffness) const {
  const double length = std::hypot(std::max(opening, 0.0), sliding);
  const double across = square_of(std::max(opening, 0.0) / length);
  const double along = square_of(sliding / length);
  const double square = used(across, along, stiffness);
  constexpr double never = std::numeric_limits<double>::max();
  if (!(square > 0)) return {never, never};
  Range found;
  found.onset = 1 / std::sqrt(square);
  // Twice the energies of the modes over the onset, where the failure is at a distance of 1.
  const double normal = stiffness.normal * across;
  const double shear = stiffness.shear * along;
  const model::TieSoftening& given = softening_;
  switch (given.law) {
    case model::TieSoftening::Law::PowerLaw:
      found.failure = 2 / found.onset *
                      std::pow(std::pow(normal / given.normal_energy, given.exponent) +
                                   std::pow(shear / given.shear_energy, given.exponent),
                               -1 / given.exponent);
      break;
    case model::TieSoftening::Law::BenzeggaghKenane: {
      const double share = std::pow(shear / (normal + shear), given.exponent);
      const double energy = given.normal_energy + (given.shear_energy - given.normal_energy) * share;
      found.failure = 2 * energy / (found.onset * (normal + shear));
      break;
    }
    case model::TieSoftening::Law::CriticalOpening:
      found.failure = given.critical_opening;
  }
  return found;
}

double CohesiveLaw::damage(double opening, double sliding, const CohesiveStiffness& stiffness,
                           double before) const {
  const double length = std::hypot(std::max(opening, 0.0), sliding);
  // Most ties are below their strength, and where they fail takes powers to find.
  if (used(square_of(std::max(opening, 0.0)), square_of(sliding), stiffness) <= 1) return before;
  const auto [onset, failure] = range(opening, sliding, stiffness);
  if (length <= onset) return before;
  if (length >= failure) return 1;
  return std::max(before, failure * (length - onset) / (length * (failure - onset)));
}

const char* CohesiveLaw::brittle_mode(const CohesiveStiffness& stiffness) const {
  const auto cannot_soften = [](const Range& range) {
    return range.onset < std::numeric_limits<double>::max() && range.failure <= range.onset;
  };
  if (cannot_soften(range(1, 0, stiffness))) return "tension";
  if (cannot_soften(range(0, 1, stiffness))) return "shear";
  for (int degrees = 1; degrees < 90; ++degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    if (cannot_soften(range(std::cos(angle), std::sin(angle), stiffness))) return "mixed modes";
  }
  return "";
}

}  // namespace crumple::contact
