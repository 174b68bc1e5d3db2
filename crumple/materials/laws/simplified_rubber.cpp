// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/simplified_rubber.hpp"

#include <algorithm>
#include <cmath>

#include "materials/common/checks.hpp"

namespace crumple::materials {

namespace {

/// Stretch times the nominal stress of the test.
double test_force(const model::SimplifiedRubber& law, double stretch) {
  const auto above = std::upper_bound(law.stretch.begin() + 1, law.stretch.end() - 1, stretch);
  const auto k = static_cast<std::size_t>(above - law.stretch.begin()) - 1;
  const double slope = (law.stress[k + 1] - law.stress[k]) / (law.stretch[k + 1] - law.stretch[k]);
  return stretch * (law.stress[k] + slope * (stretch - law.stretch[k]));
}

/// f(l) = sum over k of l^e s(l^e) with e = (-nu)^k, the solution of f(l) - f(l^-nu) = l s(l).
double series(const model::SimplifiedRubber& law, double log_strain, double poisson) {
  constexpr double per_log = 1.4426950408889634;
  double sum = 0;
  double exponent = 1;
  while (std::fabs(exponent) > 1e-18) {
    sum += test_force(law, math::power_of_two(exponent * log_strain * per_log));
    exponent *= -poisson;
  }
  return sum;
}

}  // namespace

std::vector<double> SimplifiedRubberLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require(law.stretch.size() >= 3 && law.stress.size() == law.stretch.size(), material,
          "the curve of the test needs three points at least");
  for (std::size_t k = 0; k + 1 < law.stretch.size(); ++k)
    require(law.stretch[k + 1] > law.stretch[k], material, "the stretches of the test must ascend");
  require(law.stretch.front() > 0 && law.stretch.front() < 1 && law.stretch.back() > 1, material,
          "the curve of the test must have compression and tension");
  require(law.is_foam ? law.poissons_ratio > 0 : law.bulk_modulus > 0, material,
          "a foam needs Poisson's ratio, a rubber its bulk modulus above zero");
  std::vector<double> numbers(Count);
  numbers[Foam] = law.is_foam ? 1 : 0;
  numbers[Lateral] = law.is_foam ? law.poissons_ratio / (1 - 2 * law.poissons_ratio) : 0;
  numbers[Bulk] = law.bulk_modulus;
  numbers[PerDensity] = 1 / material.density;
  numbers[Points] = 2 * half_points + 1;
  for (int k = -half_points; k <= half_points; ++k)
    numbers.push_back(series(law, range * k / half_points, law.is_foam ? law.poissons_ratio : 0.5));
  return numbers;
}

}  // namespace crumple::materials
