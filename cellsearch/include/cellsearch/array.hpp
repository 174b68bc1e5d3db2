// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace cellsearch {

/// Allocator that leaves new numbers unset instead of setting them to zero: arrays that are written whole
/// right after they grow need no pass over memory for it.
template <class T>
struct UnsetAllocator : std::allocator<T> {
  template <class Other>
  struct rebind {
    using other = UnsetAllocator<Other>;
  };

  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

/// A std::vector of numbers whose resize() leaves the new ones unset.
template <class T>
using Array = std::vector<T, UnsetAllocator<T>>;

}  // namespace cellsearch
