// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/bulk_modulus.hpp"

#include <algorithm>
#include <variant>

#include "contact/tolerances.hpp"

namespace crumple::contact {

double bulk_modulus(const model::Model& model, const model::Part& part) {
  const model::Material& material = model.materials[part.material];
  if (const auto* equation = model::equation_of_state_of(model, part))
    return model::initial_bulk_modulus(*equation, material.density);
  return std::visit(
      [](const auto& law) {
        const double compressibility =
            std::max(1.0 - 2.0 * law.poissons_ratio, tolerances::smallest_compressibility);
        return law.youngs_modulus / (3.0 * compressibility);
      },
      material.law);
}

}  // namespace crumple::contact
