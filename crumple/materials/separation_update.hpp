// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The loop over groups and points of cohesive solids. Only kernels include it. A law is a class template over
// the pack with
//   static constexpr bool is_of_separations
//   SolidStress traction(separation, damage)   the tractions in xx, yy, zz; `damage` is one number per lane
//   Pack holds(failed)                         one where an element with so many failed points holds, else 0
// Its history is [point][3] separations and [point] damage.

#include "materials/common/history_view.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/common/solid_stress.hpp"
#include "math/pack_vec3.hpp"

namespace crumple::materials {

/// Brings one point up to date and leaves the work per area of the step; returns what the new traction has of
/// it.
template <class Law, class Pack>
CRUMPLE_INLINE Pack update_separation(const Law& law, const SolidMaterialTask<RealOf<Pack>>& task,
                                      Index place, RealOf<Pack>* state, int p) {
  using Real = RealOf<Pack>;
  Real* const before = state + (task.history + 3 * p) * lanes;
  Real* const damage = state + (task.history + 3 * task.points + p) * lanes;
  Real* const stress = state + (task.stress + solid_components * p) * lanes;
  const Real* const strain = task.strain + p * solid_components * tile_lanes + place;
  Pack separation[3];
  Pack more[3];
  for (int k = 0; k < 3; ++k) {
    separation[k] = load<Pack>(strain + k * tile_lanes);
    more[k] = separation[k] - load<Pack>(before + k * lanes);
    store(before + k * lanes, separation[k]);
  }
  const auto old = load_six<SolidStress<Pack>>(stress, lanes);
  const SolidStress<Pack> now = law.traction({separation[0], separation[1], separation[2]}, damage);
  store_six(stress, lanes, now);
  const auto half_work = [&](const SolidStress<Pack>& t) {
    return Pack(Real(0.5)) * multiply_add(t.xx, more[0], multiply_add(t.yy, more[1], Pack(t.zz * more[2])));
  };
  const Pack new_half = half_work(now);
  store(task.energy + p * tile_lanes + place, Pack(half_work(old) + new_half));
  return new_half;
}

/// Brings all points of a tile up to date. What goes loses all its tractions in this step.
template <class Law, class Pack>
void update_separations(const SolidMaterialTask<RealOf<Pack>>& task) {
  using Real = RealOf<Pack>;
  const Law law(task);
  const Pack one(Real(1));
  const Pack zero(Real(0));
  for (Index group = 0; group < task.groups; ++group)
    for (Index lane = 0; lane < lanes; lane += width_of<Pack>) {
      const Index place = group * lanes + lane;
      Real* const state = task.state + group * task.group_stride + lane;
      Pack new_half[max_solid_points];
      Pack failed = zero;
      for (int p = 0; p < task.points; ++p) {
        new_half[p] = update_separation<Law, Pack>(law, task, place, state, p);
        const Pack damage = load<Pack>(state + (task.history + 3 * task.points + p) * lanes);
        failed = failed + select<Pack>(damage < one, zero, one);
      }
      if (task.intact == nullptr) continue;
      const Pack intact = law.holds(failed);
      store(task.intact + place, intact);
      for (int p = 0; p < task.points; ++p) {
        for (int c = 0; c < 3; ++c) {
          Real* const traction = state + (task.stress + solid_components * p + c) * lanes;
          store(traction, select<Pack>(intact > zero, load<Pack>(traction), zero));
        }
        Real* const energy = task.energy + p * tile_lanes + place;
        store(energy, Pack(load<Pack>(energy) - select<Pack>(intact > zero, zero, new_half[p])));
      }
    }
}

}  // namespace crumple::materials
