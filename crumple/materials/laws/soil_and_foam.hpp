// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/total_deformation.hpp"
#include "materials/laws/volume_history.hpp"
#include "materials/plasticity/yield_point.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Soil and foam whose pressure follows from the volume, and whose yield stress from the pressure
/// (docs/theory/soil_and_foam.md).
struct SoilAndFoamLaw {
  using Model = model::SoilAndFoam;
  static constexpr const char* name = "soil and foam";
  static constexpr bool wave_speed_varies = true;

  static void declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                              Index /*tensor*/) {
    declare_volume(block);
    domain::add_item(block, "largest_compression", "-", block.points);
  }
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }

  /// After Count: compression, pressure and slope behind it, point after point.
  enum Place { Shear, Unloading, Yield0, Yield1, Yield2, LeastPressure, Crushes, PerDensity, Points, Count };

  template <class Pack>
  struct SolidUpdate {
    using Real = RealOf<Pack>;
    using History = HistoryView<Real>;
    static constexpr bool can_yield = false;
    static constexpr bool may_fail = false;

    const double* c;

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task) : c(task.constants) {}

    CRUMPLE_INLINE Pack number(Place place) const { return Pack(static_cast<Real>(c[place])); }

    struct Pressure {
      Pack value, slope;  ///< positive in compression; slope of loading and of unloading, whichever is larger
    };
    /// At a compression -ln V.
    CRUMPLE_INLINE Pressure pressure(const Pack& compression, const History& history) const {
      const PointTable<Real> curve{c + Count, static_cast<int>(c[Points])};
      const Pack least = number(LeastPressure);
      if (c[Crushes] == 0) {
        const YieldPoint<Pack> at = curve.at(compression);
        return {larger(at.stress, least), at.slope};
      }
      Real* const place = history.at(2 * history.points + history.point);
      const Pack most = larger(load<Pack>(place), compression);
      store(place, most);
      const YieldPoint<Pack> at = curve.at(most);
      const Pack unloading = number(Unloading);
      return {larger(Pack(at.stress - unloading * (most - compression)), least), larger(at.slope, unloading)};
    }

    CRUMPLE_INLINE TotalStress<Pack> updated(const SolidStress<Pack>& old, const SolidStrain<Pack>& strain,
                                             const Turn<Pack>& turn, const History& history) const {
      const Pack zero(Real(0));
      const Pack one(Real(1));
      const Pack third(Real(1.0 / 3.0));
      const Pack volume = follow_volume(history, 0, strain, turn).now;
      const Pack compression = Pack(Real(-0.69314718055994531)) * math::binary_log(volume);
      const Pressure p = pressure(compression, history);
      // Deviator of the trial stress.
      const Pack g = number(Shear);
      const Pack g2 = g + g;
      const Pack mean = mean_stress(old) + g2 * (third * (strain.xx + (strain.yy + strain.zz)));
      const SolidStress<Pack> trial{multiply_add(g2, strain.xx, Pack(old.xx)) - mean,
                                    multiply_add(g2, strain.yy, Pack(old.yy)) - mean,
                                    multiply_add(g2, strain.zz, Pack(old.zz)) - mean,
                                    multiply_add(g, strain.xy, old.xy),
                                    multiply_add(g, strain.yz, old.yz),
                                    multiply_add(g, strain.zx, old.zx)};
      const Pack half_square = third * equivalent_square(trial);
      const Pack strength = larger(
          multiply_add(multiply_add(number(Yield2), p.value, number(Yield1)), p.value, number(Yield0)), zero);
      const auto yields = half_square > strength;
      const Pack scale =
          select<Pack>(yields, square_root(Pack(strength / select<Pack>(yields, half_square, one))), one);
      TotalStress<Pack> found;
      found.stress = {multiply_add(scale, trial.xx, Pack(-p.value)),
                      multiply_add(scale, trial.yy, Pack(-p.value)),
                      multiply_add(scale, trial.zz, Pack(-p.value)),
                      scale * trial.xy,
                      scale * trial.yz,
                      scale * trial.zx};
      const Pack stiffness = multiply_add(Pack(Real(4.0 / 3.0)), g, larger(p.slope, zero));
      found.wave_square = number(PerDensity) * (volume * stiffness);
      return found;
    }
  };
};

}  // namespace crumple::materials
