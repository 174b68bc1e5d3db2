// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/history_view.hpp"
#include "materials/laws/orthotropic_elastic.hpp"

namespace crumple::materials {

/// Stresses in the plane along fibres, across, and their shear; or strains with the engineering shear.
template <class Pack>
struct PlyPlane {
  Pack a, b, ab;
};

/// Along the axes of the ply: cosine and sine are the first two components of the history.
template <class Pack>
struct PlyAxes {
  Pack cosine, sine;

  CRUMPLE_INLINE explicit PlyAxes(const HistoryView<RealOf<Pack>>& history)
      : cosine(load<Pack>(history.at(0))), sine(load<Pack>(history.at(1))) {}
  CRUMPLE_INLINE PlyPlane<Pack> stress(const PlaneStress<Pack>& s) const {
    const Pack cc = cosine * cosine;
    const Pack ss = sine * sine;
    const Pack sc = sine * cosine;
    const Pack twice = (sc + sc) * s.xy;
    return {multiply_add(cc, s.xx, multiply_add(ss, s.yy, twice)),
            multiply_add(ss, s.xx, multiply_add(cc, s.yy, Pack(-twice))),
            multiply_add(sc, Pack(s.yy - s.xx), Pack((cc - ss) * s.xy))};
  }
  CRUMPLE_INLINE PlyPlane<Pack> strain(const PlaneStrain<Pack>& e) const {
    const Pack cc = cosine * cosine;
    const Pack ss = sine * sine;
    const Pack sc = sine * cosine;
    const Pack share = sc * e.xy;
    return {multiply_add(cc, e.xx, multiply_add(ss, e.yy, share)),
            multiply_add(ss, e.xx, multiply_add(cc, e.yy, Pack(-share))),
            multiply_add(Pack(sc + sc), Pack(e.yy - e.xx), Pack((cc - ss) * e.xy))};
  }
  /// Adds a change of the stress in the axes of the ply.
  CRUMPLE_INLINE void add(const PlyPlane<Pack>& change, PlaneStress<Pack>& s) const {
    const Pack cc = cosine * cosine;
    const Pack ss = sine * sine;
    const Pack sc = sine * cosine;
    const Pack twice = (sc + sc) * change.ab;
    s.xx = s.xx + multiply_add(cc, change.a, multiply_add(ss, change.b, Pack(-twice)));
    s.yy = s.yy + multiply_add(ss, change.a, multiply_add(cc, change.b, twice));
    s.xy = s.xy + multiply_add(sc, Pack(change.a - change.b), Pack((cc - ss) * change.ab));
  }
};

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
  const PlyAxes<Pack> axes(history_of(0));
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
