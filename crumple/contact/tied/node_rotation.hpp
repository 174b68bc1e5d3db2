// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"

namespace crumple::contact {

/// The rigid body that a node belongs to, or no_index.
inline Index body_of(const domain::Domain& domain, Index node) {
  return domain.body_of_node.empty() ? no_index : domain.body_of_node[node];
}

/// True if a node turns: one of shells or beams, or of a rigid body, with which it turns.
inline bool has_rotation(const domain::Domain& domain, Index node) {
  return domain.nodes.inertia[node] > 0 || body_of(domain, node) != no_index;
}

}  // namespace crumple::contact
