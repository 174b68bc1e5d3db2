// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Kernels are templates over a pack: float or double for the scalar reference, a SIMD register of either for
// the fast variants. The pack types of two instruction sets always differ, so that no template instantiated
// for one can be linked in place of another's. The functions are named apart from those of the standard
// library, which argument-dependent lookup would otherwise pick (its fma calls libm where there is no FMA).

#include <cmath>
#include <experimental/simd>

#if defined(__FMA__) && defined(__x86_64__)
#include <immintrin.h>
#endif

#include "base/lanes.hpp"

#if defined(__GNUC__)
#define CRUMPLE_INLINE [[gnu::always_inline]] inline
#else
#define CRUMPLE_INLINE inline
#endif

namespace crumple {

namespace simd = std::experimental;

#if defined(CRUMPLE_ISA_IS_scalar)
template <class Real>
using NativePack = Real;
#else
template <class Real>
using NativePack = simd::native_simd<Real>;
#endif

template <class Pack>
struct PackTraits {
  using Real = typename Pack::value_type;
  using Mask = typename Pack::mask_type;
  static constexpr int width = static_cast<int>(Pack::size());
};
template <>
struct PackTraits<float> {
  using Real = float;
  using Mask = bool;
  static constexpr int width = 1;
};
template <>
struct PackTraits<double> {
  using Real = double;
  using Mask = bool;
  static constexpr int width = 1;
};

template <class Pack>
using RealOf = typename PackTraits<Pack>::Real;
template <class Pack>
using MaskOf = typename PackTraits<Pack>::Mask;
template <class Pack>
inline constexpr int width_of = PackTraits<Pack>::width;

/// Reads width_of<Pack> numbers from an address aligned to the pack.
template <class Pack>
CRUMPLE_INLINE Pack load(const RealOf<Pack>* from) {
  if constexpr (width_of<Pack> == 1)
    return *from;
  else
    return Pack(from, simd::vector_aligned);
}

/// Writes width_of<Pack> numbers to an address aligned to the pack.
template <class Pack>
CRUMPLE_INLINE void store(RealOf<Pack>* to, const Pack& value) {
  if constexpr (width_of<Pack> == 1)
    *to = value;
  else
    value.copy_to(to, simd::vector_aligned);
}

#if defined(__FMA__) && defined(__x86_64__)
namespace detail {

// The library's own fma of packs is a call that GCC does not inline.
template <class Vector, class Pack>
CRUMPLE_INLINE Vector raw(const Pack& pack) {
  return __builtin_bit_cast(Vector, pack);
}

template <class Pack>
CRUMPLE_INLINE Pack fused(const Pack& a, const Pack& b, const Pack& c) {
  constexpr bool is_float = sizeof(typename Pack::value_type) == sizeof(float);
#if defined(__AVX512F__)
  if constexpr (sizeof(Pack) == 64 && is_float)
    return __builtin_bit_cast(Pack, _mm512_fmadd_ps(raw<__m512>(a), raw<__m512>(b), raw<__m512>(c)));
  else if constexpr (sizeof(Pack) == 64)
    return __builtin_bit_cast(Pack, _mm512_fmadd_pd(raw<__m512d>(a), raw<__m512d>(b), raw<__m512d>(c)));
  else
#endif
      if constexpr (sizeof(Pack) == 32 && is_float)
    return __builtin_bit_cast(Pack, _mm256_fmadd_ps(raw<__m256>(a), raw<__m256>(b), raw<__m256>(c)));
  else if constexpr (sizeof(Pack) == 32)
    return __builtin_bit_cast(Pack, _mm256_fmadd_pd(raw<__m256d>(a), raw<__m256d>(b), raw<__m256d>(c)));
  else
    return simd::fma(a, b, c);
}

}  // namespace detail
#endif

/// a b + c: rounded once where the instruction set has FMA (AVX2, AVX-512), twice where it has not. The two
/// families differ in the last bits and have golden hashes of their own (docs/determinism.md).
template <class Pack>
CRUMPLE_INLINE Pack multiply_add(const Pack& a, const Pack& b, const Pack& c) {
#if defined(__FMA__)
  if constexpr (width_of<Pack> == 1)
    return std::fma(a, b, c);
  else
    return detail::fused(a, b, c);
#else
  return a * b + c;
#endif
}

template <class Pack>
CRUMPLE_INLINE Pack square_root(const Pack& a) {
  if constexpr (width_of<Pack> == 1)
    return std::sqrt(a);
  else
    return simd::sqrt(a);
}

template <class Pack>
CRUMPLE_INLINE Pack absolute(const Pack& a) {
  if constexpr (width_of<Pack> == 1)
    return std::fabs(a);
  else
    return simd::abs(a);
}

/// Where `mask` holds `a`, elsewhere `b`, lane by lane.
template <class Pack>
CRUMPLE_INLINE Pack select(const MaskOf<Pack>& mask, const Pack& a, const Pack& b) {
#if defined(__AVX512F__)
  // The library's masked assignment is wrong when clang compiles it for AVX-512.
  if constexpr (sizeof(Pack) == 64 && width_of<Pack> == 16)
    return __builtin_bit_cast(Pack, _mm512_mask_blend_ps(__builtin_bit_cast(__mmask16, mask),
                                                         detail::raw<__m512>(b), detail::raw<__m512>(a)));
  else if constexpr (sizeof(Pack) == 64)
    return __builtin_bit_cast(Pack, _mm512_mask_blend_pd(__builtin_bit_cast(__mmask8, mask),
                                                         detail::raw<__m512d>(b), detail::raw<__m512d>(a)));
  else
#endif
      if constexpr (width_of<Pack> == 1) {
    return mask ? a : b;
  } else {
    Pack chosen = b;
    simd::where(mask, chosen) = a;
    return chosen;
  }
}

template <class Pack>
CRUMPLE_INLINE Pack larger(const Pack& a, const Pack& b) {
  return select<Pack>(a > b, a, b);
}

template <class Pack>
CRUMPLE_INLINE Pack smaller(const Pack& a, const Pack& b) {
  return select<Pack>(a < b, a, b);
}

/// True if the mask holds in any lane.
template <class Pack>
CRUMPLE_INLINE bool any(const MaskOf<Pack>& mask) {
  if constexpr (width_of<Pack> == 1)
    return mask;
  else
    return simd::any_of(mask);
}

}  // namespace crumple
