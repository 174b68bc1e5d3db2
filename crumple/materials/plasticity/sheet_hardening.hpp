// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/plasticity/yield_point.hpp"

namespace crumple::materials {

/// Yield stress of sheet metal: interpolated in a table over the plastic strain, or k (e_y + p)^n.
template <class Real>
struct SheetHardening {
  static constexpr bool rough = true;

  PointTable<Real> table;  ///< without rows: the power
  Real strength;           ///< k
  Real exponent;           ///< n
  Real yield_strain;       ///< e_y
  Real least_stress;

  template <class Strain, class Pack>
  CRUMPLE_INLINE Pack aside(const Strain& /*strain*/, const Pack& factor) const {
    return factor;
  }
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> at(const Pack& strain, const Pack& /*aside*/) const {
    if (table.count > 0) return table.at(strain);
    return power_point(strength, exponent, yield_strain, strain);
  }
  CRUMPLE_INLINE bool viscoplastic() const { return false; }
  template <class Pack>
  CRUMPLE_INLINE Pack least(const Pack& /*aside*/) const {
    return Pack(least_stress);
  }
};

}  // namespace crumple::materials
