// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"

namespace crumple::elements {

/// Mass scaling during the run: DT2MS < 0 with MS1ST = 0 (LS-DYNA Keyword User's Manual, Vol. I,
/// *CONTROL_TIMESTEP). Elements whose stable step has fallen below clock.kept_step get mass until it is a
/// little longer than that again, in proportion at all their nodes, so that the bound on the frequencies of
/// the model by those of its elements holds. Mass is never taken away.
///
/// To be called after add_element_forces(), whose group_step it reads; brings clock.element_limit up to
/// date. Nodes keep their velocities: what the new mass moves with is booked as external work, as if no node
/// were tied. Nodes of rigid bodies add to the mass of their body, and to its inertia about every axis.
void keep_step(domain::Domain& domain);

}  // namespace crumple::elements
