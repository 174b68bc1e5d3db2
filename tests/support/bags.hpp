// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Closed surfaces made in code, and what fills them.

#include <array>
#include <functional>
#include <map>
#include <vector>

#include "support/meshes.hpp"

namespace crumple::test {

/// Adds the surface of a cube, n x n shells a face with common nodes and normals outwards, to `part`;
/// place(x, y, z) gives the position of a lattice point with coordinates in [-1, 1].
inline void add_closed_box(model::Model& model, Index part, int n,
                           const std::function<Point(double, double, double)>& place) {
  std::map<std::array<int, 3>, Index> nodes;
  const auto node_at = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = nodes.try_emplace(at, model.nodes.count());
    if (is_new) {
      model.nodes.id.push_back(model.nodes.count() + 1);
      model.nodes.position.push_back(place(2.0 * at[0] / n - 1, 2.0 * at[1] / n - 1, 2.0 * at[2] / n - 1));
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          // u, v and the outward normal make a right-handed frame.
          const auto corner = [&](int u, int v) {
            std::array<int, 3> at{};
            at[axis] = upper ? n : 0;
            at[(axis + (upper ? 1 : 2)) % 3] = u;
            at[(axis + (upper ? 2 : 1)) % 3] = v;
            return node_at(at);
          };
          model.shells.push_back(
              {.id = static_cast<UserId>(model.shells.size()) + 1,
               .part = part,
               .node = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}});
        }
}

/// A control volume whose surface are all shells of the model.
inline model::ControlVolume bag_of_shells(const model::Model& model, const model::VolumeFilling& filling) {
  model::ControlVolume volume;
  volume.id = 7;
  volume.title = "bag";
  for (const model::ShellElement& shell : model.shells) volume.segments.push_back(shell.node);
  volume.filling = filling;
  return volume;
}

}  // namespace crumple::test
