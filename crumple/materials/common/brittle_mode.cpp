// SPDX-License-Identifier: BSD-3-Clause
#include "materials/common/brittle_mode.hpp"

#include <cmath>
#include <numbers>

namespace crumple::materials {
namespace {

/// On the ray of the squares of an opening and a sliding. One along which there is no strength never softens.
bool cannot_soften(const MixedMode<double>& law, double opening, double sliding) {
  const double use = squared_use(law, opening, sliding);
  return use > 0 && failure_over_onset(law, opening, sliding, use) <= 1;
}

}  // namespace

const char* brittle_mode(const MixedMode<double>& law) {
  if (cannot_soften(law, 1, 0)) return "tension";
  if (cannot_soften(law, 0, 1)) return "shear";
  for (int degrees = 1; degrees < 90; ++degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const double opening = std::cos(angle) * std::cos(angle);
    if (cannot_soften(law, opening, 1 - opening)) return "mixed modes";
  }
  return "";
}

}  // namespace crumple::materials
