// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "base/aligned_array.hpp"
#include "base/pack.hpp"
#include "elements/element_task.hpp"

namespace crumple::elements {

/// Asks for `count` objects from the first of each of their cache lines, to be changed or only read.
template <bool to_write, class T>
CRUMPLE_INLINE void prefetch(const T* first, std::ptrdiff_t count) {
  const char* const start = reinterpret_cast<const char*>(first);
  const std::ptrdiff_t bytes = count * static_cast<std::ptrdiff_t>(sizeof(T));
  for (std::ptrdiff_t at = 0; at < bytes; at += cache_line) __builtin_prefetch(start + at, to_write, 3);
}

/// Asks for what the groups [first, first + groups) of a task will read and write, while those before are
/// worked off: the processor follows neither nodes nor the rows of a state by itself. Nothing at the end of
/// the task.
template <class Pack>
CRUMPLE_INLINE void prefetch_groups(const ElementTask<RealOf<Pack>>& task, Index corners, Index first,
                                    Index groups) {
  const Index present = task.groups - first < groups ? task.groups - first : groups;
  if (present <= 0) return;
  const std::ptrdiff_t entry = static_cast<std::ptrdiff_t>(first) * corners * lanes;
  const std::ptrdiff_t entries = static_cast<std::ptrdiff_t>(present) * corners * lanes;
  for (std::ptrdiff_t i = entry; i < entry + entries; ++i) prefetch<false>(&task.nodes[task.node[i]], 1);
  for (std::ptrdiff_t i = entry; i < entry + entries; ++i) prefetch<true>(&task.force[task.target[i]], 1);
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(task.components) * lanes;
  prefetch<true>(task.state + first * stride, present * stride);
}

}  // namespace crumple::elements
