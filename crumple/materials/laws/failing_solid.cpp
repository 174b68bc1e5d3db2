// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/failing_solid.hpp"

#include "materials/common/checks.hpp"
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {

void FailingSolidLaw::declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                                      Index /*tensor*/) {
  declare_plastic_strain(block);
  domain::add_item(block, "failed", "-", block.points);
}

bool FailingSolidLaw::can_fail(const model::ConstitutiveLaw& law) {
  const auto& own = std::get<Model>(law);
  return !own.keeps_failed && (own.failure_strain > 0 || own.failure_pressure < 0);
}

std::vector<double> FailingSolidLaw::constants(const model::Material& material) {
  constexpr double unreachable = 1e30;
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require_failure_strain(material, law.failure_strain);
  require(law.yield_stress > 0, material, "the yield stress must be above zero");
  require(law.hardening >= 0, material, "the hardening modulus must not be negative");
  require(law.failure_pressure <= 0, material, "the failure pressure must not be above zero");
  std::vector<double> numbers(Count);
  numbers[Youngs] = law.youngs_modulus;
  numbers[Poissons] = law.poissons_ratio;
  numbers[Yield] = law.yield_stress;
  numbers[Hardening] = law.hardening;
  numbers[Failure] = law.failure_strain;
  numbers[Tension] = law.failure_pressure < 0 ? -law.failure_pressure : unreachable;
  numbers[Keeps] = law.keeps_failed ? 1 : 0;
  return numbers;
}

}  // namespace crumple::materials
