// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "base/pack.hpp"
#include "base/prefetch.hpp"
#include "elements/common/element_task.hpp"

namespace crumple::elements {

/// The groups that a task works off next, while those before are worked off: the processor follows neither
/// nodes nor the rows of a state by itself. To be asked for in three portions with work between them, as one
/// core waits for some dozens of lines at a time and no more. Nothing at the end of a task, or if the model
/// fits into the caches.
template <class Pack>
struct GroupsAhead {
  const ElementTask<RealOf<Pack>>& task;
  std::ptrdiff_t first;
  std::ptrdiff_t count;
  Index corners;

  CRUMPLE_INLINE GroupsAhead(const ElementTask<RealOf<Pack>>& of, Index node_count, Index from, Index groups)
      : task(of), first(from), count(0), corners(node_count) {
    if (task.from_memory && from < task.groups)
      count = task.groups - from < groups ? task.groups - from : groups;
  }

  CRUMPLE_INLINE void state() const {
    const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(task.components) * lanes;
    prefetch<true>(task.state + first * stride, count * stride);
  }
  CRUMPLE_INLINE void nodes() const {
    const Index* const node = task.node + first * corners * lanes;
    for (std::ptrdiff_t i = 0; i < count * corners * lanes; ++i) prefetch<false>(&task.nodes[node[i]], 1);
  }
  CRUMPLE_INLINE void forces() const {
    const Index* const target = task.target + first * corners * lanes;
    for (std::ptrdiff_t i = 0; i < count * corners * lanes; ++i) prefetch<true>(&task.force[target[i]], 1);
  }
};

}  // namespace crumple::elements
