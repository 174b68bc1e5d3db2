// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/total_deformation.hpp"
#include "materials/laws/volume_history.hpp"
#include "materials/plasticity/cowper_symonds.hpp"
#include "materials/plasticity/three_surfaces.hpp"

namespace crumple::materials {

/// Concrete between three surfaces of strength, with a compaction curve for the pressure: the K&C model of
/// L.J. Malvar, J.E. Crawford, J.W. Wesevich & D. Simons, IJIE 19 (1997) 847-873
/// (docs/theory/three_surface_concrete.md).
struct ThreeSurfaceConcreteLaw {
  using Model = model::ThreeSurfaceConcrete;
  static constexpr const char* name = "concrete, three surfaces";
  static constexpr bool wave_speed_varies = true;

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static void prepare_solid_element(const model::ConstitutiveLaw& law, const SolidCorners& corners,
                                    UserId solid, domain::ElementBlock& block, Index history, Index place);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }

  /// Items of the history, a number a point each.
  enum Item {
    Volume = 0,    ///< two, of declare_volume()
    Dilation = 2,  ///< plastic volumetric strain of shear and of cracks
    Largest,       ///< largest compression, the dilation taken out
    Damage,        ///< lambda
    Softening,     ///< how many times as fast lambda grows behind the maximum
    Scaled,        ///< 2 lambda / (lambda + that of the maximum), for results alone
  };

  template <class Pack>
  struct SolidUpdate {
    using Real = RealOf<Pack>;
    using Mask = MaskOf<Pack>;
    using History = HistoryView<Real>;
    using Stress = SolidStress<Pack>;
    static constexpr bool can_yield = false;
    static constexpr bool may_fail = false;

    ThreeSurfaces<Pack> surfaces;
    Real per_step;

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : surfaces{task.constants}, per_step(task.step > 0 ? Real(1) / task.step : Real(0)) {}

    CRUMPLE_INLINE Pack number(int place) const { return surfaces.number(place); }
    CRUMPLE_INLINE static Real* one(const History& history, int item) {
      return history.at(item * history.points + history.point);
    }

    struct Pressure {
      Pack value, bulk, slope;  ///< bulk modulus of unloading; the larger one of both directions
    };
    /// At a compression from which the dilation has been taken.
    CRUMPLE_INLINE Pressure pressure(const Pack& compression, const History& history) const {
      Real* const place = one(history, Largest);
      const Pack most = larger(load<Pack>(place), compression);
      store(place, most);
      const YieldPoint<Pack> at = surfaces.table(SurfacesCompaction, SurfacesPoints).at(most);
      const Pack bulk = surfaces.table(SurfacesUnloading, SurfacesPoints).at(most).stress;
      return {at.stress - bulk * (most - compression), bulk, larger(at.slope, bulk)};
    }

    /// Opens cracks where the pressure is below the one at which the surface ends.
    CRUMPLE_INLINE void open(Pressure& p, const Pack& size, const Pack& rate_factor,
                             const History& history) const {
      const Pack zero(Real(0));
      Real* const place = one(history, Damage);
      const Pack damage = load<Pack>(place);
      const Pack least = -(number(SurfacesTension) * (rate_factor * surfaces.held(damage)));
      const Pack opened = larger(Pack(least - p.value), zero) / p.bulk;
      if (!any<Pack>(opened > zero)) return;
      const Pack tenth(Real(0.1));
      const Pack ratio = size / larger(Pack(-p.value), Pack(ThreeSurfaces<Pack>::tiny));
      const Pack alike = larger(Pack(tenth - ratio), zero) / tenth;
      const Pack faster = surfaces.speed(damage, load<Pack>(one(history, Softening)));
      store(place, multiply_add(number(SurfacesOpening), Pack(alike * (faster * opened)), damage));
      Real* const dilation = one(history, Dilation);
      store(dilation, load<Pack>(dilation) + opened);
      p.value = larger(p.value, least);
    }

    CRUMPLE_INLINE TotalStress<Pack> updated(const Stress& old, const SolidStrain<Pack>& strain,
                                             const Turn<Pack>& turn, const History& history) const {
      const Pack third(Real(1.0 / 3.0));
      const Pack volume = follow_volume(history, Volume, strain, turn).now;
      const Pack compression = Pack(Real(-0.69314718055994531)) * math::binary_log(volume);
      Pressure p = pressure(Pack(compression + load<Pack>(one(history, Dilation))), history);
      const Pack g = number(SurfacesShear) * p.bulk;
      const Pack g2 = g + g;
      const Pack mean = mean_stress(old) + g2 * (third * (strain.xx + (strain.yy + strain.zz)));
      const Stress trial{multiply_add(g2, strain.xx, Pack(old.xx)) - mean,
                         multiply_add(g2, strain.yy, Pack(old.yy)) - mean,
                         multiply_add(g2, strain.zz, Pack(old.zz)) - mean,
                         multiply_add(g, strain.xy, old.xy),
                         multiply_add(g, strain.yz, old.yz),
                         multiply_add(g, strain.zx, old.zx)};
      const Pack size = square_root(equivalent_square(trial));
      const Pack factor = rate_factor(p.value, strain);
      open(p, size, factor, history);
      const Pack scale = flow({trial, size, compression, factor}, p, history);
      const Pack damage = load<Pack>(one(history, Damage));
      store(one(history, Scaled), Pack(damage + damage) / (damage + number(SurfacesPeakDamage)));
      TotalStress<Pack> found;
      found.stress = {multiply_add(scale, trial.xx, Pack(-p.value)),
                      multiply_add(scale, trial.yy, Pack(-p.value)),
                      multiply_add(scale, trial.zz, Pack(-p.value)),
                      scale * trial.xy,
                      scale * trial.yz,
                      scale * trial.zx};
      const Pack stiffness = multiply_add(Pack(Real(4.0 / 3.0)), g, p.slope);
      found.wave_square = number(SurfacesPerDensity) * (volume * stiffness);
      return found;
    }

    CRUMPLE_INLINE Pack rate_factor(const Pack& p, const SolidStrain<Pack>& strain) const {
      if (surfaces.c[SurfacesTensionRows] == 0) return Pack(Real(1));
      return surfaces.rate_factor(p, Pack(Pack(per_step) * effective_strain(strain)));
    }

    struct Trial {
      Stress deviator;
      Pack size, compression, rate_factor;
    };
    /// What is left of the trial deviator; the pressure that dilation adds goes to `p`.
    CRUMPLE_INLINE Pack flow(const Trial& trial, Pressure& p, const History& history) const {
      const Pack whole(Real(1));
      Real* const place = one(history, Damage);
      const Pack damage = load<Pack>(place);
      const Pack& factor = trial.rate_factor;
      const Pack pressed = p.value / factor;
      const Pack size = trial.size / factor;
      // Half of the strength in triaxial compression is within the surface at every angle.
      const auto at = surfaces.strength(pressed, damage);
      if (!any<Pack>(size > Pack(Real(0.5)) * at.value)) return whole;
      const Pack cosine = angle(trial.deviator, trial.size);
      const Pack ratio = surfaces.ratio(pressed, cosine);
      const Mask yields = size > ratio * at.value;
      if (!any<Pack>(yields)) return whole;
      const Pack share = number(SurfacesDilatancy) * surfaces.held(damage);
      const typename ThreeSurfaces<Pack>::Flow now{pressed,
                                                   size,
                                                   ratio,
                                                   damage,
                                                   share * (ratio * at.slope),
                                                   p.bulk / factor,
                                                   load<Pack>(one(history, Softening)),
                                                   factor};
      const auto end = surfaces.returned(now, Pack(ratio * at.slope), yields);
      store(place, end.damage);
      Real* const dilation = one(history, Dilation);
      const Pack total = load<Pack>(dilation) + now.volume * end.strain;
      store(dilation, total);
      const Pressure last = pressure(Pack(trial.compression + total), history);
      p.value = select<Pack>(yields, last.value, p.value);
      p.slope = larger(p.slope, last.slope);
      const Pack after = p.value / factor;
      const Pack bound = surfaces.ratio(after, cosine) * surfaces.strength(after, end.damage).value;
      const Pack scale = smaller(Pack(bound / larger(size, Pack(ThreeSurfaces<Pack>::tiny))), whole);
      return select<Pack>(yields, scale, whole);
    }

    /// Cosine of the angle from the meridian of tension. Not inline: the rotations are long.
    static Pack angle(const Stress& deviator, const Pack& size) {
      const Pack most = largest_principal(deviator);
      const Pack cosine = Pack(Real(1.5)) * most / larger(size, Pack(ThreeSurfaces<Pack>::tiny));
      return smaller(larger(cosine, Pack(Real(0.5))), Pack(Real(1)));
    }
  };
};

}  // namespace crumple::materials
