// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/null.hpp"

#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {

std::vector<double> NullLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  // For contact alone, which takes no stiffness from shells without one.
  require(law.youngs_modulus >= 0, material, "Young's modulus must not be negative");
  require(law.poissons_ratio > -1 && law.poissons_ratio < 0.5, material,
          "Poisson's ratio must be above -1 and below 0.5");
  return {0};
}

std::vector<double> NullLaw::solid_constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require(law.viscosity >= 0, material, "the viscosity must not be negative");
  require(law.least_pressure <= 0, material, "the pressure cut-off must not be above zero");
  std::vector<double> numbers(Count);
  numbers[Viscosity] = law.viscosity;
  numbers[Largest] = law.largest_volume;
  numbers[Smallest] = law.smallest_volume;
  return numbers;
}

bool NullLaw::solid_can_fail(const model::ConstitutiveLaw& law) {
  const auto& fluid = std::get<Model>(law);
  return fluid.largest_volume > 0 || fluid.smallest_volume > 0;
}

}  // namespace crumple::materials
