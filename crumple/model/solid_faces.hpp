// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "model/mesh.hpp"

namespace crumple::model {

/// The faces of a solid that have an area: four nodes counter-clockwise seen from outside, a triangle repeats
/// its third. In the order bottom (nodes 1 to 4), top, sides; wedges, pyramids and tetrahedra have fewer than
/// six. The four of a tetrahedron with ten nodes are four flat triangles each.
std::vector<std::array<Index, 4>> faces_of(const SolidElement& solid);

/// The same for all faces with these nodes, whichever they begin with.
std::array<Index, 4> key_of(std::array<Index, 4> face);

/// A face of a solid.
struct SolidFace {
  std::array<Index, 4> node{};
  Index solid = no_index;
  Index neighbour = no_index;  ///< the solid on the other side
};

/// All faces of some solids, in the order of the solids and of their faces; those that two of them share
/// appear for each. O(N log N).
std::vector<SolidFace> all_faces(const std::vector<SolidElement>& solids, const std::vector<Index>& some);

/// Of these the ones without neighbour: the surface of the solids.
std::vector<SolidFace> outer_faces(const std::vector<SolidElement>& solids, const std::vector<Index>& some);

}  // namespace crumple::model
