// SPDX-License-Identifier: BSD-3-Clause
// Stable steps outside of the cycle, for reports.
#include <algorithm>
#include <cmath>

#include "elements/elements.hpp"
#include "elements/line/beam_task.hpp"
#include "elements/line/discrete_elements.hpp"
#include "elements/shell/shell_geometry.hpp"
#include "elements/shell/shell_setup.hpp"
#include "elements/shell/shell_task.hpp"
#include "elements/solid/solid_setup.hpp"
#include "elements/solid/solid_task.hpp"

namespace crumple::elements {
namespace {

using domain::Domain;

/// Visits every active element with its present stable step.
template <class Visit>
void for_each_step(const Domain& domain, const domain::ShellBlock& block, const Visit& visit) {
  const auto constants = from_numbers<ShellConstants<double>>(block.element_constants);
  for (Index place = 0; place < block.elements; ++place) {
    if (block.state(place, constants.own + element_state::active) == 0) continue;
    const double length = characteristic_length(corners_of(domain, block.nodes_of(place)), false);
    visit(place, length * constants.slowness * block.state(place, constants.own + element_state::step_scale));
  }
}
template <class Visit>
void for_each_step(const Domain& domain, const domain::SolidBlock& block, const Visit& visit) {
  const auto constants = from_numbers<SolidConstants<double>>(block.element_constants);
  for (Index place = 0; place < block.elements; ++place) {
    if (block.state(place, constants.own + solid_state::active) == 0) continue;
    const SolidSize size = solid_size(domain, block, place, constants);
    const double speed = constants.present_wave_speed > 0 ? block.state(place, constants.present_wave_speed)
                                                          : constants.wave_speed;
    visit(place, size.length / speed * block.state(place, constants.own + solid_state::step_scale));
  }
}

/// Longer than any step.
constexpr double no_limit = 1e30;

template <class Visit>
void for_each_step(const Domain& domain, const domain::BeamBlock& block, const Visit& visit) {
  for (Index place = 0; place < block.elements; ++place) {
    if (block.state(place, beam_state::active) == 0) continue;
    if (block.formulation == model::BeamFormulation::Discrete) {
      visit(place, block.state(place, beam_state::stable_step));
      continue;
    }
    const auto [first, second] = block.nodes_of(place);
    const double length = norm(domain.nodes.position[second] - domain.nodes.position[first]);
    const double stretch = length / block.state(place, beam_state::reference_length);
    // The transverse shear of integrated beams grows stiffer with their length: see integrated_beam.hpp.
    const double longest =
        block.formulation == model::BeamFormulation::Integrated ? std::sqrt(1 / stretch) : 1;
    visit(place, block.state(place, beam_state::stable_step) * std::min({1.0, stretch, longest}));
  }
}
template <class Visit>
void for_each_step(const Domain& /*domain*/, const domain::DiscreteBlock& block, const Visit& visit) {
  for (Index place = 0; place < block.elements; ++place)
    visit(place, block.state(place, discrete_state::stable_step));
}

template <class Block>
double shortest_step(const Domain& domain, const Block& block) {
  double shortest = no_limit;
  for_each_step(domain, block, [&](Index, double step) { shortest = std::min(shortest, step); });
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
    for_each_step(domain, block, [&](Index place, double step) {
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
