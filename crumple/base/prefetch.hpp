// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "base/aligned_array.hpp"

namespace crumple {

/// Asks for `count` objects from the first of each of their cache lines, to be changed or only read.
template <bool ToWrite, class T>
[[gnu::always_inline]] inline void prefetch(const T* first, std::ptrdiff_t count) {
  const char* const start = reinterpret_cast<const char*>(first);
  const std::ptrdiff_t bytes = count * static_cast<std::ptrdiff_t>(sizeof(T));
  for (std::ptrdiff_t at = 0; at < bytes; at += cache_line) __builtin_prefetch(start + at, ToWrite, 3);
  // Without this GCC takes functions that only ask for ones without effect, and leaves their calls out.
  asm volatile("");
}

}  // namespace crumple
