// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/pack.hpp"
#include "elements/common/element_sums.hpp"
#include "elements/common/lane_sums.hpp"

namespace crumple::elements {

/// Where erode() finds what it reads and writes of one group, at its first lane.
template <class Real>
struct ErosionPlace {
  Real* active;        ///< state item
  Real* energy;        ///< state items: internal energy, then hourglass energy of the element
  const Real* rows;    ///< the driver's scratch, see sum_row
  const Real* intact;  ///< [plane][tile_lanes] from the material
  int planes = 1;
};

/// Switches off the elements of one group all of whose points have failed, after their forces have been made
/// of stresses that are zero already: so the last work is still counted. Keeps the energy of each element,
/// that it may be told apart when the element goes.
template <class Pack>
void erode(const ErosionPlace<RealOf<Pack>>& place, const GroupSums& group, ElementSums& sums) {
  using Real = RealOf<Pack>;
  Index eroded = 0;
  const auto book = [&](Real internal, Real hourglass) {
    group.energy->internal -= static_cast<double>(internal);
    group.energy->hourglass -= static_cast<double>(hourglass);
    group.energy->eroded += static_cast<double>(internal) + static_cast<double>(hourglass);
  };
  for (Index lane = 0; lane < lanes; ++lane) {
    Real* const internal = place.energy + lane;
    Real* const hourglass = internal + lanes;
    const Real internal_now = place.rows[sum_row::internal_energy * materials::tile_lanes + lane];
    const Real hourglass_now = place.rows[sum_row::hourglass_energy * materials::tile_lanes + lane];
    *internal += internal_now;
    *hourglass += hourglass_now;
    if (place.active[lane] == Real(0)) {
      // Viscous and hourglass forces of the step of failure still act until the next one.
      book(internal_now, hourglass_now);
      continue;
    }
    bool intact = false;
    for (int plane = 0; plane < place.planes; ++plane)
      intact = intact || place.intact[plane * materials::tile_lanes + lane] != Real(0);
    if (intact) continue;
    place.active[lane] = Real(0);
    book(*internal, *hourglass);
    ++eroded;
  }
  if (eroded == 0) return;
  sums.eroded += eroded;
  // What has just gone may have had the shortest step.
  if (group.shortest_step != nullptr) *group.shortest_step = -*group.shortest_step;
}

}  // namespace crumple::elements
