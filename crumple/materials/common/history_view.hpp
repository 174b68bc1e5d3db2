// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"
#include "base/pack.hpp"

namespace crumple::materials {

/// History of one point of one pack of elements: item numbers are counted in components of the law's own
/// items, as declare_history added them.
template <class Real>
struct HistoryView {
  Real* first;  ///< component 0 of the law's items, first lane of the pack
  int points;   ///< of the element: of a shell those in plane and through the thickness
  int point;    ///< counted over all of these

  /// Address of component `component` of the law's items.
  CRUMPLE_INLINE Real* at(int component) const { return first + component * lanes; }
};

/// The stress that a law goes on from: where it fades with the plastic strain the state has what is left of
/// it.
template <class Law, class Stress, class Real>
CRUMPLE_INLINE Stress own_stress([[maybe_unused]] const Law& law, const Stress& stress,
                                 [[maybe_unused]] const HistoryView<Real>& history) {
  if constexpr (requires { law.left(history); }) {
    const auto left = law.left(history);
    return scaled(stress, decltype(left)(decltype(left)(Real(1)) / left));
  } else {
    return stress;
  }
}

}  // namespace crumple::materials
