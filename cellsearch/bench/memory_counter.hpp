// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace cellsearch::bench {

/// Counts all memory that the process takes and gives back while it is switched on, in whatever library: the
/// program has its own malloc (in front of the C library's) and mmap. Off, it costs next to nothing.
class MemoryCounter {
 public:
  /// True if this program was built so that it can count.
  static bool available();

  /// From here on, counting from 0.
  static void start();
  static void stop();

  /// Bytes taken and not given back since start().
  static std::int64_t held();

  /// The most that was held since start() or the last reset_peak().
  static std::int64_t peak();
  static void reset_peak();
};

/// Hands memory that is free, but kept by the C library for the next who asks, back to the system.
void give_back_free_memory();

}  // namespace cellsearch::bench
