// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/history_view.hpp"
#include "materials/common/ply_axes.hpp"
#include "materials/laws/orthotropic_elastic.hpp"

namespace crumple::materials {

/// The update of one pack by a law of plies that fail, which is an OrthotropicElasticLaw::Update with
///   PlaneStress stress_of(TurnedStiffness, PlyAxes, history, old stress, strain increment)
///   Real* gone(history)                              1 where the point carries no stress any more
template <class Law, class Pack>
CRUMPLE_INLINE void update_plies(const Law& law, const MaterialTask<RealOf<Pack>>& task, Index group,
                                 Index lane) {
  using Real = RealOf<Pack>;
  using History = HistoryView<Real>;
  Real* const state = task.state + group * task.group_stride + lane;
  const Index place = group * lanes + lane;
  const auto history_of = [&](int p) {
    return History{state + task.history * lanes, task.all_points, task.first_point + p};
  };
  const auto stiffness = law.turned(history_of(0));
  const PlyAxes<Pack> axes(history_of(0), 0);
  const Pack zero(Real(0));
  Pack energy = zero;
  Pack thickness = zero;
  Pack intact = zero;
  for (int p = 0; p < task.points; ++p) {
    const History history = history_of(p);
    Real* const stress_state = state + (task.stress + components * (task.first_point + p)) * lanes;
    const auto old = load_five<PlaneStress<Pack>>(stress_state, lanes);
    const auto increment =
        load_five<PlaneStrain<Pack>>(task.strain + p * components * tile_lanes + place, tile_lanes);
    const auto now = law.stress_of(stiffness, axes, history, old, increment);
    const Pack weight(task.weight[p]);
    Pack share = weight;
    if (task.area != nullptr) share = weight * load<Pack>(task.area + p * tile_lanes + place);
    energy = multiply_add(share, mean_work(old, now, increment), energy);
    thickness = multiply_add(weight, stiffness.lateral_strain(old, now), thickness);
    intact = larger(intact, Pack(Real(1)) - load<Pack>(law.gone(history)));
    store_five(stress_state, lanes, now);
  }
  store(task.energy + place, energy);
  store(task.thickness_strain + place, thickness);
  if (task.intact != nullptr) store(task.intact + place, intact);
  if (task.yield == nullptr) return;
  store(task.yield + yield_row::stress * tile_lanes + place, Pack(static_cast<Real>(unlimited)));
  store(task.yield + yield_row::left * tile_lanes + place, Pack(Real(1)));
}

}  // namespace crumple::materials
