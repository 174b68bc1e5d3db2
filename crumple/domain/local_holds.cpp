// SPDX-License-Identifier: BSD-3-Clause
#include "domain/local_holds.hpp"

#include <algorithm>

#include "math/to_vec3.hpp"

namespace crumple::domain {
namespace {

/// Takes a direction from those that are free, unless it lies within 1e-6 of those that are held.
void hold_direction(const Vec3& direction, LocalHold& hold) {
  constexpr double dependent = 1e-6;
  // Twice: what rounding leaves of the first time is gone after the second.
  const Vec3 rest = hold.free * (hold.free * direction);
  if (hold.held == 3 || !(norm(rest) > dependent)) return;
  const Vec3 part = normalised(rest);
  for (int axis = 0; axis < 3; ++axis) hold.free.column[static_cast<std::size_t>(axis)] -= part[axis] * part;
  if (++hold.held == 3) hold.free = {};
}

/// Gives each node with a local support its place.
void list_nodes(const model::Model& model, NodeFields& nodes) {
  nodes.local_hold.assign(nodes.domain_node.size(), no_index);
  for (const model::LocalSupport& support : model.local_supports) {
    Index& place = nodes.local_hold[static_cast<std::size_t>(nodes.domain_node[support.node])];
    if (place != no_index) continue;
    place = static_cast<Index>(nodes.local_holds.size());
    nodes.local_holds.emplace_back();
  }
}

}  // namespace

void list_local_holds(const model::Model& model, double time, NodeFields& nodes) {
  if (model.local_supports.empty()) return;
  if (nodes.local_holds.empty()) list_nodes(model, nodes);
  std::fill(nodes.local_holds.begin(), nodes.local_holds.end(), LocalHold{});
  for (const model::LocalSupport& support : model.local_supports) {
    const Index place = nodes.local_hold[static_cast<std::size_t>(nodes.domain_node[support.node])];
    LocalHold& hold = nodes.local_holds[static_cast<std::size_t>(place)];
    hold.lasts = hold.lasts && support.lasts();
    if (time < support.birth || time >= support.death) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (support.translation[axis]) hold_direction(math::to_vec3(support.axes[axis]), hold);
  }
  for (std::size_t node = 0; node < nodes.local_hold.size(); ++node) {
    if (nodes.local_hold[node] == no_index) continue;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 direction;
      direction[axis] = 1;
      if ((nodes.fixed[static_cast<Index>(node)] & fixed_translation(axis)) != 0)
        hold_direction(direction, nodes.local_holds[static_cast<std::size_t>(nodes.local_hold[node])]);
    }
  }
}

}  // namespace crumple::domain
