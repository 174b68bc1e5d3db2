// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/viscous_foam.hpp"

#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {

std::vector<double> ViscousFoamLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require(law.elastic_modulus > 0, material, "the modulus E1 must be above zero");
  require(law.elastic_exponent >= 0 && law.viscosity_exponent >= 0 && law.viscosity >= 0, material,
          "the viscosity V2 and the exponents N1 and N2 must not be negative");
  const double nu = law.poissons_ratio;
  std::vector<double> numbers(Count);
  numbers[Modulus] = law.elastic_modulus;
  numbers[Poisson] = nu;
  numbers[Exponent] = law.elastic_exponent;
  numbers[Viscosity] = law.viscosity;
  numbers[ViscosityExponent] = law.viscosity_exponent;
  numbers[LeastModulus] = law.youngs_modulus;
  numbers[Confined] = (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  numbers[PerDensity] = 1 / material.density;
  return numbers;
}

}  // namespace crumple::materials
