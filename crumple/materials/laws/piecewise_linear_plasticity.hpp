// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/plasticity/plane_stress_plasticity.hpp"
#include "materials/plasticity/solid_plasticity.hpp"

namespace crumple::materials {

/// Yield stress interpolated in a table over plastic strain, or between several of them over strain rate.
template <class Real>
struct TabulatedHardening {
  static constexpr bool rough = false;

  const double* curves;  ///< of each curve: its rate, its number of rows, the rows
  int curve_count;
  Real least_stress;
  bool logarithmic;  ///< rates are natural logarithms, and so is the interpolation
  Real per_step;     ///< 1 / dt; 0 for the slowest curve alone

  template <class Strain, class Pack>
  CRUMPLE_INLINE Pack aside(const Strain& /*strain*/, const Pack& factor) const {
    return curve_count == 1 ? factor : Pack(Real(0));
  }
  CRUMPLE_INLINE bool viscoplastic() const { return curve_count > 1; }

  /// `increment`: of the plastic strain in the step.
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> at(const Pack& strain, const Pack& increment) const {
    const double* curve = curves;
    YieldPoint<Pack> found = table(curve).at(strain);
    if (curve_count == 1) return found;
    const Pack rate = Pack(per_step) * increment;
    const Pack tiny(Real(1e-30));
    const Pack x =
        logarithmic ? Pack(Pack(Real(0.69314718055994531)) * math::binary_log(larger(rate, tiny))) : rate;
    // d x / d (plastic strain increment)
    Pack x_slope(per_step);
    if (logarithmic) x_slope = x_slope / larger(rate, tiny);
    YieldPoint<Pack> lower = found;
    for (int k = 1; k < curve_count; ++k) {
      const double from = curve[0];
      curve += 2 + 3 * static_cast<int>(curve[1]);
      const auto beyond = x > Pack(static_cast<Real>(from));
      if (!any<Pack>(beyond)) break;
      const YieldPoint<Pack> upper = table(curve).at(strain);
      const Pack one(Real(1));
      const Pack per_interval(static_cast<Real>(1 / (curve[0] - from)));
      const Pack share = per_interval * (x - Pack(static_cast<Real>(from)));
      const auto past = share >= one;
      const Pack weight = smaller(share, one);
      const Pack rise = upper.stress - lower.stress;
      const Pack by_rate = select<Pack>(past, Pack(Real(0)), Pack(rise * (per_interval * x_slope)));
      found.stress = select<Pack>(beyond, multiply_add(weight, rise, lower.stress), found.stress);
      const Pack slope = multiply_add(weight, Pack(upper.slope - lower.slope), lower.slope) + by_rate;
      found.slope = select<Pack>(beyond, slope, found.slope);
      lower = upper;
    }
    return found;
  }
  template <class Pack>
  CRUMPLE_INLINE Pack least(const Pack& /*aside*/) const {
    return Pack(least_stress);
  }

 private:
  CRUMPLE_INLINE static PointTable<Real> table(const double* curve) {
    return {curve + 2, static_cast<int>(curve[1])};
  }
};

/// Cowper & Symonds, or a factor interpolated in a curve over strain rate.
template <class Real>
struct TabulatedRate {
  CowperSymonds<Real> power;
  PointTable<Real> curve;  ///< no rows: the power
  Real per_step;           ///< 1 / dt; 0 switches the curve off
  bool viscoplastic;       ///< the rate is that of the plastic strain, for which the return solves

  CRUMPLE_INLINE TabulatedRate(const CowperSymonds<Real>& cowper_symonds, const PointTable<Real>& factors,
                               Real step)
      : power(cowper_symonds),
        curve(factors),
        per_step(step > 0 ? Real(1) / step : Real(0)),
        viscoplastic(factors.count > 0 || cowper_symonds.viscoplastic) {}

  template <template <class> class Strain, class Pack>
  CRUMPLE_INLINE Pack factor(const Strain<Pack>& strain) const {
    if (curve.count == 0) return power.factor(strain);
    return curve.at(Pack(Real(0))).stress;
  }

  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> raised(const YieldPoint<Pack>& rest, const Pack& increment) const {
    if (curve.count == 0) return power.raised(rest, increment);
    // The factor at rest is in the trial already.
    const Pack at_rest = curve.at(Pack(Real(0))).stress;
    const YieldPoint<Pack> now = curve.at(Pack(Pack(per_step) * increment));
    const Pack factor = now.stress / at_rest;
    return {factor * rest.stress,
            multiply_add(factor, rest.slope, Pack(rest.stress * (now.slope * Pack(per_step) / at_rest)))};
  }
};

/// J2 plasticity with tabulated isotropic hardening and rate effects
/// (docs/theory/plane_stress_plasticity.md).
struct PiecewiseLinearPlasticityLaw {
  using Model = model::PiecewiseLinearPlasticity;
  static constexpr const char* name = "piecewise linear plasticity";

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law) { return std::get<Model>(law).failure_strain > 0; }
  /// Throws Error if the number of failed points is none.
  static void require_failed_points(const model::Material& material, const Model& law);

  /// Places of the constants; the curve of factors follows, then the curves of hardening.
  enum Place { Youngs, Poissons, Rate, Exponent, Failure, Least, Base, Logarithmic, Factors, Curves, Rows };

  template <class Plasticity>
  struct UpdateOf : Plasticity {
    using typename Plasticity::Real;
    using typename Plasticity::Task;
    using Hardening = TabulatedHardening<Real>;
    using RateEffect = TabulatedRate<Real>;

    CRUMPLE_INLINE explicit UpdateOf(const Task& task)
        : Plasticity(task.constants[Youngs], task.constants[Poissons], 0, hardening_of(task), rate_of(task),
                     task.constants[Failure]) {}

    CRUMPLE_INLINE static Hardening hardening_of(const Task& task) {
      const double* const c = task.constants;
      return {c + Rows + 3 * static_cast<int>(c[Factors]), static_cast<int>(c[Curves]),
              static_cast<Real>(c[Least]), c[Logarithmic] != 0,
              task.step > 0 ? Real(1) / task.step : Real(0)};
    }
    CRUMPLE_INLINE static RateEffect rate_of(const Task& task) {
      const double* const c = task.constants;
      return {CowperSymonds<Real>(c[Rate], c[Exponent], task.step, true, c[Base]),
              PointTable<Real>{c + Rows, static_cast<int>(c[Factors])}, task.step};
    }
  };
  template <class Pack>
  using Update =
      UpdateOf<PlaneStressPlasticity<Pack, TabulatedHardening<RealOf<Pack>>, TabulatedRate<RealOf<Pack>>>>;
  template <class Pack>
  using SolidUpdate =
      UpdateOf<SolidPlasticity<Pack, TabulatedHardening<RealOf<Pack>>, TabulatedRate<RealOf<Pack>>>>;
};

}  // namespace crumple::materials
