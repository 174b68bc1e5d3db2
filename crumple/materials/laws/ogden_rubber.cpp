// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/ogden_rubber.hpp"

#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {

std::vector<double> OgdenRubberLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  std::vector<double> numbers(Count);
  numbers[Bulk] = law.youngs_modulus / (3 * (1 - 2 * law.poissons_ratio));
  numbers[PerDensity] = 1 / material.density;
  for (std::size_t n = 0; n < law.modulus.size(); ++n) {
    if (law.modulus[n] == 0) continue;
    numbers.insert(numbers.end(), {law.modulus[n], law.exponent[n]});
    numbers[Terms] += 1;
  }
  return numbers;
}

}  // namespace crumple::materials
