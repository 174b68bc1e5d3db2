// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// What was done to a mesh that overlapped.
struct MovedApart {
  Index nodes = 0;      ///< nodes that were moved
  double farthest = 0;  ///< by how much at most [length]
  UserId farthest_node = 0;
  double left = 0;  ///< deepest overlap that is left [length]
};

/// Moves nodes of the undeformed mesh so that no contact of the model overlaps at the start, as little as is
/// possible in the mean of squares. Nodes that are fixed or of rigid bodies stay where
/// they are. Overlaps beyond what the search looks at, and those that cannot be undone, are left.
MovedApart move_apart(model::Model& model, const domain::Execution& execution);

}  // namespace crumple::contact
