// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "domain/damped_block.hpp"
#include "model/section.hpp"

namespace crumple::domain {

/// The beams or trusses of one part. Their state is in double in both precisions: the rotations of two
/// elements at a node must not drift apart.
struct BeamBlock : DampedBlock {
  model::BeamFormulation formulation = model::BeamFormulation::BelytschkoSchwer;

  BeamBlock() { corners = 2; }

  /// The domain nodes of element `place`.
  std::array<Index, 2> nodes_of(Index place) const { return {node_of(place, 0), node_of(place, 1)}; }
};

/// The springs and dampers of one part; state in double as well. Where the second end is held both nodes are
/// the same.
struct DiscreteBlock : ElementBlock {
  bool torsional = false;

  DiscreteBlock() { corners = 2; }

  /// The domain nodes of element `place`.
  std::array<Index, 2> nodes_of(Index place) const { return {node_of(place, 0), node_of(place, 1)}; }
};

}  // namespace crumple::domain
