// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/crushable_foam.hpp"

#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {

std::vector<double> CrushableFoamLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require(law.tensile_stress >= 0, material, "the tensile stress must not be negative");
  const std::size_t points = law.crush.size();
  require(points > 0 && law.yield_stress.size() == points, material,
          "the yield stress over the volumetric strain must have points");
  std::vector<double> numbers{law.youngs_modulus, law.tensile_stress, static_cast<double>(points)};
  numbers.reserve(Count + 3 * points);
  double slope = 0;
  for (std::size_t k = 0; k < points; ++k) {
    require(law.yield_stress[k] >= 0, material, "the yield stress must not be negative");
    if (k + 1 < points) {
      require(law.crush[k + 1] > law.crush[k], material, "the volumetric strains must ascend");
      slope = (law.yield_stress[k + 1] - law.yield_stress[k]) / (law.crush[k + 1] - law.crush[k]);
    }
    numbers.insert(numbers.end(), {law.crush[k], law.yield_stress[k], slope});
  }
  return numbers;
}

}  // namespace crumple::materials
