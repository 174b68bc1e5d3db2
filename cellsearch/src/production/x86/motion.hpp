// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>

#include "production/kernels.hpp"
#include "production/x86/lanes.hpp"

namespace cellsearch::production {
namespace {

/// The loop of MotionTracker: four nodes fill three registers.
template <InstructionSet Set>
struct MotionLoops {
  struct Lanes {
    __m256d low = _mm256_set1_pd(std::numeric_limits<double>::infinity());
    __m256d high = _mm256_set1_pd(-std::numeric_limits<double>::infinity());
    __m256d wrong = _mm256_setzero_pd();  ///< stays 0 until something is not finite

    void take(__m256d value) {
      low = _mm256_min_pd(value, low);
      high = _mm256_max_pd(value, high);
      wrong = _mm256_fmadd_pd(value, _mm256_setzero_pd(), wrong);
    }

    /// The first lane is number `first` of x, y, z, x, ...
    void give(int first, ValueRange& range) const {
      alignas(32) double lows[4];
      alignas(32) double highs[4];
      _mm256_store_pd(lows, low);
      _mm256_store_pd(highs, high);
      for (int lane = 0; lane < 4; ++lane) {
        const int axis = (first + lane) % 3;
        if (lows[lane] < range.lo[axis]) range.lo[axis] = lows[lane];
        if (highs[lane] > range.hi[axis]) range.hi[axis] = highs[lane];
      }
      const __m256d finite = _mm256_cmp_pd(wrong, wrong, _CMP_ORD_Q);
      if (_mm256_movemask_pd(finite) != 15) range.bad = true;
    }
  };

  static void include(const double* now, const double* then, std::size_t nodes, ValueRange& range) {
    if (then != nullptr)
      include_all<true>(now, then, nodes, range);
    else
      include_all<false>(now, then, nodes, range);
  }

  template <bool Difference>
  static void include_all(const double* now, const double* then, std::size_t nodes, ValueRange& range) {
    Lanes lanes[3];
    const std::size_t end = 3 * nodes;
    std::size_t at = 0;
    for (; at + 12 <= end; at += 12)
      for (int k = 0; k < 3; ++k) {
        __m256d value = _mm256_loadu_pd(now + at + 4 * k);
        if constexpr (Difference) value = _mm256_sub_pd(value, _mm256_loadu_pd(then + at + 4 * k));
        lanes[k].take(value);
      }
    for (; at < end; at += 3) {
      const __m256i node = _mm256_setr_epi64x(-1, -1, -1, 0);
      __m256d value = _mm256_maskload_pd(now + at, node);
      if constexpr (Difference) value = _mm256_sub_pd(value, _mm256_maskload_pd(then + at, node));
      // The fourth lane is of the first axis, too.
      lanes[0].take(_mm256_permute4x64_pd(value, 0x24));
    }
    for (int k = 0; k < 3; ++k) lanes[k].give(4 * k, range);
  }
};

}  // namespace
}  // namespace cellsearch::production
