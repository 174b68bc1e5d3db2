// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/mooney_rivlin.hpp"

#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {

std::vector<double> MooneyRivlinLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  const double a = law.first;
  const double b = law.second;
  const double nu = law.poissons_ratio;
  require(a + b > 0, material, "the sum of A and B must be above zero");
  require(nu > 0 && nu < 0.5, material, "Poisson's ratio must be above 0 and below 0.5");
  std::vector<double> numbers(Count);
  numbers[First] = a;
  numbers[Second] = b;
  numbers[Third] = 0.5 * a + b;
  numbers[Fourth] = (a * (5 * nu - 2) + b * (11 * nu - 5)) / (2 * (1 - 2 * nu));
  numbers[PerDensity] = 1 / material.density;
  return numbers;
}

}  // namespace crumple::materials
