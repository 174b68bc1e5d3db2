// SPDX-License-Identifier: BSD-3-Clause
#include "elements/solid_setup.hpp"

#include "elements/solid_geometry.hpp"

namespace crumple::elements {

SolidPatterns<double> patterns_of(const std::array<math::Vec3, 8>& node) {
  PatternItems<double> items[3];
  for (int axis = 0; axis < 3; ++axis) {
    double values[8] = {};
    for (std::size_t k = 0; k < 8; ++k) values[k] = node[k][axis];
    items[axis] = pattern_items<double>(values);
  }
  SolidPatterns<double> x{};
  for (int p = 0; p < pattern::count; ++p) x.of[p] = {items[0].of[p], items[1].of[p], items[2].of[p]};
  return x;
}

SolidSize solid_size(const domain::Domain& domain, const std::array<Index, 8>& node, bool exact_volume) {
  std::array<math::Vec3, 8> corner;
  for (std::size_t k = 0; k < 8; ++k) corner[k] = domain.nodes.position[node[k]];
  const SolidPatterns<double> x = patterns_of(corner);
  const double volume = solid_geometry(x, exact_volume).volume;
  return {volume, volume / square_root(largest_face_squared(x))};
}

}  // namespace crumple::elements
