// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell_setup.hpp"

namespace crumple::elements {

using math::Vec3;

ShellCorners corners_of(const domain::Domain& domain, const std::array<Index, 4>& node) {
  ShellCorners corner;
  for (std::size_t k = 0; k < 4; ++k) corner[k] = domain.nodes.position[node[k]];
  return corner;
}

std::array<Vec3, 4> corner_normals(const ShellCorners& corner) {
  const Vec3 twice_area = cross(corner[2] - corner[0], corner[3] - corner[1]);
  const Vec3 normal = normalised(twice_area);
  std::array<Vec3, 4> normals;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 at = cross(corner[(k + 1) % 4] - corner[k], corner[(k + 3) % 4] - corner[k]);
    // A re-entrant or degenerate corner has no normal of its own.
    normals[k] = dot(at, normal) > 1e-6 * norm(twice_area) ? normalised(at) : normal;
  }
  return normals;
}

}  // namespace crumple::elements
