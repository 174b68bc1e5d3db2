// SPDX-License-Identifier: BSD-3-Clause
#include "contact/tied/cohesive_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "materials/common/brittle_mode.hpp"

namespace crumple::contact {
namespace {

double square_of(double value) {
  return value * value;
}

using Numbers = materials::MixedMode<double>;

Numbers::Criterion criterion_of(model::TieSoftening::Law law) {
  switch (law) {
    case model::TieSoftening::Law::PowerLaw:
      return Numbers::Criterion::PowerLaw;
    case model::TieSoftening::Law::BenzeggaghKenane:
      return Numbers::Criterion::BenzeggaghKenane;
    case model::TieSoftening::Law::CriticalOpening:
      break;
  }
  return Numbers::Criterion::CriticalOpening;
}

}  // namespace

Numbers CohesiveLaw::numbers(const CohesiveStiffness& stiffness) const {
  const auto use = [](double of, double strength) { return strength > 0 ? square_of(of / strength) : 0; };
  Numbers found;
  found.criterion = criterion_of(softening_.law);
  found.normal_stiffness = stiffness.normal;
  found.shear_stiffness = stiffness.shear;
  found.normal_use = use(stiffness.normal, failure_.normal_strength);
  found.shear_use = use(stiffness.shear, failure_.shear_strength);
  found.normal_energy = softening_.normal_energy;
  found.shear_energy = softening_.shear_energy;
  found.exponent = softening_.exponent;
  found.critical_opening = softening_.critical_opening;
  return found;
}

CohesiveLaw::Range CohesiveLaw::range(double opening, double sliding,
                                      const CohesiveStiffness& stiffness) const {
  const Numbers law = numbers(stiffness);
  const double across = square_of(std::max(opening, 0.0));
  const double along = square_of(sliding);
  const double use = materials::squared_use(law, across, along);
  constexpr double never = std::numeric_limits<double>::max();
  if (!(use > 0)) return {never, never};
  const double onset = std::sqrt((across + along) / use);
  return {onset, onset * materials::failure_over_onset(law, across, along, use)};
}

double CohesiveLaw::damage(double opening, double sliding, const CohesiveStiffness& stiffness,
                           double before) const {
  return materials::mixed_mode_damage(numbers(stiffness), square_of(std::max(opening, 0.0)),
                                      square_of(sliding), before);
}

const char* CohesiveLaw::brittle_mode(const CohesiveStiffness& stiffness) const {
  return materials::brittle_mode(numbers(stiffness));
}

}  // namespace crumple::contact
