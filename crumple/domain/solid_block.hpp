// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "domain/damped_block.hpp"
#include "model/section.hpp"

namespace crumple::domain {

/// Where a formulation averages over the elements around a node. Numbers nodes among those of the block.
struct NodalAverage {
  std::vector<Index> node;           ///< [element][4] of the block's elements
  std::vector<Index> first_element;  ///< per node, and one past the last: its run in `element`
  std::vector<Index> element;        ///< places in the block, ascending for each node
  std::vector<double> volume;        ///< per element at the middle of the step; 0 once it has failed
  std::vector<double> volume_rate;   ///< the same [length^3/time]
  std::vector<double> dilatation;    ///< per node: rate of the volume around it over that volume [1/time]
};

/// The solids of one part: one formulation and material. Its item "stress" is [point][xx, yy, zz, xy, yz, zx]
/// in global axes. Hexahedral formulations have eight corners, tetrahedral ones four or
/// ten, those in the middle of the sides behind.
struct SolidBlock : DampedBlock {
  model::SolidFormulation formulation = model::SolidFormulation::OnePointHexahedron;
  NodalAverage average;  ///< worked out anew in each cycle; empty if the formulation has none

  SolidBlock() { corner_by_corner = true; }

  /// The domain nodes at the corners of element `place`, as a list for hexahedra: a tetrahedron repeats its
  /// third and fourth.
  std::array<Index, 8> nodes_of(Index place) const {
    std::array<Index, 8> found{};
    for (std::size_t k = 0; k < 8; ++k) {
      constexpr std::array<Index, 8> of_tetrahedron{0, 1, 2, 2, 3, 3, 3, 3};
      found[k] = node_of(place, corners == 8 ? static_cast<Index>(k) : of_tetrahedron[k]);
    }
    return found;
  }

  /// The share of an element's mass that its node `corner` has. Where there are ten it is that of the volumes
  /// around them when the element is cut into eight tetrahedra.
  double mass_share(Index corner) const {
    if (corners == 10) return corner < 4 ? 1.0 / 32 : 7.0 / 48;
    return 1.0 / corners;
  }
};

}  // namespace crumple::domain
