// SPDX-License-Identifier: BSD-3-Clause
// Stable steps outside of the cycle, for reports.
#include "elements/stable_steps.hpp"

#include <algorithm>

#include "elements/common/stiffness_damping.hpp"
#include "elements/elements.hpp"

namespace crumple::elements {
namespace {

using domain::Domain;

/// Longer than any step.
constexpr double no_limit = 1e30;

/// The steps of all elements, with damping.
template <class Block, class Visit>
void for_each_damped_step(const Domain& domain, const Block& block, const Visit& visit) {
  for_each_step(domain, block, 0, block.elements, [&](Index place, double step) {
    if constexpr (requires { block.damping; })
      if (block.damping) step *= damped_share(*block.damping, step);
    visit(place, step);
  });
}

template <class Block>
double shortest_step(const Domain& domain, const Block& block) {
  double shortest = no_limit;
  for_each_damped_step(domain, block, [&](Index, double step) { shortest = std::min(shortest, step); });
  return shortest;
}

}  // namespace

double stable_step(const Domain& domain, const domain::ShellBlock& block) {
  return shortest_step(domain, block);
}
double stable_step(const Domain& domain, const domain::SolidBlock& block) {
  return shortest_step(domain, block);
}
double stable_step(const Domain& domain, const domain::BeamBlock& block) {
  return shortest_step(domain, block);
}
double stable_step(const Domain& domain, const domain::DiscreteBlock& block) {
  return shortest_step(domain, block);
}

double solid_volume(const Domain& domain, const domain::SolidBlock& block, Index place) {
  return solid_size(domain, block, place, from_numbers<SolidConstants<double>>(block.element_constants))
      .volume;
}

domain::ControllingElement controlling_element(const model::Model& model, const Domain& domain) {
  domain::ControllingElement found;
  double shortest = no_limit;
  const auto look = [&](const auto& block, const char* kind, const auto& elements) {
    if (block.rigid && domain.clock.rigid_limit == no_limit) return;
    for_each_damped_step(domain, block, [&](Index place, double step) {
      if (step >= shortest) return;
      shortest = step;
      found = {kind, elements[block.element[place]].id, model.parts[block.part].id};
    });
  };
  for (const domain::ShellBlock& block : domain.shells) look(block, "shell", model.shells);
  for (const domain::SolidBlock& block : domain.solids) look(block, "solid", model.solids);
  for (const domain::BeamBlock& block : domain.beams) look(block, "beam", model.beams);
  for (const domain::DiscreteBlock& block : domain.discretes)
    look(block, "discrete element", model.discretes);
  return found;
}

}  // namespace crumple::elements
