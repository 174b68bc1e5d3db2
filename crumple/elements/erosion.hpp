// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/formulation.hpp"

namespace crumple::elements {

/// Switches off the elements of one group all of whose points have failed, after their forces have been made
/// of stresses that are zero already: so the last work is still counted. Keeps the energy of each element,
/// that it may be told apart when the element goes. `state` and `rows` are those of the group's first lane.
template <class Pack>
void erode(const ShellTask<RealOf<Pack>>& task, RealOf<Pack>* state, const RealOf<Pack>* rows,
           ShellSums& sums) {
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
