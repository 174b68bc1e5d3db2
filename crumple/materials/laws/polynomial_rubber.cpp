// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/polynomial_rubber.hpp"

#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {

std::vector<double> PolynomialRubberLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  std::vector<double> numbers(Count);
  numbers[Bulk] = law.youngs_modulus / (3 * (1 - 2 * law.poissons_ratio));
  numbers[PerDensity] = 1 / material.density;
  numbers[C10] = law.c10;
  numbers[C01] = law.c01;
  numbers[C11] = law.c11;
  numbers[C20] = law.c20;
  numbers[C02] = law.c02;
  numbers[C30] = law.c30;
  return numbers;
}

}  // namespace crumple::materials
