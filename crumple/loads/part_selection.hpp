// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::loads {

/// Nodes with the part of their mass that a load or a damping acts on.
struct NodeShares {
  std::vector<Index> nodes;   ///< domain nodes, ascending
  std::vector<double> share;  ///< of the mass of each [-]
};

/// The nodes of some parts of the model, each with the share of their elements.
NodeShares shares_of_parts(const domain::Domain& domain, const std::vector<Index>& parts);

/// Whether a rigid body has one of the parts.
bool has_part(const model::RigidBody& body, const std::vector<Index>& parts);

}  // namespace crumple::loads
