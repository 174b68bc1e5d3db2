// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// Finds for every coupling of beams with solids which nodes of the beams lie in which solids, into
/// domain.embeddings. A node counts as inside up to 0.01 beyond a solid in natural coordinates, of which the
/// solid is 2 wide; of several solids that contain it the first of the model gives the weights, and all hold
/// it. Nodes of the solids themselves are left out, and those that an earlier coupling has. The nodes lie in
/// a grid, so that the time goes with the number of solids. Throws Error for a coupling without any node in a
/// solid.
void find_embedded_beams(const model::Model& model, domain::Domain& domain);

}  // namespace crumple::constraints
