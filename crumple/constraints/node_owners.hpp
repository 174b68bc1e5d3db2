// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace crumple::constraints {

/// What holds or moves the nodes of a model, by model node, in words: "rigid body 3"; empty for free ones.
/// Fixed degrees of freedom do not count.
struct NodeOwners {
  std::vector<std::string> body;   ///< what moves all of the node: a rigid body or a spot weld
  std::vector<std::string> joint;  ///< a rivet, a constrained set, an equation or a prescribed motion
};

NodeOwners owners_of_nodes(const model::Model& model);

}  // namespace crumple::constraints
