// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "model/mesh.hpp"

namespace crumple::model {

/// The faces of a solid that have an area: four nodes counter-clockwise seen from outside, a triangle repeats
/// its third. In the order bottom (nodes 1 to 4), top, sides; wedges, pyramids and tetrahedra have fewer than
/// six.
std::vector<std::array<Index, 4>> faces_of(const SolidElement& solid);

/// The same for all faces with these nodes, whichever they begin with.
std::array<Index, 4> key_of(std::array<Index, 4> face);

/// A face and the solid that it bounds.
struct OuterFace {
  std::array<Index, 4> node{};
  Index solid = no_index;
};

/// Faces of some solids that no two of them share: their surface, in the order of the solids and of their
/// faces. O(N log N).
std::vector<OuterFace> outer_faces(const std::vector<SolidElement>& solids, const std::vector<Index>& some);

}  // namespace crumple::model
