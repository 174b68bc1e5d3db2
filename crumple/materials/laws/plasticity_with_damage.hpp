// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/piecewise_linear_plasticity.hpp"

namespace crumple::materials {

/// Piecewise linear plasticity whose stress fades with the effective plastic strain p: it is 1 - w(p) times
/// that of the law without damage (*MAT_PLASTICITY_WITH_DAMAGE; docs/theory/plasticity_with_damage.md). As w
/// follows from p, there is no history of its own but the mark of failed points of shells.
struct PlasticityWithDamageLaw : PiecewiseLinearPlasticityLaw {
  static constexpr const char* name = "piecewise linear plasticity with damage";

  static bool takes(const model::ConstitutiveLaw& law) { return has_damage(std::get<Model>(law)); }
  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);

  /// Places of the damage: its table stands behind them, and behind that the constants without damage.
  enum DamagePlace { FailedPoints, FailedShare, DamageRows, Table };

  template <class Pack, class Undamaged>
  struct Fading : Undamaged {
    using typename Undamaged::Task;
    using History = HistoryView<RealOf<Pack>>;

    PointTable<RealOf<Pack>> damage;

    CRUMPLE_INLINE explicit Fading(const Task& task)
        : Undamaged(undamaged(task)),
          damage{task.constants + Table, static_cast<int>(task.constants[DamageRows])} {}
    CRUMPLE_INLINE static Task undamaged(Task task) {
      task.constants += Table + 3 * static_cast<int>(task.constants[DamageRows]);
      return task;
    }

    /// Never quite zero: what has not failed is divided by it again. Points fail by their plastic strain.
    CRUMPLE_INLINE Pack left(const History& history) const {
      constexpr auto least = RealOf<Pack>(1e-6);
      const Pack lost = damage.at(load<Pack>(Undamaged::plastic_strain(history))).stress;
      return larger(Pack(Pack(RealOf<Pack>(1)) - lost), Pack(least));
    }
  };

  template <class Pack>
  using SolidUpdate = Fading<Pack, PiecewiseLinearPlasticityLaw::SolidUpdate<Pack>>;

  /// A shell goes with a number of its points.
  template <class Pack>
  struct Update : Fading<Pack, PiecewiseLinearPlasticityLaw::Update<Pack>> {
    using Base = Fading<Pack, PiecewiseLinearPlasticityLaw::Update<Pack>>;
    using typename Base::History;
    using typename Base::Mask;
    using typename Base::Real;
    using typename Base::Strain;
    using typename Base::Stress;
    using typename Base::Trial;

    FailingPoints count;

    CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& task)
        : Base(task), count{task.constants[FailedPoints], task.constants[FailedShare]} {}

    CRUMPLE_INLINE static Real* failed(const History& history) {
      return history.at(2 * history.points + history.point);
    }
    CRUMPLE_INLINE static Mask intact(const History& history) {
      return load<Pack>(failed(history)) == Pack(Real(0));
    }
    CRUMPLE_INLINE Trial trial(const Stress& stress, const Strain& strain, const History& history) const {
      Trial t = Base::trial(stress, strain, history);
      t.radius = select<Pack>(intact(history), t.radius, Pack(Base::unreachable));
      return t;
    }
    CRUMPLE_INLINE Pack judge(const History& history) const {
      const Pack mark = select<Pack>(Base::intact(history), load<Pack>(failed(history)), Pack(Real(1)));
      store(failed(history), mark);
      return mark;
    }
    CRUMPLE_INLINE static void fail(const History& history, const Mask& mask) {
      store(failed(history), select<Pack>(mask, Pack(Real(1)), load<Pack>(failed(history))));
    }
    CRUMPLE_INLINE Real failing_points(int all) const { return static_cast<Real>(count.of(all)); }
  };
};

}  // namespace crumple::materials
