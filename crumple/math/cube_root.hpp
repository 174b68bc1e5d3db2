// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "math/power.hpp"

namespace crumple::math {

/// Third root of normal positive numbers, to 4 units in the last place; 0 for others. The bits of a number
/// are its binary logarithm, roughly: minus a third of them starts x^(-1/3) within 4 %, and two steps of z (1
/// + h/3 + 2 h^2/9 + 14 h^3/81), h = 1 - x z^3, leave round-off (Householder's method of the third order).
template <class Pack>
CRUMPLE_INLINE Pack cube_root(const Pack& x) {
  using Real = RealOf<Pack>;
  using Format = detail::FloatBits<Real>;
  using Bits = typename detail::BitsPack<Pack>::type;
  constexpr bool is_float = std::is_same_v<Real, float>;
  constexpr int dropped = is_float ? 8 : 12;  // so many of the last bits, that the others fit in a mantissa
  constexpr double unit = is_float ? 0x1p15 : 0x1p40;  // of the exponent, in what is left
  constexpr double bias = is_float ? 127 : 1023;
  constexpr double shift = is_float ? 0x1p23 : 0x1p52;
  const Pack whole(static_cast<Real>(shift));
  const Pack logarithm =
      detail::same_bits<Pack>(Bits((detail::same_bits<Bits>(x) >> dropped) | Bits(Format::integer))) - whole;
  const Pack start = multiply_add(Pack(Real(-1.0 / 3.0)), logarithm,
                                  Pack(static_cast<Real>((bias - 0.05) * unit * 4.0 / 3.0)));
  Pack z = detail::same_bits<Pack>(
      Bits((detail::same_bits<Bits>(Pack(start + whole)) & Bits(Format::mantissa_mask)) << dropped));
  const Pack one(Real(1));
  for (int step = 0; step < 2; ++step) {
    const Pack h = multiply_add(Pack(-(x * z)), Pack(z * z), one);
    const Pack series = multiply_add(multiply_add(Pack(Real(14.0 / 81.0)), h, Pack(Real(2.0 / 9.0))), h,
                                     Pack(Real(1.0 / 3.0)));
    z = multiply_add(Pack(z * h), series, z);
  }
  return select<Pack>(x > Pack(Real(0)), Pack(x * z * z), Pack(Real(0)));
}

}  // namespace crumple::math
