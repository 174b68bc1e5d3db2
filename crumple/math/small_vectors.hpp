// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "base/pack.hpp"

namespace crumple::math {

// Vectors of four or eight numbers that hold one item each (a force, a velocity), for the way between the
// nodes' records and the packs, which hold one number of many items. GNU vector types: any target splits
// what its registers cannot hold.

using Float4 = float __attribute__((vector_size(16)));
using Float8 = float __attribute__((vector_size(32)));
using Float16 = float __attribute__((vector_size(64)));
using Double4 = double __attribute__((vector_size(32)));
using Double8 = double __attribute__((vector_size(64)));

/// Reads a vector from any address.
template <class Vector>
CRUMPLE_INLINE Vector read(const void* from) {
  Vector to;
  __builtin_memcpy(&to, from, sizeof(Vector));
  return to;
}
template <class Vector>
CRUMPLE_INLINE void write(void* to, const Vector& from) {
  __builtin_memcpy(to, &from, sizeof(Vector));
}

// GCC 12 converts vectors of this kind in halves over the stack, where one instruction would do.
CRUMPLE_INLINE Float4 to_float(const Double4& v) {
#if defined(__AVX__)
  return __builtin_bit_cast(Float4, _mm256_cvtpd_ps(__builtin_bit_cast(__m256d, v)));
#else
  return __builtin_convertvector(v, Float4);
#endif
}
CRUMPLE_INLINE Double4 to_double(const Float4& v) {
#if defined(__AVX__)
  return __builtin_bit_cast(Double4, _mm256_cvtps_pd(__builtin_bit_cast(__m128, v)));
#else
  return __builtin_convertvector(v, Double4);
#endif
}
CRUMPLE_INLINE Double4 to_double(const Double4& v) {
  return v;
}

/// In the precision of the second argument.
CRUMPLE_INLINE Float4 narrowed(const Double4& v, float /*to*/) {
  return to_float(v);
}
CRUMPLE_INLINE Double4 narrowed(const Double4& v, double /*to*/) {
  return v;
}

// Likewise GCC 12 shuffles where an insertion, straight from memory, would do.
CRUMPLE_INLINE Float8 joined(const Float4& low, const Float4& high) {
#if defined(__AVX__)
  return __builtin_bit_cast(Float8,
                            _mm256_insertf128_ps(_mm256_castps128_ps256(__builtin_bit_cast(__m128, low)),
                                                 __builtin_bit_cast(__m128, high), 1));
#else
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#endif
}

/// Subtracts eight numbers from doubles. In halves even where a register holds all eight: the next element
/// often reads what this one has just written, and a store of a whole line is slow to be read back.
CRUMPLE_INLINE void subtract_from(double* sum, const Float8& v) {
  const Float4 low = __builtin_shufflevector(v, v, 0, 1, 2, 3);
  const Float4 high = __builtin_shufflevector(v, v, 4, 5, 6, 7);
  write(sum, read<Double4>(sum) - to_double(low));
  write(sum + 4, read<Double4>(sum + 4) - to_double(high));
}

/// Rows become columns: out[c] holds number c of the four inputs.
template <class Vector>
struct Four {
  Vector row[4];
};

CRUMPLE_INLINE Four<Float4> transposed(const Float4& a, const Float4& b, const Float4& c, const Float4& d) {
  const Float4 ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Float4 cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  const Float4 ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Float4 cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  return {{__builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5),
           __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7),
           __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5),
           __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7)}};
}

CRUMPLE_INLINE Four<Double4> transposed(const Double4& a, const Double4& b, const Double4& c,
                                        const Double4& d) {
  const Double4 ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Double4 cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Double4 ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Double4 cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {{__builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5),
           __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5),
           __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7),
           __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7)}};
}

/// The same in both halves at once.
CRUMPLE_INLINE Four<Float8> transposed(const Float8& a, const Float8& b, const Float8& c, const Float8& d) {
  const Float8 ab_low = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
  const Float8 cd_low = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
  const Float8 ab_high = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
  const Float8 cd_high = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
  return {{__builtin_shufflevector(ab_low, cd_low, 0, 1, 8, 9, 4, 5, 12, 13),
           __builtin_shufflevector(ab_low, cd_low, 2, 3, 10, 11, 6, 7, 14, 15),
           __builtin_shufflevector(ab_high, cd_high, 0, 1, 8, 9, 4, 5, 12, 13),
           __builtin_shufflevector(ab_high, cd_high, 2, 3, 10, 11, 6, 7, 14, 15)}};
}

/// The same in all four quarters at once.
CRUMPLE_INLINE Four<Float16> transposed(const Float16& a, const Float16& b, const Float16& c,
                                        const Float16& d) {
  const Float16 ab_low =
      __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
  const Float16 cd_low =
      __builtin_shufflevector(c, d, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
  const Float16 ab_high =
      __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
  const Float16 cd_high =
      __builtin_shufflevector(c, d, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
  return {
      {__builtin_shufflevector(ab_low, cd_low, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29),
       __builtin_shufflevector(ab_low, cd_low, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31),
       __builtin_shufflevector(ab_high, cd_high, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29),
       __builtin_shufflevector(ab_high, cd_high, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30,
                               31)}};
}

/// The same in both halves at once.
CRUMPLE_INLINE Four<Double8> transposed(const Double8& a, const Double8& b, const Double8& c,
                                        const Double8& d) {
  const Double8 ab_even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Double8 cd_even = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const Double8 ab_odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const Double8 cd_odd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  return {{__builtin_shufflevector(ab_even, cd_even, 0, 1, 8, 9, 4, 5, 12, 13),
           __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 8, 9, 4, 5, 12, 13),
           __builtin_shufflevector(ab_even, cd_even, 2, 3, 10, 11, 6, 7, 14, 15),
           __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 10, 11, 6, 7, 14, 15)}};
}

}  // namespace crumple::math
