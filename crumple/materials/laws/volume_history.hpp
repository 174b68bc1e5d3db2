// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/element_block.hpp"
#include "materials/common/deformation.hpp"
#include "materials/common/history_view.hpp"

namespace crumple::materials {

/// Items of a law that follows the volume: relative volume less 1, and what its sum has lost to rounding.
inline void declare_volume(domain::ElementBlock& block) {
  domain::add_item(block, "volume_change", "-", block.points);
  domain::add_item(block, "volume_rest", "-", block.points);
}

template <class Pack>
struct Volumes {
  Pack old, now;
};

/// Relative volume at both ends of the step; `items` is the number of the law's own items per point before
/// those of declare_volume().
template <class Pack>
CRUMPLE_INLINE Volumes<Pack> follow_volume(const HistoryView<RealOf<Pack>>& history, int items,
                                           const SolidStrain<Pack>& strain, const Turn<Pack>& turn) {
  const Pack one(RealOf<Pack>(1));
  RealOf<Pack>* const change = history.at(items * history.points + history.point);
  const Pack old = one + load<Pack>(change);
  const Pack now = one + add_kept(change, history.at((items + 1) * history.points + history.point),
                                  Pack(old * volume_growth(step_gradient(strain, turn))));
  return {old, now};
}

}  // namespace crumple::materials
