// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"

namespace crumple::contact {

/// The longest step in which no two nodes of the contact move further relative to each other, with the
/// velocities that they have, than a fifth of the mean edge; infinite where nothing moves [time]. Elements
/// bound the step by their own waves, whatever the speed at which bodies meet: beyond about a fifth of the
/// speed of sound a node could be through a shell and far behind it within one step. Cheap while all is
/// slower: velocities are read only when the way of the last step does not exclude that the bound counts at
/// `step`.
double longest_step_for_motion(const Surface& surface, const domain::Domain& domain, double step);

}  // namespace crumple::contact
