// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/common/deformation.hpp"
#include "materials/laws/failing_points.hpp"
#include "materials/laws/piecewise_linear_plasticity.hpp"

namespace crumple::materials {

/// Piecewise linear plasticity of shells whose points also fail by thinning and by the major strain in the
/// plane, and which go when some of their points have failed (docs/theory/plane_stress_plasticity.md).
struct StrainLimitedPlasticityLaw : PiecewiseLinearPlasticityLaw {
  static constexpr const char* name = "piecewise linear plasticity with strain limits";

  static bool takes(const model::ConstitutiveLaw& law) { return has_strain_limits(std::get<Model>(law)); }
  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return true; }

  /// The limits; then follow those of the law without them.
  enum Limit { Thinning, Major, Points, Share, Limits };

  template <class Pack>
  struct Update : PointsThatFail<Pack, PiecewiseLinearPlasticityLaw::Update<Pack>, 4> {
    using Base = PiecewiseLinearPlasticityLaw::Update<Pack>;
    using Counted = PointsThatFail<Pack, Base, 4>;
    using Counted::failed;
    using typename Base::History;
    using typename Base::Real;
    using typename Base::Strain;

    Real thinning, major;  ///< at failure

    CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& task)
        : Counted(rest_of(task), {task.constants[Points], task.constants[Share]}),
          thinning(static_cast<Real>(task.constants[Thinning])),
          major(static_cast<Real>(task.constants[Major])) {}
    CRUMPLE_INLINE static MaterialTask<Real> rest_of(MaterialTask<Real> task) {
      task.constants += Limits;
      return task;
    }

    CRUMPLE_INLINE static Real* thinned(const History& history) {
      return history.at(2 * history.points + history.point);
    }
    /// xx, yy and xy of the strain in the plane.
    CRUMPLE_INLINE static Real* plane_strain(const History& history, int component) {
      return history.at(5 * history.points + 3 * history.point + component);
    }

    CRUMPLE_INLINE static bool fails() { return true; }

    CRUMPLE_INLINE void follow(const History& history, const Strain& strain) const {
      const Pack* const growth[] = {&strain.xx, &strain.yy, &strain.xy};
      for (int k = 0; k < 3; ++k)
        add_kept(plane_strain(history, k), plane_strain(history, k) + 3 * lanes * history.points, *growth[k]);
    }
    CRUMPLE_INLINE static void thin(const History& history, const Pack& zz) {
      add_kept(thinned(history), thinned(history) + lanes * history.points, zz);
    }

    CRUMPLE_INLINE Pack judge(const History& history) const {
      const Pack one(Real(1));
      const Pack half(Real(0.5));
      Pack mark = load<Pack>(failed(history));
      if (Base::fails()) mark = select<Pack>(Base::intact(history), mark, one);
      if (thinning > 0) mark = select<Pack>(load<Pack>(thinned(history)) > Pack(-thinning), mark, one);
      if (major > 0) {
        const Pack xx = load<Pack>(plane_strain(history, 0));
        const Pack yy = load<Pack>(plane_strain(history, 1));
        const Pack xy = load<Pack>(plane_strain(history, 2));
        const Pack apart = xx - yy;
        const Pack radius = square_root(multiply_add(apart, apart, Pack(xy * xy)));
        const Pack largest = half * ((xx + yy) + radius);
        mark = select<Pack>(largest < Pack(major), mark, one);
      }
      store(failed(history), mark);
      return mark;
    }
  };
};

}  // namespace crumple::materials
