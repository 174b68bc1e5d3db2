// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/pack.hpp"
#include "materials/common/history_view.hpp"

namespace crumple::materials {

/// The number of failed points that make a shell fail.
struct FailingPoints {
  double points, share;  ///< 0: all of them; the share goes first

  CRUMPLE_INLINE double of(int count) const {
    const double all = count;
    const double least = share > 0 ? share * all : points;
    return least > 0 && least < all ? least : all;
  }
};

/// The law `Law` of shells whose points fail each by itself, and which go when some of their points have
/// failed. The history has a mark for each point, 1 where it has failed, behind `Ahead` numbers a point. What
/// derives from it has judge(), which sets the marks.
template <class Pack, class Law, int Ahead>
struct PointsThatFail : Law {
  using typename Law::History;
  using typename Law::Mask;
  using typename Law::Real;
  using typename Law::Strain;
  using typename Law::Stress;
  using typename Law::Trial;

  FailingPoints count;

  template <class Task>
  CRUMPLE_INLINE PointsThatFail(const Task& task, const FailingPoints& points) : Law(task), count(points) {}

  CRUMPLE_INLINE static Real* failed(const History& history) {
    return history.at(Ahead * history.points + history.point);
  }
  CRUMPLE_INLINE static Mask intact(const History& history) {
    return load<Pack>(failed(history)) == Pack(Real(0));
  }
  CRUMPLE_INLINE Trial trial(const Stress& stress, const Strain& strain, const History& history) const {
    Trial t = Law::trial(stress, strain, history);
    t.radius = select<Pack>(intact(history), t.radius, Pack(Law::unreachable));
    return t;
  }
  CRUMPLE_INLINE static void fail(const History& history, const Mask& mask) {
    store(failed(history), select<Pack>(mask, Pack(Real(1)), load<Pack>(failed(history))));
  }
  CRUMPLE_INLINE Real failing_points(int all) const { return static_cast<Real>(count.of(all)); }
};

}  // namespace crumple::materials
