// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The loop over groups and points of solids, written once for all constitutive laws. Only kernels include it.
//
// A law is a class template over the pack with what tile_update.hpp asks of those of shells, with
// SolidStress, SolidStrain and SolidMaterialTask in the place of the shells', and
//   SolidElasticity<Real> elasticity                 or anything with stress(old, strain)
//   void turn_history(history, Turn)                 if can_yield: turns the tensors of the history
// and, if it needs them,
//   void follow(history, strain, Turn)               brings what follows the motion alone up to date
//   static constexpr bool takes_equation_of_state    true: with one, the law brings the deviator alone
//   Pack left(history) const                         as of shells
// A law of total deformation has no elasticity; it derives from TotalDeformation. A law whose stress is of
// the rate alone has_no_memory. Nor has a law whose history is the stress: it has
//   SolidStress relaxed(history, strain, Turn)       the new stress
// Nor has a law of rates whose wave speed varies. It has, with the old stress turned already,
//   TotalStress updated(old, strain, Turn, history)  the new stress and the square of the wave speed

#include "materials/common/history_view.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/common/solid_stress.hpp"
#include "materials/eos_update.hpp"

namespace crumple::materials {

/// Where failed points have lost their stress.
template <class Pack>
CRUMPLE_INLINE SolidStress<Pack> held_stress(const MaskOf<Pack>& holds, const SolidStress<Pack>& stress) {
  const Pack zero(RealOf<Pack>(0));
  return {select<Pack>(holds, stress.xx, zero), select<Pack>(holds, stress.yy, zero),
          select<Pack>(holds, stress.zz, zero), select<Pack>(holds, stress.xy, zero),
          select<Pack>(holds, stress.yz, zero), select<Pack>(holds, stress.zx, zero)};
}

/// Leaves the wave speed of point p: the element has that of its fastest point.
template <class Pack>
CRUMPLE_INLINE void leave_wave_speed(RealOf<Pack>* to, int p, const Pack& square) {
  if (to == nullptr) return;
  const Pack speed = square_root(square);
  store(to, p == 0 ? speed : larger(speed, load<Pack>(to)));
}

/// Work density of the step. Where strains are large and elastic, the nodal forces' own work is needed to
/// second order, 1/2 (V s : L of both ends) dt: the old stress as it was, and what mean gradients lack
/// (docs/theory/rubber.md).
template <class Law, class Pack>
CRUMPLE_INLINE Pack work_of(const SolidStress<Pack>& before, [[maybe_unused]] const SolidStress<Pack>& old,
                            const SolidStress<Pack>& now, const SolidStrain<Pack>& strain,
                            [[maybe_unused]] const Turn<Pack>& turn) {
  if constexpr (requires { Law::is_total; })
    return mean_work(before, now, strain) + end_work(before, now, step_gradient(strain, turn));
  else
    return mean_work(old, now, strain);
}

/// The stress of a law of total deformation.
template <class Law, class Pack>
CRUMPLE_INLINE auto total_stress(const Law& law, const SolidStrain<Pack>& strain, const Turn<Pack>& turn,
                                 const HistoryView<RealOf<Pack>>& history) {
  const Turn<Pack> deformation = Law::advance(history, strain, turn);
  if constexpr (requires { law.total(deformation, history, strain, turn); })
    return law.total(deformation, history, strain, turn);
  else if constexpr (requires { law.total(deformation, history, strain); })
    return law.total(deformation, history, strain);
  else
    return law.total(deformation);
}

/// What a law is given: the strain increment of the middle of the step where it follows the deformation
/// itself or the rate alone, else the one that goes with stresses which have been turned to the end of the
/// step.
template <class Law, class Pack>
CRUMPLE_INLINE SolidStrain<Pack> strain_for(const SolidStrain<Pack>& middle, const Turn<Pack>& turn) {
  if constexpr (
      requires { Law::is_total; } || requires { Law::has_no_memory; })
    return middle;
  else
    return turned_on(middle, turn);
}

/// Brings one point of one pack of solids up to date; returns where it is intact.
template <class Law, class Pack>
CRUMPLE_INLINE Pack update_solid_point(const Law& law, const SolidMaterialTask<RealOf<Pack>>& task,
                                       Index group, Index lane, int p) {
  using Real = RealOf<Pack>;
  const Index place = group * lanes + lane;
  Real* const state = task.state + group * task.group_stride + lane;
  Real* const stress_state = state + (task.stress + solid_components * p) * lanes;
  const auto middle =
      load_six<SolidStrain<Pack>>(task.strain + p * solid_components * tile_lanes + place, tile_lanes);
  const auto turn = load_turn<Pack>(task.turn + p * 9 * tile_lanes + place, tile_lanes);
  const auto strain = strain_for<Law>(middle, turn);
  const auto before = load_six<SolidStress<Pack>>(stress_state, lanes);
  const auto old = turned(before, turn);
  [[maybe_unused]] const HistoryView<Real> history{state + task.history * lanes, task.points, p};
  [[maybe_unused]] Real* const wave_speed = task.wave_speed == nullptr ? nullptr : task.wave_speed + place;
  SolidStress<Pack> now;
  if constexpr (requires { Law::is_total; }) {
    const auto total = total_stress(law, strain, turn, history);
    now = total.stress;
    leave_wave_speed(wave_speed, p, total.wave_square);
  } else if constexpr (requires { law.relaxed(history, strain, turn); }) {
    now = law.relaxed(history, strain, turn);
  } else if constexpr (requires { law.updated(old, strain, turn, history); }) {
    const auto updated = law.updated(old, strain, turn, history);
    now = updated.stress;
    leave_wave_speed(wave_speed, p, updated.wave_square);
  } else {
    now = law.elasticity.stress(own_stress(law, old, history), strain);
  }
  if constexpr (requires { law.follow(history, strain, turn); }) law.follow(history, strain, turn);
  Pack intact(Real(1));
  if constexpr (Law::can_yield) {
    law.turn_history(history, turn);
    auto trial = law.trial(now, strain, history);
    const auto mask = law.yields(trial);
    if (any<Pack>(mask)) law.correct(now, trial, mask, history);
  }
  if constexpr (requires { requires Law::takes_equation_of_state; }) {
    if (task.equation_of_state != nullptr) {
      const Pack viscosity = task.viscosity == nullptr ? Pack(Real(0)) : load<Pack>(task.viscosity + place);
      const auto result =
          EosUpdate<Pack>{task.equation_of_state, history}.apply(old, now, strain, turn, viscosity);
      now = result.stress;
      leave_wave_speed(wave_speed, p, result.wave_square);
    }
  }
  if constexpr (Law::may_fail) {
    if (law.fails()) {
      const auto holds = law.intact(history);
      intact = select<Pack>(holds, intact, Pack(Real(0)));
      now = held_stress<Pack>(holds, now);
    }
  }
  if constexpr (requires { law.left(history); }) now = scaled(now, law.left(history));
  store_six(stress_state, lanes, now);
  store(task.energy + p * tile_lanes + place, work_of<Law>(before, old, now, strain, turn));
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
