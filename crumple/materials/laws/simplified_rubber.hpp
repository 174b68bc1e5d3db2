// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/laws/low_density_foam.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// A function of logarithmic strain on equal intervals, in which the origin is a point. Beyond the first and
/// the last its line goes on.
template <class Real>
struct EvenTable {
  const double* value;
  int count;
  int origin;           ///< number of the point at zero
  double per_interval;  ///< 1 / interval

  /// Value and derivative, lane by lane: a table in memory cannot be read at once at several places.
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> at(const Pack& x) const {
    constexpr int width = width_of<Pack>;
    alignas(Pack) Real place[width];
    alignas(Pack) Real found[width];
    alignas(Pack) Real slope[width];
    store(place, Pack(Pack(static_cast<Real>(per_interval)) * x));
    for (int lane = 0; lane < width; ++lane) {
      // NaN ends at the first point, and stays one in the value.
      const Real from_first = place[lane] + static_cast<Real>(origin);
      const bool inside = from_first >= Real(0);
      const bool beyond = from_first >= static_cast<Real>(count - 1);
      const int k = beyond ? count - 2 : inside ? static_cast<int>(from_first) : 0;
      const Real rise = static_cast<Real>(value[k + 1] - value[k]);
      const Real past = place[lane] - static_cast<Real>(k - origin);
      found[lane] = static_cast<Real>(value[k]) + past * rise;
      slope[lane] = static_cast<Real>(per_interval) * rise;
    }
    return {load<Pack>(found), load<Pack>(slope)};
  }
};

/// Rubber and foam by the curve of their uniaxial test (docs/theory/simplified_rubber.md).
struct SimplifiedRubberLaw : TotalDeformationLaw {
  using Model = model::SimplifiedRubber;
  static constexpr const char* name = "simplified rubber or foam";
  static const char* name_of(const model::ConstitutiveLaw& law) {
    return std::get<Model>(law).is_foam ? "simplified foam" : "simplified rubber";
  }
  static double linear_viscosity(const model::ConstitutiveLaw& law) { return std::get<Model>(law).damping; }

  static std::vector<double> constants(const model::Material& material);

  /// After Count: f at logarithmic strains from -range to range, each step wide `interval`.
  enum Place { Foam, Lateral, Bulk, PerDensity, Points, Count };
  static constexpr double range = 3;
  static constexpr int half_points = 1024;

  template <class Pack>
  struct SolidUpdate : TotalDeformation<Pack> {
    using Real = RealOf<Pack>;

    const double* c;

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task) : c(task.constants) {}

    CRUMPLE_INLINE YieldPoint<Pack> function(const Pack& log) const {
      return EvenTable<Real>{c + Count, 2 * half_points + 1, half_points, half_points / range}.at(log);
    }

    CRUMPLE_INLINE TotalStress<Pack> total(const Turn<Pack>& d) const {
      const PrincipalStretches<Pack> stretches = principal_stretches(d);
      Pack log[3];
      for (int k = 0; k < 3; ++k)
        log[k] = Pack(Real(0.34657359027997264)) * math::binary_log(stretches.square(k));
      return c[Foam] != 0 ? foam(stretches, log) : rubber(stretches, log);
    }

    /// J sigma_k = f(l_k) - f(J^(-nu / (1 - 2 nu))).
    CRUMPLE_INLINE TotalStress<Pack> foam(const PrincipalStretches<Pack>& stretches,
                                          const Pack (&log)[3]) const {
      const Pack lateral(static_cast<Real>(c[Lateral]));
      const YieldPoint<Pack> common = function(Pack(-(lateral * (log[0] + (log[1] + log[2])))));
      const Pack over =
          Pack(Real(1)) / larger(Pack(Pack(Real(1)) + stretches.volume_excess), Pack(Real(1e-6)));
      Pack stretch[3];
      Pack force[3];
      Pack value[3];
      Pack stiffness(Real(0));
      for (int k = 0; k < 3; ++k) {
        const YieldPoint<Pack> own = function(log[k]);
        stretch[k] = square_root(stretches.square(k));
        force[k] = own.stress - common.stress;
        value[k] = over * force[k];
        // Softening must not take the speed away.
        const Pack slope = multiply_add(lateral, absolute(common.slope), absolute(own.slope));
        stiffness = larger(stiffness, larger(Pack(slope - force[k]), Pack(Pack(Real(0.5)) * slope)));
      }
      stiffness = larger(stiffness, LowDensityFoamLaw::SolidUpdate<Pack>::shear_stiffness(stretch, force));
      return {in_axes(stretches.of, value), Pack(Pack(static_cast<Real>(c[PerDensity])) * stiffness)};
    }

    /// J sigma_k = f(l*_k) less the mean of all three, and the pressure of the volume.
    CRUMPLE_INLINE TotalStress<Pack> rubber(const PrincipalStretches<Pack>& stretches,
                                            const Pack (&log)[3]) const {
      const Pack third(Real(1.0 / 3.0));
      const Pack mean_log = third * (log[0] + (log[1] + log[2]));
      YieldPoint<Pack> of[3];
      for (int k = 0; k < 3; ++k) of[k] = function(Pack(log[k] - mean_log));
      const Pack mean = third * (of[0].stress + (of[1].stress + of[2].stress));
      const Pack mean_slope = third * (of[0].slope + (of[1].slope + of[2].slope));
      Pack dev[3];
      Pack curvature[3];
      for (int k = 0; k < 3; ++k) {
        dev[k] = of[k].stress - mean;
        curvature[k] = third * (of[k].slope + mean_slope);
      }
      return isochoric_stress(stretches, dev, curvature, static_cast<Real>(c[Bulk]),
                              static_cast<Real>(c[PerDensity]));
    }
  };
};

}  // namespace crumple::materials
