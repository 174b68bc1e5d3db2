// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The loop over groups and thickness points, written once for all constitutive laws. Only kernels include it.
//
// A law is a class template over the pack with
//   explicit Update(const MaterialTask<Real>&)       reads its constants
//   PlaneStressElasticity<Real> elasticity           the elastic part
//   static constexpr bool can_yield                  false: nothing below is called
//   Trial trial(stress, strain, history)             what decides whether the trial stress is admissible
//   Mask yields(const Trial&)
//   void correct(stress, Trial&, mask, history)      returns the stress to the yield surface in the lanes of
//                                                    the mask, updates the history, leaves plastic_zz
//   static constexpr bool may_fail                   false: nothing below is called
//   bool fails() const                               whether this material has a failure criterion at all
//   Mask intact(history) const                       points that still carry stress
// Elements hardly ever yield all at once: the trial is made for all points of a pack first, and one test
// decides whether any of them needs the correction.

#include "materials/plane_stress.hpp"
#include "materials/shell_material.hpp"

namespace crumple::materials {

/// History of one point of one pack of elements: item numbers are counted in components of the law's own
/// items, as declare_history added them.
template <class Real>
struct HistoryView {
  Real* first;  ///< component 0 of the law's items, first lane of the pack
  int points;   ///< of the element, in plane and through the thickness
  int point;    ///< counted over all of these

  /// Address of component `component` of the law's items.
  CRUMPLE_INLINE Real* at(int component) const { return first + component * lanes; }
};

/// Takes the stress from points that have failed. Leaves whether any is intact.
template <class Law, class Pack, class History>
CRUMPLE_INLINE void take_failed_stress(const Law& law, const MaterialTask<RealOf<Pack>>& task,
                                       PlaneStress<Pack>* stress, const History& history,
                                       RealOf<Pack>* intact) {
  using Real = RealOf<Pack>;
  const Pack zero(Real(0));
  Pack any_intact = zero;
  for (int p = 0; p < task.points; ++p) {
    const auto holds = law.intact(history(p));
    any_intact = select<Pack>(holds, Pack(Real(1)), any_intact);
    stress[p] = {select<Pack>(holds, stress[p].xx, zero), select<Pack>(holds, stress[p].yy, zero),
                 select<Pack>(holds, stress[p].xy, zero), select<Pack>(holds, stress[p].yz, zero),
                 select<Pack>(holds, stress[p].zx, zero)};
  }
  store(intact, any_intact);
}

template <class Law, class Pack>
CRUMPLE_INLINE void update_pack(const Law& law, const MaterialTask<RealOf<Pack>>& task, Index group,
                                Index lane) {
  using Real = RealOf<Pack>;
  using Stress = PlaneStress<Pack>;
  using Strain = PlaneStrain<Pack>;
  Real* const state = task.state + group * task.group_stride + lane;
  Real* const stress_state = state + (task.stress + components * task.first_point) * lanes;
  const Real* const strains = task.strain + group * lanes + lane;

  [[maybe_unused]] const auto history = [&](int p) {
    return HistoryView<Real>{state + task.history * lanes, task.all_points, task.first_point + p};
  };

  Stress stress[max_points];
  [[maybe_unused]] typename Law::Trial trial[max_points];
  [[maybe_unused]] bool any_yields = false;
  for (int p = 0; p < task.points; ++p) {
    const auto old = load_five<Stress>(stress_state + p * components * lanes, lanes);
    const auto strain = load_five<Strain>(strains + p * components * tile_lanes, tile_lanes);
    stress[p] = law.elasticity.stress(old, strain);
    if constexpr (Law::can_yield) {
      trial[p] = law.trial(stress[p], strain, history(p));
      any_yields |= any<Pack>(law.yields(trial[p]));
    }
  }
  if constexpr (Law::can_yield)
    if (any_yields)
      for (int p = 0; p < task.points; ++p) {
        const auto mask = law.yields(trial[p]);
        if (any<Pack>(mask)) law.correct(stress[p], trial[p], mask, history(p));
      }
  if constexpr (Law::may_fail)
    if (law.fails())
      take_failed_stress<Law, Pack>(law, task, stress, history, task.intact + group * lanes + lane);

  Pack energy(Real(0));
  Pack thickness(Real(0));
  for (int p = 0; p < task.points; ++p) {
    const Pack weight(task.weight[p]);
    const auto old = load_five<Stress>(stress_state + p * components * lanes, lanes);
    const auto strain = load_five<Strain>(strains + p * components * tile_lanes, tile_lanes);
    Pack share = weight;
    if (task.area != nullptr) share = weight * load<Pack>(task.area + p * tile_lanes + group * lanes + lane);
    energy = multiply_add(share, mean_work(old, stress[p], strain), energy);
    const Pack sum = (stress[p].xx - old.xx) + (stress[p].yy - old.yy);
    Pack zz = -(Pack(law.elasticity.lateral) * sum);
    if constexpr (Law::can_yield) zz = zz + trial[p].plastic_zz;
    thickness = multiply_add(weight, zz, thickness);
    store_five(stress_state + p * components * lanes, lanes, stress[p]);
  }
  store(task.energy + group * lanes + lane, energy);
  store(task.thickness_strain + group * lanes + lane, thickness);
}

/// Brings all points of a tile up to date.
template <class Law, class Pack>
void update_tile(const MaterialTask<RealOf<Pack>>& task) {
  const Law law(task);
  for (Index group = 0; group < task.groups; ++group)
    for (Index lane = 0; lane < lanes; lane += width_of<Pack>) update_pack<Law, Pack>(law, task, group, lane);
}

}  // namespace crumple::materials
