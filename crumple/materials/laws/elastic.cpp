// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/elastic.hpp"

#include "materials/common/checks.hpp"

namespace crumple::materials {

std::vector<double> ElasticLaw::constants(const model::Material& material) {
  const auto& law = std::get<model::Elastic>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  return {law.youngs_modulus, law.poissons_ratio};
}

}  // namespace crumple::materials
