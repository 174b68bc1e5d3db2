// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/plasticity_with_damage.hpp"

#include <algorithm>

#include "materials/common/checks.hpp"
#include "materials/common/shell_material.hpp"
#include "materials/plasticity/hardening_table.hpp"
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {

void PlasticityWithDamageLaw::declare_history(const model::ConstitutiveLaw& /*law*/,
                                              domain::ElementBlock& block, Index tensor) {
  declare_plastic_strain(block);
  if (tensor == components) domain::add_item(block, "failed", "-", block.points);
}

std::vector<double> PlasticityWithDamageLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require(law.damage.size() == law.damage_strain.size() && ascending(law.damage_strain) &&
              law.damage_strain.front() == 0,
          material, "the damage needs as many values as plastic strains, which ascend from zero");
  require(std::is_sorted(law.damage.begin(), law.damage.end()) && law.damage.front() >= 0 &&
              law.damage.back() <= 1,
          material, "the damage must not fall over the plastic strain, and lie between 0 and 1");
  require_failed_points(material, law);
  std::vector<double> numbers(Table);
  numbers[FailedPoints] = law.failed_points;
  numbers[FailedShare] = law.failed_share;
  numbers[DamageRows] = static_cast<double>(law.damage.size());
  append_table(law.damage_strain, law.damage, false, numbers);
  const std::vector<double> rest = PiecewiseLinearPlasticityLaw::constants(material);
  numbers.insert(numbers.end(), rest.begin(), rest.end());
  return numbers;
}

}  // namespace crumple::materials
