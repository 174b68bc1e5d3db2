// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/plastic_kinematic.hpp"

#include "materials/common/checks.hpp"
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {

void PlasticKinematicLaw::declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block,
                                          Index tensor) {
  declare_plastic_strain(block);
  const auto& own = std::get<Model>(law);
  if (own.tangent_modulus != 0 && own.isotropic_fraction < 1)
    domain::add_item(block, "back_stress", "stress", tensor * block.points);
}

std::vector<double> PlasticKinematicLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require(law.yield_stress > 0, material, "the yield stress must be above zero");
  require(law.tangent_modulus >= 0 && law.tangent_modulus < law.youngs_modulus, material,
          "the tangent modulus must not be negative and must be below Young's modulus");
  require(law.isotropic_fraction >= 0 && law.isotropic_fraction <= 1, material,
          "the hardening parameter beta must lie between 0 (kinematic) and 1 (isotropic)");
  require_cowper_symonds(material, law.cowper_symonds_rate, law.cowper_symonds_exponent);
  require_failure_strain(material, law.failure_strain);
  const double plastic_modulus =
      law.youngs_modulus * law.tangent_modulus / (law.youngs_modulus - law.tangent_modulus);
  return {law.youngs_modulus,
          law.poissons_ratio,
          law.yield_stress,
          law.isotropic_fraction * plastic_modulus,
          (1 - law.isotropic_fraction) * plastic_modulus,
          law.cowper_symonds_rate,
          law.cowper_symonds_exponent,
          law.failure_strain};
}

}  // namespace crumple::materials
