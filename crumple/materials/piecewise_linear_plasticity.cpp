// SPDX-License-Identifier: BSD-3-Clause
#include "materials/piecewise_linear_plasticity.hpp"

#include <algorithm>

#include "materials/checks.hpp"

namespace crumple::materials {

void PiecewiseLinearPlasticityLaw::declare_history(const model::ConstitutiveLaw& /*law*/,
                                                   domain::ShellBlock& block) {
  domain::add_item(block, "plastic_strain", "-", block.points());
}

std::vector<double> PiecewiseLinearPlasticityLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require_cowper_symonds(material, law.cowper_symonds_rate, law.cowper_symonds_exponent);
  require_failure_strain(material, law.failure_strain);
  const std::vector<double>& strain = law.plastic_strain;
  const std::vector<double>& stress = law.yield_stress;
  require(!strain.empty() && strain.size() == stress.size(), material,
          "the hardening table needs as many yield stresses as plastic strains, and at least one");
  require(strain.front() == 0, material, "the hardening table must start at zero plastic strain");
  const double least = *std::min_element(stress.begin(), stress.end());
  require(least > 0, material, "every yield stress of the hardening table must be above zero");

  std::vector<double> numbers{law.youngs_modulus,
                              law.poissons_ratio,
                              law.cowper_symonds_rate,
                              law.cowper_symonds_exponent,
                              law.failure_strain,
                              least,
                              static_cast<double>(strain.size())};
  for (std::size_t k = 0; k < strain.size(); ++k) {
    double slope = 0;
    if (k + 1 < strain.size()) {
      require(strain[k + 1] > strain[k], material, "the plastic strains of the hardening table must ascend");
      slope = (stress[k + 1] - stress[k]) / (strain[k + 1] - strain[k]);
    }
    // Softening as steep as the elastic unloading has no stable answer.
    require(slope > -0.25 * law.youngs_modulus, material,
            "the hardening table falls more steeply than a quarter of Young's modulus");
    numbers.insert(numbers.end(), {strain[k], stress[k], slope});
  }
  return numbers;
}

}  // namespace crumple::materials
