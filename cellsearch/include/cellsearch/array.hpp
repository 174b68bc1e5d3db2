// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace cellsearch {

/// Memory of `bytes` bytes, aligned to 64; large pieces in huge pages where the system has them, because
/// searching reads at random. Throws std::bad_alloc.
void* allocate_memory(std::size_t bytes);
/// Gives it back.
void release_memory(void* memory) noexcept;

/// Allocator that leaves new numbers unset instead of setting them to zero: arrays that are written whole
/// right after they grow need no pass over memory for it.
template <class T>
struct UnsetAllocator {
  using value_type = T;

  UnsetAllocator() = default;
  template <class Other>
  UnsetAllocator(const UnsetAllocator<Other>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_memory(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t) noexcept { release_memory(memory); }

  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  bool operator==(const UnsetAllocator&) const = default;
};

/// A std::vector of numbers whose resize() leaves the new ones unset.
template <class T>
using Array = std::vector<T, UnsetAllocator<T>>;

}  // namespace cellsearch
