// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/index.hpp"
#include "math/vec3.hpp"

namespace crumple::contact {

/// A box along the axes, its faces included [length].
struct Box {
  math::Vec3 low;
  math::Vec3 high;

  bool overlaps(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y &&
           low.z <= other.high.z && other.low.z <= high.z;
  }
};

/// All pairs (lower first) of boxes that overlap, in an order that depends on the boxes alone. Their corners
/// must be finite. Each box is put into the cells of a hashed grid that it reaches (M. Teschner et al.,
/// Optimized spatial hashing for collision detection of deformable objects, VMV 2003), and a pair is found in
/// the one cell that has the low corner of what both share; a few that are much larger than the mean are
/// compared with all others instead. O(N) for the segments of a mesh.
std::vector<std::array<Index, 2>> overlapping_boxes(std::span<const Box> boxes, int threads);

}  // namespace crumple::contact
