// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/formulation.hpp"

namespace crumple::elements {

/// Puts a unit square at rest in the place of what gather() left of elements that have failed and whose last
/// hourglass force is gone: their nodes fly where they will, and an element without area would make numbers
/// out of all bounds that no factor of zero takes back.
template <class Pack>
CRUMPLE_INLINE void rest_failed(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const Pack zero(Real(0));
  const HourglassModes<Pack> q = hourglass_state<Pack>(place);
  const auto gone = own_state<Pack>(place, element_state::active) == zero && q.x == zero && q.y == zero &&
                    q.z == zero && q.bending_x == zero && q.bending_y == zero;
  if (!any<Pack>(gone)) return;
  const auto put = [&](int row, const Pack& value) {
    Real* const at = place.nodes + row * width_of<Pack>;
    store(at, select<Pack>(gone, value, load<Pack>(at)));
  };
  for (int row = 0; row < gather_row::count; ++row) put(row, zero);
  const Pack one(Real(1));
  put(gather_row::r31, one);
  put(gather_row::r31 + 1, one);
  put(gather_row::r42, -one);
  put(gather_row::r42 + 1, one);
}

}  // namespace crumple::elements
