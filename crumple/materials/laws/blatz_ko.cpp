// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/blatz_ko.hpp"

#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {

std::vector<double> BlatzKoLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  std::vector<double> numbers(Count);
  numbers[Shear] = 0.5 * law.youngs_modulus / (1 + law.poissons_ratio);
  numbers[VolumeExponent] = 1 / (1 - 2 * law.poissons_ratio);
  numbers[PerDensity] = 1 / material.density;
  return numbers;
}

}  // namespace crumple::materials
