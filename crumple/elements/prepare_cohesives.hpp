// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::elements {

/// Sets what the elements of a block of cohesive solids keep, and adds their mass to their nodes. Throws
/// Error naming the solid if it has no area or is inside out.
void prepare_cohesives(const model::Model& model, domain::Domain& domain, domain::SolidBlock& block);

/// Sets the stable steps of all cohesive solids, once all nodes have their mass and all other elements their
/// steps: docs/theory/cohesive_solids.md. Throws Error naming the node that has no mass.
void set_cohesive_steps(const model::Model& model, domain::Domain& domain);

}  // namespace crumple::elements
