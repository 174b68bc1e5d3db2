// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/element_sums.hpp"
#include "elements/formulation.hpp"

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

/// Switches off the elements of one group all of whose points have failed, after their forces have been made
/// of stresses that are zero already: so the last work is still counted. Keeps the energy of each element,
/// that it may be told apart when the element goes. `state` and `rows` are those of the group's first lane.
template <class Pack>
void erode(const ShellTask<RealOf<Pack>>& task, RealOf<Pack>* state, const RealOf<Pack>* rows,
           ElementSums& sums) {
  using Real = RealOf<Pack>;
  Real* const own = state + task.constants.own * lanes;
  for (Index lane = 0; lane < lanes; ++lane) {
    Real* const active = own + element_state::active * lanes + lane;
    Real* const internal = own + element_state::energy * lanes + lane;
    Real* const hourglass = internal + lanes;
    if (*active == Real(0)) {
      // The hourglass force of the step of failure still acts until the next one.
      const Real last = rows[scratch_row::hourglass_energy * tile_lanes + lane];
      *hourglass += last;
      sums.eroded_hourglass += static_cast<double>(last);
      continue;
    }
    *internal += rows[scratch_row::internal_energy * tile_lanes + lane];
    *hourglass += rows[scratch_row::hourglass_energy * tile_lanes + lane];
    bool intact = false;
    for (int plane = 0; plane < task.constants.planes; ++plane)
      intact = intact || rows[(scratch_row::intact + plane) * tile_lanes + lane] != Real(0);
    if (intact) continue;
    *active = Real(0);
    sums.eroded_internal += static_cast<double>(*internal);
    sums.eroded_hourglass += static_cast<double>(*hourglass);
    ++sums.eroded;
  }
}

}  // namespace crumple::elements
