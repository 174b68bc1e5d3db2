// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <type_traits>

#include "base/pack.hpp"

namespace crumple::math {

// Powers for kernels. The mathematical library's differ between processors and compilers; these use only
// sums, products, divisions and shifts, so that they have the same bits wherever multiply_add has. Their
// names are not those of std::experimental, which argument-dependent lookup would prefer for packs.

using crumple::multiply_add;  // beside that of vectors, which would hide it

namespace detail {

template <class Real>
struct FloatBits;
template <>
struct FloatBits<float> {
  using Bits = std::uint32_t;
  static constexpr int mantissa = 23;
  static constexpr Bits mantissa_mask = 0x007fffffU;
  static constexpr Bits one = 0x3f800000U;
  static constexpr Bits integer = 0x4b000000U;        ///< bits of 2^23: an integer below that is its mantissa
  static constexpr float integer_offset = 8388735.F;  ///< 2^23 + 127
  static constexpr float round = 12582912.F;          ///< 1.5 2^23: adding it rounds to an integer
  static constexpr float exponent_limit = 126.F;
  static constexpr int log_terms = 6;
  static constexpr int exp_terms = 8;
};
template <>
struct FloatBits<double> {
  using Bits = std::uint64_t;
  static constexpr int mantissa = 52;
  static constexpr Bits mantissa_mask = 0x000fffffffffffffU;
  static constexpr Bits one = 0x3ff0000000000000U;
  static constexpr Bits integer = 0x4330000000000000U;
  static constexpr double integer_offset = 4503599627371519.0;  ///< 2^52 + 1023
  static constexpr double round = 6755399441055744.0;           ///< 1.5 2^52
  static constexpr double exponent_limit = 1022.0;
  static constexpr int log_terms = 11;
  static constexpr int exp_terms = 14;
};

template <class Pack>
struct BitsPack {
  using type = simd::rebind_simd_t<typename FloatBits<RealOf<Pack>>::Bits, Pack>;
};
template <>
struct BitsPack<float> {
  using type = std::uint32_t;
};
template <>
struct BitsPack<double> {
  using type = std::uint64_t;
};

template <class To, class From>
CRUMPLE_INLINE To same_bits(const From& from) {
  return __builtin_bit_cast(To, from);
}

}  // namespace detail

/// Binary logarithm of normal positive numbers, to 3 units in the last place (of the result or of 1,
/// whichever is larger). x = 2^e m with m in [sqrt(1/2), sqrt(2)); ln m = 2 artanh((m-1)/(m+1)) by its
/// series.
template <class Pack>
CRUMPLE_INLINE Pack binary_log(const Pack& x) {
  using Real = RealOf<Pack>;
  using Format = detail::FloatBits<Real>;
  using Bits = typename detail::BitsPack<Pack>::type;
  const Bits bits = detail::same_bits<Bits>(x);
  const Pack exponent = detail::same_bits<Pack>(Bits((bits >> Format::mantissa) | Bits(Format::integer))) -
                        Pack(Format::integer_offset);
  const Pack mantissa =
      detail::same_bits<Pack>(Bits((bits & Bits(Format::mantissa_mask)) | Bits(Format::one)));
  const auto high = mantissa > Pack(Real(1.4142135623730951));
  const Pack m = select<Pack>(high, Pack(Real(0.5) * mantissa), mantissa);
  const Pack e = select<Pack>(high, Pack(exponent + Pack(Real(1))), exponent);
  const Pack s = (m - Pack(Real(1))) / (m + Pack(Real(1)));
  const Pack s2 = s * s;
  Pack series(Real(1.0 / (2 * Format::log_terms - 1)));
  for (int k = Format::log_terms - 2; k >= 1; --k)
    series = multiply_add(series, s2, Pack(static_cast<Real>(1.0 / (2 * k + 1))));
  // 2/ln 2 in two parts, so that the leading term is exact to more than one word.
  constexpr double factor = 2.8853900817779268;
  const Pack leading = Pack(Real(factor)) * s;
  return e + multiply_add(Pack(leading * s2), series, leading);
}

/// 2^x to 2 units in the last place; below the smallest normal number that number, above the largest power of
/// two that power. 2^x = 2^k e^(f ln 2), |f| <= 1/2, by the exponential series.
template <class Pack>
CRUMPLE_INLINE Pack power_of_two(const Pack& x) {
  using Real = RealOf<Pack>;
  using Format = detail::FloatBits<Real>;
  using Bits = typename detail::BitsPack<Pack>::type;
  const Pack limit(Format::exponent_limit);
  const Pack bounded = smaller(larger(x, Pack(-limit)), limit);
  const Pack shifted = bounded + Pack(Format::round);
  const Pack whole = shifted - Pack(Format::round);
  const Pack g = (bounded - whole) * Pack(Real(0.69314718055994531));
  double factorial = 1;
  Real coefficient[Format::exp_terms];
  for (int k = 0; k < Format::exp_terms; ++k) {
    coefficient[k] = static_cast<Real>(1.0 / factorial);
    factorial *= k + 1;
  }
  Pack series(coefficient[Format::exp_terms - 1]);
  for (int k = Format::exp_terms - 2; k >= 0; --k) series = multiply_add(series, g, Pack(coefficient[k]));
  const Bits power = (detail::same_bits<Bits>(shifted) << Format::mantissa) + Bits(Format::one);
  return series * detail::same_bits<Pack>(power);
}

/// x^y for x >= 0; 0 for x = 0 and y > 0. The relative error grows with |y log2 x|.
template <class Pack>
CRUMPLE_INLINE Pack power(const Pack& x, const Pack& y) {
  using Real = RealOf<Pack>;
  const Pack smallest(std::is_same_v<Real, float> ? Real(1e-37) : Real(1e-300));
  const Pack result = power_of_two(Pack(y * binary_log(larger(x, smallest))));
  return select<Pack>(x > Pack(Real(0)), result, Pack(Real(0)));
}

}  // namespace crumple::math
