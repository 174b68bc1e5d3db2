// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "base/index.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// A node that follows a segment, or the solid that it lies in.
struct TieLink {
  static constexpr std::size_t of_segment = 4;  ///< corners; a triangle repeats its last

  Index node = no_index;             ///< in TieLinks::members
  std::array<Index, 8> corner{};     ///< likewise
  std::array<double, 8> weight{};    ///< their sum is 1
  std::size_t corners = of_segment;  ///< how many there are
  double height = 0;                 ///< over the segment, along its normal [length]
  bool embedded = false;             ///< the node lies in a solid
  Index tie = no_index;              ///< in domain.ties, or if embedded in domain.embeddings
  Index at = no_index;               ///< in Tie::nodes or Embedding::nodes
  Index level = 0;                   ///< 0: its corners are tied to nothing, else one more than theirs
  bool rotates = false;              ///< the node turns with the segment
  bool turns_on_face = false;        ///< the segment turns as its corners move: they have no rotations
  Index block = no_index;            ///< of the segment's element
  Index element = no_index;
};

struct TieLinks {
  std::vector<TieLink> links;  ///< those whose nodes carry nothing first
  std::vector<Index> members;  ///< domain nodes that take part, ascending
};

/// Which nodes of domain.ties follow their segments: all of ties by constraint, and of ties with a gap
/// (TieMethod::Offset) those whom nothing else holds or moves, on segments without rigid bodies. Sets
/// TiedNode::follows; springs hold the others. The nodes of domain.embeddings follow their solids. Throws
/// Error for a node of a tie by constraint or of an embedding that something else holds, naming both.
TieLinks find_tie_links(const model::Model& model, domain::Domain& domain);

}  // namespace crumple::constraints
