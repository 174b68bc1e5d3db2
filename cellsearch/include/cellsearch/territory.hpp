// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cellsearch/box.hpp"
#include "cellsearch/scene.hpp"

namespace cellsearch {

/// The territory of a segment, eq. (7)-(9) of the paper: the bounding box of its nodes, expanded by c on all
/// sides [length]. Every method takes its territories from here, so that all agree to the last bit.
inline Box territory(const Scene& scene, Index segment) {
  const Index* nodes = scene.segments[segment];
  Box box;
  for (int corner = 0; corner < 4; ++corner) box.include(scene.positions[nodes[corner]]);
  return box.expanded(scene.expansion_of(segment));
}

}  // namespace cellsearch
