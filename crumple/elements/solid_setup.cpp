// SPDX-License-Identifier: BSD-3-Clause
#include "elements/solid_setup.hpp"

#include "elements/solid_geometry.hpp"

namespace crumple::elements {

SolidSize solid_size(const domain::Domain& domain, const std::array<Index, 8>& node, bool exact_volume) {
  SolidPatterns<double> x;
  for (int axis = 0; axis < 3; ++axis) {
    double values[8];
    for (std::size_t k = 0; k < 8; ++k) values[k] = domain.nodes.position[node[k]][axis];
    const PatternItems<double> items = pattern_items<double>(values);
    for (int p = 0; p < pattern::count; ++p)
      (axis == 0 ? x.of[p].x : axis == 1 ? x.of[p].y : x.of[p].z) = items.of[p];
  }
  const double volume = solid_geometry(x, exact_volume).volume;
  return {volume, volume / square_root(largest_face_squared(x))};
}

}  // namespace crumple::elements
