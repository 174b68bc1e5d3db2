// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/pack.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Yield stress and its slope over the effective plastic strain.
template <class Pack>
struct YieldPoint {
  Pack stress, slope;
};

/// Keeps slopes of powers finite at zero strain; far below any strain that matters.
template <class Real>
inline constexpr Real tiny_strain = sizeof(Real) == sizeof(float) ? Real(1e-30) : Real(1e-200);

/// Yield stress k (e_y + p)^n at the plastic strain p, and its slope.
template <class Pack>
CRUMPLE_INLINE YieldPoint<Pack> power_point(RealOf<Pack> strength, RealOf<Pack> exponent,
                                            RealOf<Pack> yield_strain, const Pack& strain) {
  const Pack total = strain + Pack(yield_strain);
  const Pack stress = Pack(strength) * math::power(total, Pack(exponent));
  return {stress, Pack(exponent) * stress / total};
}

/// A function straight between points and constant outside of them.
template <class Real>
struct PointTable {
  const double* rows;  ///< abscissa, value and slope to the next row (0 in the last)
  int count;

  /// Tables are short and plastic strains small: walking up from the first row is as fast as a search, and
  /// stops where no lane is further. Below the first row it is the first row's line that is continued.
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> at(const Pack& x) const {
    Pack from(static_cast<Real>(rows[0]));
    Pack value(static_cast<Real>(rows[1]));
    Pack slope(static_cast<Real>(rows[2]));
    for (int k = 1; k < count; ++k) {
      const Pack start(static_cast<Real>(rows[3 * k]));
      const auto beyond = x >= start;
      if (!any<Pack>(beyond)) break;
      from = select<Pack>(beyond, start, from);
      value = select<Pack>(beyond, Pack(static_cast<Real>(rows[3 * k + 1])), value);
      slope = select<Pack>(beyond, Pack(static_cast<Real>(rows[3 * k + 2])), slope);
    }
    return {multiply_add(slope, Pack(x - from), value), slope};
  }
};

}  // namespace crumple::materials
