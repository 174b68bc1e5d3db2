// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/deformation.hpp"
#include "materials/common/history_view.hpp"
#include "materials/common/solid_material.hpp"

namespace crumple::materials {

/// Items of a law whose stress follows from the deformation gradient F: F less the unit matrix, row by row,
/// and what its sums have lost to rounding.
inline void declare_deformation(domain::ElementBlock& block) {
  domain::add_item(block, "deformation", "-", 9 * block.points);
  domain::add_item(block, "deformation_rest", "-", 9 * block.points);
}

/// What the descriptions of such laws have in common: they derive from this.
struct TotalDeformationLaw {
  static constexpr bool wave_speed_varies = true;

  static void declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                              Index /*tensor*/) {
    declare_deformation(block);
  }
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }
};

/// Determinant of I + D, less 1.
template <class Pack>
CRUMPLE_INLINE Pack volume_excess(const Turn<Pack>& d) {
  const Invariants<Pack> of = invariants(d);
  return of.trace + (of.second + of.determinant);
}

template <class Pack>
struct TotalStress {
  SolidStress<Pack> stress;
  Pack wave_square;  ///< upper bound of the square of the speed of longitudinal waves
};

/// What laws of total deformation have in common: they derive from this and have total(D).
template <class Pack>
struct TotalDeformation {
  using Real = RealOf<Pack>;
  static constexpr bool can_yield = false;
  static constexpr bool may_fail = false;
  static constexpr bool is_total = true;

  CRUMPLE_INLINE static Turn<Pack> advance(const HistoryView<Real>& history, const SolidStrain<Pack>& strain,
                                           const Turn<Pack>& turn) {
    return advance_deformation(history.at(9 * history.point),
                               history.at(9 * (history.points + history.point)), lanes,
                               step_gradient(strain, turn));
  }
};

}  // namespace crumple::materials
