// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "domain/domain.hpp"
#include "elements/line/beam_task.hpp"
#include "elements/line/discrete_elements.hpp"
#include "elements/shell/shell_geometry.hpp"
#include "elements/shell/shell_setup.hpp"
#include "elements/shell/shell_task.hpp"
#include "elements/solid/solid_setup.hpp"
#include "elements/solid/solid_task.hpp"

namespace crumple::elements {

/// Calls visit(place, step) for every active element from `begin` to before `end` with its stable step in the
/// present geometry, at rest and without TSSFAC. Outside of the cycle.
template <class Visit>
void for_each_step(const domain::Domain& domain, const domain::ShellBlock& block, Index begin, Index end,
                   const Visit& visit) {
  const auto constants = from_numbers<ShellConstants<double>>(block.element_constants);
  for (Index place = begin; place < end; ++place) {
    if (block.state(place, constants.own + element_state::active) == 0) continue;
    const double length = characteristic_length(corners_of(domain, block.nodes_of(place)), false);
    visit(place, length * constants.slowness * block.state(place, constants.own + element_state::step_scale));
  }
}

template <class Visit>
void for_each_step(const domain::Domain& domain, const domain::SolidBlock& block, Index begin, Index end,
                   const Visit& visit) {
  const auto constants = from_numbers<SolidConstants<double>>(block.element_constants);
  for (Index place = begin; place < end; ++place) {
    if (block.state(place, constants.own + solid_state::active) == 0) continue;
    const SolidSize size = solid_size(domain, block, place, constants);
    const double speed = constants.present_wave_speed > 0 ? block.state(place, constants.present_wave_speed)
                                                          : constants.wave_speed;
    visit(place, size.length / speed * block.state(place, constants.own + solid_state::step_scale));
  }
}

template <class Visit>
void for_each_step(const domain::Domain& domain, const domain::BeamBlock& block, Index begin, Index end,
                   const Visit& visit) {
  for (Index place = begin; place < end; ++place) {
    if (block.state(place, beam_state::active) == 0) continue;
    const auto [first, second] = block.nodes_of(place);
    const double length = norm(domain.nodes.position[second] - domain.nodes.position[first]);
    const double shorter = std::min(1.0, length / block.state(place, beam_state::reference_length));
    visit(place, block.state(place, beam_state::stable_step) * shorter);
  }
}

template <class Visit>
void for_each_step(const domain::Domain& /*domain*/, const domain::DiscreteBlock& block, Index begin,
                   Index end, const Visit& visit) {
  for (Index place = begin; place < end; ++place)
    visit(place, block.state(place, discrete_state::stable_step));
}

}  // namespace crumple::elements
