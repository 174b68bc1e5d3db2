// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <immintrin.h>

#include "cellsearch/instruction_set.hpp"
#include "production/grid.hpp"

// What the loops for x86 share. They are compiled once per instruction set; everything is in an unnamed
// namespace, so that no two compilations share a function: the linker would keep one of them for both.

namespace cellsearch::production {
namespace {

inline __m128i load4(const void* from) {
  return _mm_load_si128(static_cast<const __m128i*>(from));
}

inline void store4(void* to, __m128i value) {
  _mm_store_si128(static_cast<__m128i*>(to), value);
}

/// Sum of the four numbers, in the first.
inline __m128i sum4(__m128i value) {
  value = _mm_add_epi32(value, _mm_shuffle_epi32(value, 0x4e));
  return _mm_add_epi32(value, _mm_shuffle_epi32(value, 0xb1));
}

inline __m256d load_position(const double* xyz) {
  return _mm256_maskload_pd(xyz, _mm256_setr_epi64x(-1, -1, -1, 0));
}

/// The four bytes of a control for _mm_shuffle_epi8 that move number `lane` (zero if negative).
inline int lane_bytes(int lane) {
  return lane < 0 ? -1 : 0x03020100 + 0x04040404 * lane;
}

/// A grid in registers.
template <InstructionSet Set>
struct GridLanes {
  __m128i top;
  __m128i shift;
  __m128i step;

  explicit GridLanes(const Grid& grid)
      : top(load4(grid.top.data())), shift(load4(grid.shift.data())), step(load4(grid.step.data())) {}

  __m128i clamp(__m128i fine) const { return _mm_max_epi32(_mm_min_epi32(fine, top), _mm_setzero_si128()); }
  __m128i cells(__m128i clamped) const { return _mm_srlv_epi32(clamped, shift); }
  __m128i number(__m128i cells_of_axes) const { return sum4(_mm_mullo_epi32(cells_of_axes, step)); }
};

}  // namespace
}  // namespace cellsearch::production
