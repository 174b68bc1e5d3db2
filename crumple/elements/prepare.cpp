// SPDX-License-Identifier: BSD-3-Clause
#include "elements/prepare.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "elements/elements.hpp"

namespace crumple::elements {

double mass_factor(double mass_scaling_step, double step) {
  if (mass_scaling_step == 0) return 1;
  const double ratio = std::fabs(mass_scaling_step) / step;
  return mass_scaling_step < 0 && ratio < 1 ? 1 : ratio * ratio;
}

void require(bool holds, const model::Part& part, const std::string& what) {
  if (!holds) throw Error("Part " + std::to_string(part.id) + ": " + what + ".");
}

void prepare_elements(const model::Model& model, domain::Domain& domain) {
  prepare_shells(model, domain);
  prepare_solids(model, domain);
}

}  // namespace crumple::elements
