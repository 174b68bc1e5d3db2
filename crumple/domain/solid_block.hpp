// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "domain/element_block.hpp"
#include "model/section.hpp"

namespace crumple::domain {

/// The solids of one part: one formulation and material. Its item "stress" is [point][xx, yy, zz, xy, yz, zx]
/// in global axes.
struct SolidBlock : ElementBlock {
  model::SolidFormulation formulation = model::SolidFormulation::OnePointHexahedron;

  SolidBlock() { corners = 8; }

  /// The domain nodes of element `place`.
  std::array<Index, 8> nodes_of(Index place) const {
    std::array<Index, 8> found{};
    for (Index k = 0; k < 8; ++k) found[static_cast<std::size_t>(k)] = node_of(place, k);
    return found;
  }
};

}  // namespace crumple::domain
