// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "math/vec3.hpp"

namespace crumple::domain {

/// A solid, by its block in Domain::blocks() and its place there.
struct SolidPlace {
  Index block = no_index;
  Index element = no_index;
};

/// A node of a beam that lies in a solid.
struct EmbeddedNode {
  Index node = no_index;           ///< domain node
  std::array<Index, 8> corner{};   ///< domain nodes of the solid that have a weight
  std::array<double, 8> weight{};  ///< their shape functions at the node; the sum is 1
  Index corners = 0;               ///< how many they are
  std::vector<SolidPlace> hosts;   ///< the solids that contain it: several, on their common face or edge
};

/// Beams inside solids as they were found at time zero, and what became of them.
struct Embedding {
  UserId id = 0;
  std::vector<EmbeddedNode> nodes;  ///< ascending by node of the model
  std::vector<std::int32_t> holds;  ///< by node: 1 while it moves with its solid, 0 after that
  std::vector<UserId> outside;      ///< nodes of the beams that lie in no solid, ascending
  std::vector<UserId> long_beams;   ///< those that pass through solids between their nodes, ascending
  Index shared = 0;                 ///< nodes of the beams that are nodes of the solids, too
  Index elsewhere = 0;              ///< nodes that an earlier coupling has already

  Index released = 0;  ///< nodes that no solid holds any longer
  math::Vec3 force;    ///< on the nodes of the beams, at time n [force]
  double lost = 0;     ///< of the relative motion that these had when they were released [energy]

  std::string name() const { return "Coupling of beams " + std::to_string(id); }
};

}  // namespace crumple::domain
