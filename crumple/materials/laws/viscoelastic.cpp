// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/viscoelastic.hpp"

#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {

void ViscoelasticLaw::declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block,
                                      Index /*tensor*/) {
  const auto& model = std::get<Model>(law);
  const Index shears = solid_components * static_cast<Index>(model.shear.size()) * block.points;
  const Index bulks = static_cast<Index>(model.bulk.size()) * block.points;
  domain::add_item(block, "relaxing_stress", "stress", shears);
  domain::add_item(block, "relaxing_stress_rest", "stress", shears);
  domain::add_item(block, "relaxing_mean", "stress", bulks);
  domain::add_item(block, "relaxing_mean_rest", "stress", bulks);
}

std::vector<double> ViscoelasticLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  constexpr auto most = static_cast<std::size_t>(most_parts);
  require(!law.shear.empty() && law.shear.size() <= most && !law.bulk.empty() && law.bulk.size() <= most,
          material, "shear and bulk modulus need one part at least, and at most 19");
  std::vector<double> numbers(Count);
  numbers[ShearParts] = static_cast<double>(law.shear.size());
  numbers[BulkParts] = static_cast<double>(law.bulk.size());
  for (const auto* parts : {&law.shear, &law.bulk})
    for (const model::Relaxation& part : *parts) {
      require(part.modulus >= 0 && part.decay >= 0, material,
              "moduli and decay constants of its relaxation must not be negative");
      numbers.insert(numbers.end(), {part.modulus, part.decay});
    }
  return numbers;
}

}  // namespace crumple::materials
