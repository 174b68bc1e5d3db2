// SPDX-License-Identifier: BSD-3-Clause
#include "output/results/shell_axes.hpp"

#include <cstddef>

namespace crumple::output {

using math::Vec3;

ShellAxes shell_axes(const domain::ShellBlock& block, const domain::NodeFields& nodes, Index place) {
  const std::array<Index, 4> node = block.nodes_of(place);
  const auto at = [&](std::size_t corner) { return nodes.position[node[corner]]; };
  const Vec3 r31 = at(2) - at(0);
  const Vec3 r42 = at(3) - at(1);
  const Vec3 g1 = r31 - r42;
  const Vec3 g2 = r31 + r42;
  const Vec3 normal = cross(g1, g2);
  if (!(norm(normal) > 0)) return {};
  const Vec3 e3 = normalised(normal);
  const domain::StateItem* const frame = block.find("frame");
  Vec3 along = g1;
  if (frame != nullptr)
    along += cross(block.state(place, frame->first) * g1 + block.state(place, frame->first + 1) * g2, e3);
  const Vec3 e1 = normalised(along);
  return {e1, cross(e3, e1), e3};
}

Tensor in_global_axes(const ShellAxes& axes, const std::array<double, 5>& local) {
  const auto [xx, yy, xy, yz, zx] = local;
  // Stress vectors on the faces normal to the axes of the shell.
  const Vec3 on1 = xx * axes.e1 + xy * axes.e2 + zx * axes.e3;
  const Vec3 on2 = xy * axes.e1 + yy * axes.e2 + yz * axes.e3;
  const Vec3 on3 = zx * axes.e1 + yz * axes.e2;
  const auto component = [&](int i, int j) {
    return axes.e1[i] * on1[j] + axes.e2[i] * on2[j] + axes.e3[i] * on3[j];
  };
  return {component(0, 0), component(1, 1), component(2, 2),
          component(0, 1), component(1, 2), component(2, 0)};
}

}  // namespace crumple::output
