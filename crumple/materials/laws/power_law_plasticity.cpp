// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/power_law_plasticity.hpp"

#include <cmath>

#include "materials/common/checks.hpp"
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {

void PowerLawPlasticityLaw::declare_history(const model::ConstitutiveLaw& /*law*/,
                                            domain::ElementBlock& block, Index /*tensor*/) {
  declare_plastic_strain(block);
}

std::vector<double> PowerLawPlasticityLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require_cowper_symonds(material, law.cowper_symonds_rate, law.cowper_symonds_exponent);
  require_failure_strain(material, law.failure_strain);
  require(law.strength > 0, material, "the strength coefficient k must be above zero");
  require(law.exponent >= 0 && law.exponent <= 1, material,
          "the hardening exponent n must lie between 0 and 1");
  require(law.yield_strain > 0 && law.yield_strain < 1, material,
          "the elastic strain at yield must be above 0 and below 1");
  return {law.youngs_modulus,
          law.poissons_ratio,
          law.strength,
          law.exponent,
          law.yield_strain,
          law.strength * std::pow(law.yield_strain, law.exponent),
          law.cowper_symonds_rate,
          law.cowper_symonds_exponent,
          law.failure_strain};
}

}  // namespace crumple::materials
