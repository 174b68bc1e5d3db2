// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The loop over groups and points of solids, written once for all constitutive laws. Only kernels include it.
//
// A law is a class template over the pack with what tile_update.hpp asks of those of shells, with
// SolidStress, SolidStrain and SolidMaterialTask in the place of the shells', and
//   SolidElasticity<Real> elasticity                 or anything with stress(old, strain)
//   void turn_history(history, Turn)                 if can_yield: turns the tensors of the history

#include "materials/history_view.hpp"
#include "materials/solid_material.hpp"
#include "materials/solid_stress.hpp"

namespace crumple::materials {

/// Brings one point of one pack of solids up to date; returns where it is intact.
template <class Law, class Pack>
CRUMPLE_INLINE Pack update_solid_point(const Law& law, const SolidMaterialTask<RealOf<Pack>>& task,
                                       Index group, Index lane, int p) {
  using Real = RealOf<Pack>;
  const Index place = group * lanes + lane;
  Real* const state = task.state + group * task.group_stride + lane;
  Real* const stress_state = state + (task.stress + solid_components * p) * lanes;
  const auto strain =
      load_six<SolidStrain<Pack>>(task.strain + p * solid_components * tile_lanes + place, tile_lanes);
  const auto turn = load_turn<Pack>(task.turn + p * 9 * tile_lanes + place, tile_lanes);
  const auto old = turned(load_six<SolidStress<Pack>>(stress_state, lanes), turn);
  SolidStress<Pack> now = law.elasticity.stress(old, strain);
  Pack intact(Real(1));
  [[maybe_unused]] const HistoryView<Real> history{state + task.history * lanes, task.points, p};
  if constexpr (Law::can_yield) {
    law.turn_history(history, turn);
    auto trial = law.trial(now, strain, history);
    const auto mask = law.yields(trial);
    if (any<Pack>(mask)) law.correct(now, trial, mask, history);
  }
  if constexpr (Law::may_fail) {
    if (law.fails()) {
      const Pack zero(Real(0));
      const auto holds = law.intact(history);
      intact = select<Pack>(holds, intact, zero);
      now = {select<Pack>(holds, now.xx, zero), select<Pack>(holds, now.yy, zero),
             select<Pack>(holds, now.zz, zero), select<Pack>(holds, now.xy, zero),
             select<Pack>(holds, now.yz, zero), select<Pack>(holds, now.zx, zero)};
    }
  }
  store_six(stress_state, lanes, now);
  store(task.energy + p * tile_lanes + place, mean_work(old, now, strain));
  return intact;
}

/// Brings all points of a tile up to date.
template <class Law, class Pack>
void update_solids(const SolidMaterialTask<RealOf<Pack>>& task) {
  using Real = RealOf<Pack>;
  const Law law(task);
  for (Index group = 0; group < task.groups; ++group)
    for (Index lane = 0; lane < lanes; lane += width_of<Pack>) {
      Pack intact(Real(0));
      for (int p = 0; p < task.points; ++p)
        intact = larger(intact, update_solid_point<Law, Pack>(law, task, group, lane, p));
      if (task.intact != nullptr) store(task.intact + group * lanes + lane, intact);
    }
}

}  // namespace crumple::materials
