// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include "base/huge_pages.hpp"

namespace crumple {

/// One cache line, and the widest SIMD load, in bytes.
inline constexpr std::size_t cache_line = 64;

template <class T>
struct CacheLineAllocator {
  using value_type = T;

  CacheLineAllocator() = default;
  template <class U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>& /*other*/) {}

  T* allocate(std::size_t n) {
    const std::size_t bytes = n * sizeof(T);
    void* const start = ::operator new(bytes, alignment(bytes));
    if (bytes >= huge_page) ask_for_huge_pages(start, bytes);
    return static_cast<T*>(start);
  }
  void deallocate(T* p, std::size_t n) { ::operator delete(p, alignment(n * sizeof(T))); }

  template <class U>
  bool operator==(const CacheLineAllocator<U>& /*other*/) const {
    return true;
  }

 private:
  static std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t(bytes >= huge_page ? huge_page : cache_line);
  }
};

/// A std::vector whose first element starts a cache line; a large one lies in huge pages if the system has
/// them.
template <class T>
using AlignedArray = std::vector<T, CacheLineAllocator<T>>;

}  // namespace crumple
