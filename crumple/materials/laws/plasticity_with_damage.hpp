// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/failing_points.hpp"
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
  struct Update : PointsThatFail<Pack, Fading<Pack, PiecewiseLinearPlasticityLaw::Update<Pack>>, 2> {
    using Base = Fading<Pack, PiecewiseLinearPlasticityLaw::Update<Pack>>;
    using Counted = PointsThatFail<Pack, Base, 2>;
    using Counted::failed;
    using typename Base::History;
    using typename Base::Real;

    CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& task)
        : Counted(task, {task.constants[FailedPoints], task.constants[FailedShare]}) {}

    CRUMPLE_INLINE Pack judge(const History& history) const {
      const Pack mark = select<Pack>(Base::intact(history), load<Pack>(failed(history)), Pack(Real(1)));
      store(failed(history), mark);
      return mark;
    }
  };
};

}  // namespace crumple::materials
