// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/principal_stretches.hpp"
#include "materials/plasticity/yield_point.hpp"

namespace crumple::materials {

/// Foam that springs back, with its principal stresses uncoupled (docs/theory/low_density_foam.md).
struct LowDensityFoamLaw {
  using Model = model::LowDensityFoam;
  static constexpr const char* name = "low density foam";
  static constexpr bool wave_speed_varies = true;

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }
  static double linear_viscosity(const model::ConstitutiveLaw& law) { return std::get<Model>(law).damping; }

  /// After Count, point after point of the curve: compression, stress, slope and energy below it. Then of
  /// each faster curve its rate, its number of points, and these: compression, stress and slope.
  enum Place {
    Youngs,
    Tension,
    Tears,
    UnloadingFactor,
    Shape,
    PerDensity,
    Slowest,
    Engineering,
    Faster,
    Points,
    Count
  };
  static constexpr int row = 4;
  /// Share of a step's rate in the mean that counts.
  static constexpr double newest = 1.0 / 12;

  template <class Pack>
  struct SolidUpdate : TotalDeformation<Pack> {
    using Real = RealOf<Pack>;
    using History = HistoryView<Real>;

    const double* c;
    bool unloads;   ///< by another curve than it loads: the largest energy is in the state
    bool tears;     ///< torn points are marked in the state
    int faster;     ///< curves at higher rates: the rate is in the state
    Real per_step;  ///< 1 / dt; 0 without a step

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : c(task.constants),
          unloads(task.constants[UnloadingFactor] < 1),
          tears(task.constants[Tears] != 0),
          faster(static_cast<int>(task.constants[Faster])),
          per_step(task.step > 0 ? Real(1) / task.step : Real(0)) {}

    CRUMPLE_INLINE Pack number(Place place) const { return Pack(static_cast<Real>(c[place])); }
    CRUMPLE_INLINE static Real* largest_energy(const History& history) {
      return history.at(18 * history.points + history.point);
    }
    CRUMPLE_INLINE Real* torn(const History& history) const {
      return history.at((unloads ? 19 : 18) * history.points + history.point);
    }
    CRUMPLE_INLINE Real* mean_rate(const History& history) const {
      return history.at((18 + (unloads ? 1 : 0) + (tears ? 1 : 0)) * history.points + history.point);
    }

    struct CurvePoint {
      Pack stress, slope, energy;
    };
    /// The curve in compression, which starts at the origin.
    CRUMPLE_INLINE CurvePoint curve(const Pack& compression) const {
      const double* at = c + Count;
      const int points = static_cast<int>(c[Points]);
      const auto take = [&](int which) { return Pack(static_cast<Real>(at[which])); };
      Pack from = take(0);
      CurvePoint start{take(1), take(2), take(3)};
      for (int k = 1; k < points; ++k) {
        at += row;
        const auto beyond = compression > take(0);
        if (!any<Pack>(beyond)) break;
        from = select<Pack>(beyond, take(0), from);
        start.stress = select<Pack>(beyond, take(1), start.stress);
        start.slope = select<Pack>(beyond, take(2), start.slope);
        start.energy = select<Pack>(beyond, take(3), start.energy);
      }
      const Pack past = compression - from;
      const Pack stress = multiply_add(start.slope, past, start.stress);
      const Pack middle = Pack(Real(0.5)) * (stress + start.stress);
      return {stress, start.slope, multiply_add(middle, past, start.energy)};
    }

    /// Share of the curve's stress that is there, and its derivative by the energy as if it unloaded.
    struct Share {
      Pack factor, slope;
    };
    CRUMPLE_INLINE Share share(const Pack& energy, const History& history) const {
      const Pack one(Real(1));
      if (!unloads) return {one, Pack(Real(0))};
      const Pack most = larger(load<Pack>(largest_energy(history)), energy);
      store(largest_energy(history), most);
      constexpr Real tiny = sizeof(Real) == sizeof(float) ? Real(1e-30) : Real(1e-200);
      const Pack part = energy / larger(most, Pack(tiny));
      const Pack grown = math::power(part, number(Shape));
      const Pack rest = one - number(UnloadingFactor);
      // Nothing is stored, nothing has been: the curve itself.
      const auto fresh = most <= Pack(tiny);
      const Pack factor = select<Pack>(fresh, one, multiply_add(rest, grown, number(UnloadingFactor)));
      return {factor, Pack(rest * number(Shape) * grown / larger(energy, Pack(tiny)))};
    }

    /// The fastest compression along a principal axis, as a running mean.
    CRUMPLE_INLINE Pack rate(const PrincipalStretches<Pack>& stretches, const Pack (&stretch)[3],
                             const SolidStrain<Pack>& e, const History& history) const {
      Pack fastest(Real(0));
      for (int k = 0; k < 3; ++k) {
        const Pack x = stretches.of.axis[0][k];
        const Pack y = stretches.of.axis[1][k];
        const Pack z = stretches.of.axis[2][k];
        Pack along = (e.xy * x) * y + ((e.yz * y) * z + (e.zx * z) * x);
        along = multiply_add(Pack(e.xx * x), x,
                             multiply_add(Pack(e.yy * y), y, multiply_add(Pack(e.zz * z), z, along)));
        if (c[Engineering] != 0) along = along * stretch[k];
        fastest = larger(fastest, Pack(-along));
      }
      const Pack old = load<Pack>(mean_rate(history));
      const Pack now =
          multiply_add(Pack(static_cast<Real>(newest)), Pack(Pack(per_step) * fastest - old), old);
      store(mean_rate(history), now);
      return now;
    }

    /// What a rate adds to the stress of the slowest curve, and its derivatives.
    struct Excess {
      Pack stress, slope, by_rate;
    };
    CRUMPLE_INLINE Excess excess_at(const Pack& compression, const CurvePoint& slow, const Pack& rate) const {
      const Pack zero(Real(0));
      const Pack one(Real(1));
      const double* at = c + Count + row * static_cast<int>(c[Points]);
      double from = c[Slowest];
      Pack stress = slow.stress;
      Pack slope = slow.slope;
      Excess found{zero, zero, zero};
      for (int k = 0; k < faster; ++k) {
        const auto beyond = rate > Pack(static_cast<Real>(from));
        if (!any<Pack>(beyond)) break;
        const int points = static_cast<int>(at[1]);
        const YieldPoint<Pack> upper = PointTable<Real>{at + 2, points}.at(compression);
        const Pack per_interval(static_cast<Real>(1 / (at[0] - from)));
        const Pack share = per_interval * (rate - Pack(static_cast<Real>(from)));
        const Pack weight = smaller(share, one);
        const Pack rise = upper.stress - stress;
        found.stress =
            select<Pack>(beyond, Pack(multiply_add(weight, rise, stress) - slow.stress), found.stress);
        found.slope = select<Pack>(
            beyond, Pack(multiply_add(weight, Pack(upper.slope - slope), slope) - slow.slope), found.slope);
        found.by_rate =
            select<Pack>(beyond, select<Pack>(share < one, Pack(per_interval * rise), zero), found.by_rate);
        stress = upper.stress;
        slope = upper.slope;
        from = at[0];
        at += 2 + 3 * points;
      }
      // Curves that cross would give energy away.
      const auto adds = found.stress > zero;
      return {select<Pack>(adds, found.stress, zero), select<Pack>(adds, found.slope, zero),
              select<Pack>(adds, larger(found.by_rate, zero), zero)};
    }

    /// What the stretches alone say, axis by axis.
    struct Axes {
      Pack stretch[3];
      Pack compression[3];
      CurvePoint compressed[3];
      Pack tension[3];  ///< nominal, as if it had no bound
      Pack energy;      ///< below the curve, of all axes
    };
    CRUMPLE_INLINE Axes axes(const PrincipalStretches<Pack>& stretches) const {
      const Pack zero(Real(0));
      Axes found{};
      found.energy = zero;
      for (int k = 0; k < 3; ++k) {
        found.stretch[k] = square_root(stretches.square(k));
        const Pack excess = stretches.square_excess(k) / (Pack(Real(1)) + found.stretch[k]);
        found.compression[k] = larger(Pack(-excess), zero);
        found.compressed[k] = curve(found.compression[k]);
        found.energy = found.energy + found.compressed[k].energy;
        found.tension[k] = number(Youngs) * larger(excess, zero);
      }
      return found;
    }

    /// Bound of the nominal stress in tension: none is left once a point has torn.
    CRUMPLE_INLINE Pack strength(const Axes& of, const History& history) const {
      const Pack zero(Real(0));
      const Pack bound = number(Tension);
      if (!tears) return bound;
      const Pack most = larger(of.tension[0], larger(of.tension[1], of.tension[2]));
      const Pack mark = select<Pack>(most > bound, Pack(Real(1)), load<Pack>(torn(history)));
      store(torn(history), mark);
      return select<Pack>(mark > zero, zero, bound);
    }

    CRUMPLE_INLINE TotalStress<Pack> total(const Turn<Pack>& d, const History& history,
                                           const SolidStrain<Pack>& strain) const {
      const PrincipalStretches<Pack> stretches = principal_stretches(d);
      const Pack zero(Real(0));
      const Axes of = axes(stretches);
      const Pack bound = strength(of, history);
      const Share held = share(of.energy, history);
      Excess more[3] = {{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
      if (faster > 0) {
        const Pack speed = rate(stretches, of.stretch, strain, history);
        for (int k = 0; k < 3; ++k) more[k] = excess_at(of.compression[k], of.compressed[k], speed);
      }
      Pack value[3];
      Pack force[3];  // stretch times nominal stress
      Pack stiffness = Pack(Real(0.01)) * number(Youngs);
      const Pack over =
          Pack(Real(1)) / larger(Pack(Pack(Real(1)) + stretches.volume_excess), Pack(Real(1e-6)));
      for (int k = 0; k < 3; ++k) {
        const CurvePoint& at = of.compressed[k];
        force[k] = of.stretch[k] *
                   (smaller(of.tension[k], bound) - multiply_add(held.factor, at.stress, more[k].stress));
        value[k] = over * force[k];
        // The slope of loading or of unloading, whichever is steeper; a viscosity acts as a stiffness over
        // the step.
        const Pack viscous = Pack(Pack(static_cast<Real>(newest)) * Pack(per_step)) * more[k].by_rate;
        Pack slope = multiply_add(held.slope, Pack(at.stress * at.stress), Pack(held.factor * at.slope));
        slope = select<Pack>(of.tension[k] > zero, number(Youngs), Pack(slope + (more[k].slope + viscous)));
        stiffness = larger(stiffness, Pack((of.stretch[k] * of.stretch[k]) * slope));
      }
      stiffness = larger(stiffness, shear_stiffness(of.stretch, force));
      return {in_axes(stretches.of, value), Pack(number(PerDensity) * stiffness)};
    }

    /// Of transverse waves along the principal axes (R.W. Ogden, Non-Linear Elastic Deformations (1984),
    /// section 6.3): l_i^2 (l_i S_i - l_j S_j) / (l_i^2 - l_j^2).
    CRUMPLE_INLINE static Pack shear_stiffness(const Pack (&stretch)[3], const Pack (&force)[3]) {
      const Pack zero(Real(0));
      Pack largest = zero;
      constexpr int pairs[3][2] = {{0, 1}, {1, 2}, {2, 0}};
      for (const auto& [i, j] : pairs) {
        const Pack first = stretch[i] * stretch[i];
        const Pack second = stretch[j] * stretch[j];
        const Pack apart = first - second;
        const Pack size = larger(first, second);
        // Nearly equal stretches: longitudinal waves are faster.
        const auto differ = absolute(apart) > Pack(Pack(Real(1e-3)) * size);
        const Pack share = (force[i] - force[j]) / select<Pack>(differ, apart, Pack(Real(1)));
        largest = larger(largest, select<Pack>(differ, Pack(size * share), zero));
      }
      return largest;
    }
  };
};

}  // namespace crumple::materials
