// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model/model.hpp"

namespace crumple::deck {

/// Calls `visit(list)` with every list of loads and motions whose `curve` is over time, of a model or of a
/// relaxation.
template <class Phase, class Visit>
void for_each_list_of_phase(Phase& phase, const Visit& visit) {
  visit(phase.nodal_loads);
  visit(phase.pressure_loads);
  visit(phase.body_loads);
  visit(phase.inertia_fields);
  visit(phase.rigid_body_loads);
  visit(phase.prescribed_motions);
}

/// The same with those of the run and of its relaxation.
template <class Visit>
void for_each_timed_list(model::Model& model, const Visit& visit) {
  for_each_list_of_phase(model, visit);
  if (model.relaxation) for_each_list_of_phase(*model.relaxation, visit);
}

}  // namespace crumple::deck
