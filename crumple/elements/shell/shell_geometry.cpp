// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/shell_geometry.hpp"

#include <algorithm>

namespace crumple::elements {

using math::Vec3;

double shell_area(const ShellCorners& corner) {
  return 0.5 * norm(cross(corner[2] - corner[0], corner[3] - corner[1]));
}

double characteristic_length(const ShellCorners& corner, bool triangle) {
  double longest = 0;
  for (std::size_t k = 0; k < 4; ++k) longest = std::max(longest, norm(corner[(k + 1) % 4] - corner[k]));
  return (triangle ? 2 : 1) * shell_area(corner) / longest;
}

std::array<double, 2> reference_frame(const ShellCorners& corner) {
  const Vec3 r31 = corner[2] - corner[0];
  const Vec3 r42 = corner[3] - corner[1];
  const Vec3 g1 = r31 - r42;
  const Vec3 g2 = r31 + r42;
  const Vec3 e3 = normalised(cross(r31, r42));
  const Vec3 e1 = normalised(g1);
  const double along = dot(g2, e1);
  const double across = dot(g2, cross(e3, e1));
  return {-along / across, norm(g1) / across};
}

std::array<double, 4> mass_shares(const std::array<Index, 4>& node) {
  const double corners = is_triangle(node) ? 3 : 4;
  std::array<double, 4> share{};
  for (std::size_t k = 0; k < 4; ++k)
    share[k] = 1.0 / (corners * static_cast<double>(std::count(node.begin(), node.end(), node[k])));
  return share;
}

bool is_triangle(const std::array<Index, 4>& node) {
  for (std::size_t k = 0; k < 4; ++k)
    if (node[k] == node[(k + 1) % 4]) return true;
  return false;
}

}  // namespace crumple::elements
