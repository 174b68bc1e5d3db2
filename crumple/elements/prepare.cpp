// SPDX-License-Identifier: BSD-3-Clause
#include "elements/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "elements/elements.hpp"
#include "materials/common/shell_material.hpp"

namespace crumple::elements {

double mass_factor(double mass_scaling_step, double step) {
  if (mass_scaling_step == 0) return 1;
  const double ratio = std::fabs(mass_scaling_step) / step;
  return mass_scaling_step < 0 && ratio < 1 ? 1 : ratio * ratio;
}

void require(bool holds, const model::Part& part, const std::string& what) {
  if (!holds) throw Error("Part " + std::to_string(part.id) + ": " + what + ".");
}

namespace {

/// Rigid elements limit the step where all others have no stiffness: something has to.
void limit_by_rigid_elements(const model::Model& model, domain::Domain& domain) {
  for (const domain::ElementBlock* block : domain.blocks()) {
    const model::Part& part = model.parts[block->part];
    const bool spring = part.material == no_index;
    const bool fluid = part.equation_of_state != no_index;
    if (block->rigid) continue;
    if (spring || fluid || materials::has_stiffness(model.materials[part.material].law)) return;
  }
  const auto look = [&](const auto& block) {
    if (block.rigid)
      domain.clock.rigid_limit = std::min(domain.clock.rigid_limit, stable_step(domain, block));
  };
  for (const domain::ShellBlock& block : domain.shells) look(block);
  for (const domain::SolidBlock& block : domain.solids) look(block);
  for (const domain::BeamBlock& block : domain.beams) look(block);
}

}  // namespace

void prepare_elements(const model::Model& model, domain::Domain& domain) {
  prepare_shells(model, domain);
  prepare_solids(model, domain);
  prepare_beams(model, domain);
  prepare_discretes(model, domain);
  limit_by_rigid_elements(model, domain);
}

}  // namespace crumple::elements
