// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "math/vec3.hpp"
#include "model/tied_contact.hpp"

namespace crumple::domain {

struct Domain;

/// A node that is joined to a segment.
struct TiedNode {
  Index node = no_index;           ///< domain node
  std::array<Index, 4> corner{};   ///< domain nodes of the segment; a triangle repeats its last
  std::array<double, 4> weight{};  ///< of the corners; their sum is 1
  double height = 0;               ///< over the segment, along its normal [length]
  double side = 1;                 ///< 1 or -1: the side of the normal on which the node is
  double area = 0;                 ///< share of the node in its own surface [length^2]
  double stiffness = 0;            ///< penalty stiffness [force/length]
  Index block = no_index;          ///< of the segment's element, in Domain::blocks()
  Index element = no_index;        ///< its place in the block
  UserId segment = 0;              ///< user's number of that element
  bool follows = false;            ///< the node follows the segment by constraint; else a spring holds it
  bool turns = false;              ///< it follows, and turns with the segment
};

/// A node that was to be tied and is too far away.
struct UntiedNode {
  UserId node = 0;
  double distance = 0;  ///< to the nearest segment [length]
};

/// A tied contact as it was found at time zero, and what became of it.
struct Tie {
  UserId id = 0;
  model::TieMethod method = model::TieMethod::Constraint;
  std::vector<TiedNode> nodes;      ///< ascending by node
  std::vector<std::int32_t> holds;  ///< by node: 1 while it is tied, 0 after that
  Index segments = 0;               ///< of the second side
  std::vector<UntiedNode> untied;   ///< furthest first
  Index tied_elsewhere = 0;         ///< nodes that an earlier contact has tied already
  double largest_move = 0;          ///< by which a node was put onto its segment [length]
  UserId moved_node = 0;            ///< where that was

  Index released = 0;  ///< nodes whose tie has ended
  Index broken = 0;    ///< of these, by their load
  math::Vec3 force;    ///< on the tied nodes, at time n [force]
  double energy = 0;   ///< stored in springs, and lost where ties ended [energy]
  /// Of that, what ties took that broke, softened or ended [energy].
  double dissipated = 0;
  double opening = 0;  ///< largest stretch of a spring now [length]

  std::string name() const { return "Tied contact " + std::to_string(id); }
  Index springs() const {
    return static_cast<Index>(
        std::count_if(nodes.begin(), nodes.end(), [](const TiedNode& tied) { return !tied.follows; }));
  }
};

/// Whether an element has eroded.
bool has_failed(const Domain& domain, Index block, Index element);

/// Elements of the model that have eroded.
Index eroded_elements(const Domain& domain);

}  // namespace crumple::domain
