// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "domain/state_list.hpp"
#include "domain/state_snapshot.hpp"

namespace crumple::timeloop {

/// Throws Error unless a state from a file can be put into a simulation that has not been started: lists that
/// have their length by the model keep it, those by node have all nodes or none, indices are of items that
/// exist, positions, velocities, masses and the clock are finite. A checksum shows damage, not intent. What
/// the contacts remember they check themselves when the run is resumed, with surfaces at hand
/// (contact/surface/saved_state.hpp); numbers of elements are only computed with.
void require_fitting_state(const domain::StateSnapshot& state, const domain::StateList& list,
                           const domain::Domain& domain);

}  // namespace crumple::timeloop
