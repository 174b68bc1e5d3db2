// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/hydro_plasticity.hpp"

#include <algorithm>

#include "materials/common/checks.hpp"
#include "materials/plasticity/hardening_table.hpp"
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {
namespace {

/// What is below this share of G bears nothing.
constexpr double least_share = 1e-9;

void require_curve(const model::Material& material, const model::HydroPlasticity& law) {
  const auto& strain = law.plastic_strain;
  const auto& stress = law.yield_stress;
  if (stress.size() == 1 && stress[0] == 0) {  // strength by hardening and pressure alone
    require(strain.size() == 1 && strain[0] == 0, material,
            "the hardening must start at zero plastic strain");
    return;
  }
  require_hardening_table(material, law.youngs_modulus, strain, stress);
  const std::size_t last = stress.size() - 1;
  require(last == 0 || stress[last] >= stress[last - 1], material,
          "the hardening table must not fall at its end, whose slope goes on");
}

}  // namespace

void HydroPlasticityLaw::declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                                         Index /*tensor*/) {
  declare_plastic_strain(block);
}

std::vector<double> HydroPlasticityLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require(law.shear_modulus > 0, material, "the shear modulus G must be above zero");
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require_failure_strain(material, law.failure_strain);
  require_curve(material, law);
  require(law.hardening >= 0, material, "the hardening modulus EH must not be negative");
  std::vector<double> numbers(Table);
  // G exactly, whatever bulk modulus the equation of state has.
  numbers[Youngs] = 2 * law.shear_modulus * (1 + law.poissons_ratio);
  numbers[Poissons] = law.poissons_ratio;
  numbers[PressureFactor] = law.pressure_factor;
  numbers[PressureSquare] = law.pressure_square;
  numbers[Failure] = law.failure_strain;
  numbers[Least] = *std::min_element(law.yield_stress.begin(), law.yield_stress.end());
  numbers[Floor] = least_share * law.shear_modulus;
  numbers[Rows] = static_cast<double>(law.plastic_strain.size());
  append_table(law.plastic_strain, law.yield_stress, true, numbers);
  if (law.plastic_strain.size() == 1) numbers.back() = law.hardening;
  return numbers;
}

}  // namespace crumple::materials
