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
//   void begin_return(const Trial&, mask, history, Return&)
//                                                    the search for the stress on the yield surface
//   bool improve(Return&)                            a step of it; false at its end
//   void correct(stress, Trial&, mask, const Return&, history)
//                                                    puts the stress there in the lanes of the mask, updates
//                                                    the history, leaves plastic_zz
//   static constexpr bool may_fail                   false: nothing below is called
//   bool fails() const                               whether this material has a failure criterion at all
//   Mask intact(history) const                       points that still carry stress
// and, if it fails by strains,
//   void follow(history, strain) const               adds up strains in the plane
//   void thin(history, zz) const                     adds up those across
//   Pack judge(history) const                        1 where the point has failed, which stays so, else 0
//   void fail(history, mask) const                   makes it fail with the element
//   Real failing_points(int) const                   of so many points that make the element fail
// and, if the stress fades with the plastic strain,
//   Pack left(history) const                         share of the law's own stress that the point still has
// Elements hardly ever yield all at once: the trial is made for all points of a pack first, and one test
// decides whether any of them needs the correction. It then makes the trial again: that is cheaper than to
// keep it.

#include "materials/common/history_view.hpp"
#include "materials/common/plane_stress.hpp"
#include "materials/common/shell_material.hpp"

namespace crumple::materials {

/// One pack of elements of a tile, and the sums over its points. The stress in the state is brought up to
/// date in two goes: elastically for all points, then again for those that yield or have failed, which are
/// few.
template <class Law, class Pack>
struct PointUpdate {
  using Real = RealOf<Pack>;
  using Stress = PlaneStress<Pack>;
  using Strain = PlaneStrain<Pack>;

  const Law& law;
  const MaterialTask<Real>& task;
  Real* state;         ///< component 0
  Real* stress_state;  ///< of the first point
  const Real* strains;
  const Real* area;  ///< of the first point, or nullptr
  Pack energy;
  Pack thickness;     ///< strain zz
  Pack yield_stress;  ///< mean over the points
  Pack lost;          ///< mean over the points of what the return takes of the trial stress [-]

  CRUMPLE_INLINE PointUpdate(const Law& which, const MaterialTask<Real>& of, Index group, Index lane)
      : law(which),
        task(of),
        state(of.state + group * of.group_stride + lane),
        stress_state(state + (of.stress + components * of.first_point) * lanes),
        strains(of.strain + group * lanes + lane),
        area(of.area != nullptr ? of.area + group * lanes + lane : nullptr),
        energy(Real(0)),
        thickness(Real(0)),
        yield_stress(Real(0)),
        lost(Real(0)) {}

  CRUMPLE_INLINE HistoryView<Real> history(int p) const {
    return {state + task.history * lanes, task.all_points, task.first_point + p};
  }
  CRUMPLE_INLINE Stress stress(int p) const {
    return load_five<Stress>(stress_state + p * components * lanes, lanes);
  }
  CRUMPLE_INLINE void set_stress(int p, const Stress& stress) {
    store_five(stress_state + p * components * lanes, lanes, stress);
  }
  CRUMPLE_INLINE Strain strain(int p) const {
    return load_five<Strain>(strains + p * components * tile_lanes, tile_lanes);
  }
  CRUMPLE_INLINE Pack share(int p) const {
    const Pack weight(task.weight[p]);
    return area == nullptr ? weight : Pack(weight * load<Pack>(area + p * tile_lanes));
  }

  /// The elastic step of one point.
  CRUMPLE_INLINE Stress elastic_step(int p, const Strain& of) {
    const Stress old = stress(p);
    const Stress own = own_stress(law, old, history(p));
    const Stress now = law.elasticity.stress(own, of);
    if constexpr (requires { law.follow(history(p), of); }) law.follow(history(p), of);
    energy = multiply_add(share(p), mean_work(old, now, of), energy);
    count_thickness(p, own, now, Pack(Real(0)));
    set_stress(p, now);
    return now;
  }

  /// Puts another stress in the place of the present one.
  CRUMPLE_INLINE void replace(int p, const Stress& present, const Stress& now, const Pack& plastic_zz) {
    const Stress change{now.xx - present.xx, now.yy - present.yy, now.xy - present.xy, now.yz - present.yz,
                        now.zx - present.zx};
    energy = multiply_add(share(p), half_work(change, strain(p)), energy);
    count_thickness(p, present, now, plastic_zz);
    set_stress(p, now);
  }

  /// Takes the damage of the step's end from the law's own stress: the thickness follows the latter.
  CRUMPLE_INLINE void fade(int p) {
    const Stress own = stress(p);
    const Stress now = scaled(own, law.left(history(p)));
    const Stress change{now.xx - own.xx, now.yy - own.yy, now.xy - own.xy, now.yz - own.yz, now.zx - own.zx};
    energy = multiply_add(share(p), half_work(change, strain(p)), energy);
    set_stress(p, now);
  }

  /// Counts the yield stress of a point: zero of one that has failed.
  CRUMPLE_INLINE void count_yield(int p, const typename Law::Trial& trial) {
    Pack radius = trial.radius;
    if constexpr (Law::may_fail)
      if (law.fails()) radius = select<Pack>(law.intact(history(p)), radius, Pack(Real(0)));
    if constexpr (requires { law.left(history(p)); }) radius = law.left(history(p)) * radius;
    yield_stress = multiply_add(Pack(task.weight[p]), radius, yield_stress);
  }

  /// Counts what the return has left of the stress of a point. A small tension beside that stress is half
  /// sum, half difference, and returns with it.
  template <class Way>
  CRUMPLE_INLINE void count_return(int p, const MaskOf<Pack>& mask, const Way& way) {
    const Pack gone = Pack(Real(1)) - Pack(Real(0.5)) * (way.left.sum + way.left.rest);
    lost = multiply_add(Pack(task.weight[p]), select<Pack>(mask, gone, Pack(Real(0))), lost);
  }

  /// Leaves MaterialTask::yield.
  CRUMPLE_INLINE void leave_yield(Real* rows) const {
    const bool limited = Law::can_yield;
    store(rows + yield_row::stress * tile_lanes, limited ? yield_stress : Pack(static_cast<Real>(unlimited)));
    store(rows + yield_row::left * tile_lanes, Pack(Pack(Real(1)) - lost));
  }

  CRUMPLE_INLINE void count_thickness(int p, const Stress& old, const Stress& now, const Pack& plastic_zz) {
    const Pack sum = (now.xx - old.xx) + (now.yy - old.yy);
    const Pack zz = plastic_zz - Pack(law.elasticity.lateral) * sum;
    if constexpr (requires { law.thin(history(p), zz); }) law.thin(history(p), zz);
    thickness = multiply_add(Pack(task.weight[p]), zz, thickness);
  }
};

/// A point of which some lanes yield, on its way back to the yield surface. The state holds its trial stress.
template <class Law, class Pack>
struct YieldingPoint {
  int point;
  typename Law::Trial trial;
  MaskOf<Pack> mask;
  typename Law::Return way;
};

/// Returns the stress of some points, a step of one after a step of the other: each step is a chain of
/// operations that wait for each other, and several chains take hardly longer than one.
template <class Law, class Pack>
CRUMPLE_INLINE void return_together(PointUpdate<Law, Pack>& points, YieldingPoint<Law, Pack>* yielding,
                                    int count) {
  for (unsigned open = (1U << count) - 1U; open != 0;)
    for (int i = 0; i < count; ++i)
      if ((open & (1U << i)) != 0 && !points.law.improve(yielding[i].way)) open &= ~(1U << i);
  for (int i = 0; i < count; ++i) {
    YieldingPoint<Law, Pack>& y = yielding[i];
    const auto trial_stress = points.stress(y.point);
    auto stress = trial_stress;
    points.law.correct(stress, y.trial, y.mask, y.way, points.history(y.point));
    points.replace(y.point, trial_stress, stress, y.trial.plastic_zz);
    points.count_return(y.point, y.mask, y.way);
  }
}

/// Returns the stress of the points that yield.
template <class Law, class Pack>
CRUMPLE_INLINE void correct_points(PointUpdate<Law, Pack>& points) {
  constexpr int at_once = 4;
  YieldingPoint<Law, Pack> yielding[at_once];
  int count = 0;
  for (int p = 0; p < points.task.points; ++p) {
    YieldingPoint<Law, Pack>& y = yielding[count];
    y.trial = points.law.trial(points.stress(p), points.strain(p), points.history(p));
    y.mask = points.law.yields(y.trial);
    if (!any<Pack>(y.mask)) continue;
    y.point = p;
    points.law.begin_return(y.trial, y.mask, points.history(p), y.way);
    if (++count == at_once) {
      return_together(points, yielding, count);
      count = 0;
    }
  }
  if (count > 0) return_together(points, yielding, count);
}

/// Finds the points that have failed by their strains, and the elements of which enough have.
template <class Law, class Pack>
CRUMPLE_INLINE void judge_points(const PointUpdate<Law, Pack>& points) {
  const int count = points.task.points;
  Pack failed(RealOf<Pack>(0));
  for (int p = 0; p < count; ++p) failed = failed + points.law.judge(points.history(p));
  const MaskOf<Pack> enough = failed >= Pack(points.law.failing_points(count));
  if (!any<Pack>(enough)) return;
  for (int p = 0; p < count; ++p) points.law.fail(points.history(p), enough);
}

/// Takes the stress from points that have failed. Leaves whether any is intact.
template <class Law, class Pack>
CRUMPLE_INLINE void take_failed_stress(PointUpdate<Law, Pack>& points, RealOf<Pack>* intact) {
  using Real = RealOf<Pack>;
  const Pack zero(Real(0));
  Pack any_intact = zero;
  if constexpr (requires { points.law.judge(points.history(0)); }) judge_points(points);
  for (int p = 0; p < points.task.points; ++p) {
    const auto holds = points.law.intact(points.history(p));
    any_intact = select<Pack>(holds, Pack(Real(1)), any_intact);
    const auto stress = points.stress(p);
    const PlaneStress<Pack> left{select<Pack>(holds, stress.xx, zero), select<Pack>(holds, stress.yy, zero),
                                 select<Pack>(holds, stress.xy, zero), select<Pack>(holds, stress.yz, zero),
                                 select<Pack>(holds, stress.zx, zero)};
    points.replace(p, stress, left, zero);
  }
  store(intact, any_intact);
}

template <class Law, class Pack>
CRUMPLE_INLINE void update_pack(const Law& law, const MaterialTask<RealOf<Pack>>& task, Index group,
                                Index lane) {
  PointUpdate<Law, Pack> points(law, task, group, lane);
  [[maybe_unused]] bool any_yields = false;
  for (int p = 0; p < task.points; ++p) {
    const auto strain = points.strain(p);
    [[maybe_unused]] const auto stress = points.elastic_step(p, strain);
    if constexpr (Law::can_yield) {
      const auto trial = law.trial(stress, strain, points.history(p));
      points.count_yield(p, trial);
      any_yields |= any<Pack>(law.yields(trial));
    }
  }
  if constexpr (Law::can_yield)
    if (any_yields) correct_points(points);
  if constexpr (Law::may_fail)
    if (law.fails()) take_failed_stress(points, task.intact + group * lanes + lane);
  if constexpr (requires { law.left(points.history(0)); })
    for (int p = 0; p < task.points; ++p) points.fade(p);
  if (task.yield != nullptr) points.leave_yield(task.yield + group * lanes + lane);
  store(task.energy + group * lanes + lane, points.energy);
  store(task.thickness_strain + group * lanes + lane, points.thickness);
}

/// Brings all points of a tile up to date.
template <class Law, class Pack>
void update_tile(const MaterialTask<RealOf<Pack>>& task) {
  const Law law(task);
  for (Index group = 0; group < task.groups; ++group)
    for (Index lane = 0; lane < lanes; lane += width_of<Pack>) update_pack<Law, Pack>(law, task, group, lane);
}

/// The loop of laws that update packs on their own.
template <class Law, class Pack>
void update_own_tile(const MaterialTask<RealOf<Pack>>& task) {
  const Law law(task);
  for (Index group = 0; group < task.groups; ++group)
    for (Index lane = 0; lane < lanes; lane += width_of<Pack>) law.update(task, group, lane);
}

}  // namespace crumple::materials
