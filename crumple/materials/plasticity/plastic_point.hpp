// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/history_view.hpp"

namespace crumple::materials {

/// What every law with an effective plastic strain does with it, for shells and solids: the items that
/// declare_plastic_strain (plastic_state.hpp) has added, and failure at a strain.
template <class Pack>
struct PlasticPoint {
  using Real = RealOf<Pack>;
  using Mask = MaskOf<Pack>;
  using History = HistoryView<Real>;

  Real failure;  ///< effective plastic strain at which a point fails; 0: never

  CRUMPLE_INLINE explicit PlasticPoint(double failure_strain) : failure(static_cast<Real>(failure_strain)) {}

  CRUMPLE_INLINE bool fails() const { return failure > 0; }
  CRUMPLE_INLINE Mask intact(const History& history) const {
    return load<Pack>(plastic_strain(history)) < Pack(failure);
  }

  /// Its square is a number still.
  static constexpr Real unreachable = sizeof(Real) == sizeof(float) ? Real(1e18) : Real(1e150);

  CRUMPLE_INLINE static Real* plastic_strain(const History& history) { return history.at(history.point); }
  CRUMPLE_INLINE static Real* plastic_strain_rest(const History& history) {
    return history.at(history.points + history.point);
  }
  /// Of a tensor with `count` components that is the law's next item.
  CRUMPLE_INLINE static Real* back_stress(const History& history, int count) {
    return history.at(2 * history.points + count * history.point);
  }

  /// The rounding error of the sum is kept and added the next time, or slow flow would come to a halt in
  /// float (sum with its error after D.E. Knuth, The Art of Computer Programming 2, section 4.2.2).
  CRUMPLE_INLINE static void add_plastic_strain(const History& history, const Pack& flow) {
    const Pack old = load<Pack>(plastic_strain(history));
    const Pack rest = load<Pack>(plastic_strain_rest(history));
    const Pack growth = select<Pack>(flow > Pack(Real(0)), Pack(flow + rest), Pack(Real(0)));
    const Pack sum = old + growth;
    const Pack taken = sum - old;
    const Pack lost = (old - (sum - taken)) + (growth - taken);
    store(plastic_strain(history), sum);
    store(plastic_strain_rest(history), select<Pack>(flow > Pack(Real(0)), lost, rest));
  }
};

}  // namespace crumple::materials
