// SPDX-License-Identifier: BSD-3-Clause
#include "materials/null.hpp"

#include <variant>

#include "materials/checks.hpp"

namespace crumple::materials {

std::vector<double> NullLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  return {0};
}

}  // namespace crumple::materials
