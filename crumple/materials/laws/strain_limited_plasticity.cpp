// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/strain_limited_plasticity.hpp"

#include "materials/common/checks.hpp"
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {

void StrainLimitedPlasticityLaw::declare_history(const model::ConstitutiveLaw& /*law*/,
                                                 domain::ElementBlock& block, Index /*tensor*/) {
  declare_plastic_strain(block);
  domain::add_item(block, "thickness_strain", "-", block.points);
  domain::add_item(block, "thickness_strain_rest", "-", block.points);
  domain::add_item(block, "failed", "-", block.points);
  domain::add_item(block, "plane_strain", "-", 3 * block.points);
  domain::add_item(block, "plane_strain_rest", "-", 3 * block.points);
}

std::vector<double> StrainLimitedPlasticityLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require(law.failure_thinning >= 0 && law.failure_major >= 0, material,
          "the limits of thinning and of the major strain must not be negative");
  require_failed_points(material, law);
  std::vector<double> numbers(Limits);
  numbers[Thinning] = law.failure_thinning;
  numbers[Major] = law.failure_major;
  numbers[Points] = law.failed_points;
  numbers[Share] = law.failed_share;
  const std::vector<double> rest = PiecewiseLinearPlasticityLaw::constants(material);
  numbers.insert(numbers.end(), rest.begin(), rest.end());
  return numbers;
}

}  // namespace crumple::materials
