// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/johnson_cook.hpp"

#include <algorithm>
#include <variant>

#include "materials/common/checks.hpp"
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {
namespace {

constexpr double never = 1e15;

/// The yield stress depends on a temperature that rises with plastic work.
bool softens(const model::JohnsonCook& law) {
  return law.thermal_exponent > 0 && law.heat_capacity > 0 && law.melting_rise > 0;
}

bool damages(const model::JohnsonCook& law) {
  return std::any_of(law.damage.begin(), law.damage.end(), [](double d) { return d != 0; });
}

}  // namespace

const char* JohnsonCookLaw::name_of(const model::ConstitutiveLaw& law) {
  return std::get<Model>(law).simplified ? "simplified Johnson-Cook" : name;
}

bool JohnsonCookLaw::can_fail(const model::ConstitutiveLaw& law) {
  const auto& own = std::get<Model>(law);
  return own.failure_strain > 0 || damages(own);
}

void JohnsonCookLaw::declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block,
                                     Index /*tensor*/) {
  const auto& own = std::get<Model>(law);
  declare_plastic_strain(block);
  if (softens(own)) domain::add_item(block, "temperature_rise", "temperature", block.points);
  if (damages(own)) domain::add_item(block, "damage", "-", block.points);
}

std::vector<double> JohnsonCookLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require_failure_strain(material, law.failure_strain);
  require(law.yield_stress > 0, material, "the yield stress A must be above zero");
  require(law.hardening >= 0, material, "the hardening coefficient B must not be negative");
  require(law.hardening == 0 || law.exponent > 0, material, "the hardening exponent n must be above 0");
  require(law.rate_coefficient >= 0, material, "the rate coefficient C must not be negative");
  require(law.reference_rate > 0, material, "the reference strain rate must be above zero");
  require(law.largest_hardened == 0 || law.largest_hardened >= law.yield_stress, material,
          "the largest hardened stress must not be below the yield stress A");
  require(law.saturation_stress == 0 || law.saturation_stress >= law.yield_stress, material,
          "the saturation stress must not be below the yield stress A");
  require(!law.viscoplastic || (law.largest_hardened == 0 && law.saturation_stress == 0), material,
          "bounds of the stress cannot be combined with the viscoplastic form");
  require(!damages(law) || law.least_fracture_strain > 0, material,
          "the lower bound of the fracture strain must be above zero");

  std::vector<double> numbers(Count);
  numbers[Youngs] = law.youngs_modulus;
  numbers[Poissons] = law.poissons_ratio;
  numbers[Initial] = law.yield_stress;
  numbers[Modulus] = law.hardening;
  numbers[Exponent] = law.hardening > 0 ? law.exponent : 1;
  numbers[Largest] = law.largest_hardened > 0 ? law.largest_hardened : never;
  numbers[Saturation] = law.saturation_stress > 0 ? law.saturation_stress : never;
  numbers[RateCoefficient] = law.rate_coefficient;
  numbers[ReferenceRate] = law.reference_rate;
  // By the rate of the plastic strain, for which the return solves (cowper_symonds.hpp), but where bounds
  // follow from the factor before the return.
  numbers[Viscoplastic] = law.largest_hardened > 0 || law.saturation_stress > 0 ? 0 : 1;
  numbers[Failure] = law.failure_strain;
  numbers[ThermalExponent] = law.thermal_exponent;
  numbers[Softens] = softens(law) ? 1 : 0;
  numbers[PerMelting] = softens(law) ? 1 / law.melting_rise : 0;
  numbers[RisePerWork] = softens(law) ? 1 / (material.density * law.heat_capacity) : 0;
  numbers[Damages] = damages(law) ? 1 : 0;
  std::copy(law.damage.begin(), law.damage.end(), numbers.begin() + D1);
  numbers[LeastFracture] = law.least_fracture_strain;
  return numbers;
}

}  // namespace crumple::materials
