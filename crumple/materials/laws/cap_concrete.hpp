// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/common/history_view.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/laws/total_deformation.hpp"
#include "materials/plasticity/cap_surface.hpp"
#include "materials/plasticity/concrete_damage.hpp"

namespace crumple::materials {

/// Concrete by the continuous surface cap model of L.E. Schwer & Y.D. Murray, with damage and rate effects
/// (docs/theory/cscm_concrete.md).
///
/// The state has the stress that is left of the one with rate effects. What is lost stands in the history, so
/// that the latter comes back by a division, and so does what rates add, so that the stress without them is
/// their difference.
struct CapConcreteLaw {
  using Model = model::CapConcrete;
  static constexpr const char* name = "concrete, smooth cap";

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static void prepare_solid_element(const model::ConstitutiveLaw& law, const SolidCorners& corners,
                                    UserId solid, domain::ElementBlock& block, Index history, Index place);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law) { return std::get<Model>(law).erodes; }

  /// Items of the history, in numbers a point.
  enum Item {
    Strain = 0,  ///< six, as a tensor
    Cap = 6,     ///< kappa - kappa_0
    Lost = 7,    ///< share of the stress
    Damage = 8,  ///< ConcreteDamage::Item, so many
    Length = Damage + ConcreteDamageItems,
    Failed,
    Overstress,  ///< six, with rate effects alone
  };

  template <class Pack>
  struct SolidUpdate {
    using Real = RealOf<Pack>;
    using Mask = MaskOf<Pack>;
    using History = HistoryView<Real>;
    using Stress = SolidStress<Pack>;
    static constexpr bool can_yield = false;
    static constexpr bool may_fail = true;

    const double* c;
    SolidElasticity<Real> elasticity;
    CapSurface<Pack> surface;
    ConcreteDamage<Pack> damage;
    Real step;

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : c(task.constants),
          elasticity(task.constants[ConcreteYoungs], task.constants[ConcretePoisson]),
          surface{task.constants},
          damage{task.constants},
          step(task.step) {}

    CRUMPLE_INLINE Pack number(int place) const { return Pack(static_cast<Real>(c[place])); }
    CRUMPLE_INLINE static Real* one(const History& history, int item) {
      return history.at(item * history.points + history.point);
    }
    CRUMPLE_INLINE static Real* six(const History& history, int item) {
      return history.at(item * history.points + 6 * history.point);
    }
    CRUMPLE_INLINE bool fails() const { return c[ConcreteErodes] != 0; }
    CRUMPLE_INLINE static Mask intact(const History& history) {
      return load<Pack>(one(history, Failed)) == Pack(Real(0));
    }

    /// Total strain, turned on and with the increment added.
    CRUMPLE_INLINE static Stress follow_strain(const History& history, const SolidStrain<Pack>& e,
                                               const Turn<Pack>& turn) {
      const Pack half(Real(0.5));
      Real* const place = six(history, Strain);
      const Stress old = turned(load_six<Stress>(place, lanes), turn);
      const Stress now{old.xx + e.xx,
                       old.yy + e.yy,
                       old.zz + e.zz,
                       multiply_add(half, e.xy, old.xy),
                       multiply_add(half, e.yz, old.yz),
                       multiply_add(half, e.zx, old.zx)};
      store_six(place, lanes, now);
      return now;
    }

    /// The return of a stress to the yield surface.
    struct Plastic {
      Stress stress;
      Pack trace, size;
      Mask dilates;  ///< has flowed with growing volume
    };
    CRUMPLE_INLINE Plastic plastic(const Stress& trial, const History& history) const {
      const Pack mean = mean_stress(trial);
      const Stress deviator{trial.xx - mean, trial.yy - mean, trial.zz - mean, trial.xy, trial.yz, trial.zx};
      const Pack size = square_root(Pack(Pack(Real(1.0 / 3.0)) * equivalent_square(trial)));
      Real* const place = one(history, Cap);
      const Pack first = number(CapFirst);
      typename CapSurface<Pack>::Trial t{Pack(Real(-3)) * mean, size, first + load<Pack>(place),
                                         Pack(Real(0.5))};
      Plastic found{trial, t.trace, size, size < Pack(Real(0))};
      // Half of the strength in triaxial compression is within the surface at every angle.
      if (!any<Pack>(surface.exceeds(t, surface.bound(t.trace, t.cap, t.ratio)))) return found;
      const LodeAngle<Pack> angle = lode_angle(deviator, size);
      t.ratio = surface.ratio(t.trace, angle);
      const auto at = surface.bound(t.trace, t.cap, t.ratio);
      const Mask mask = surface.exceeds(t, at);
      if (!any<Pack>(mask)) return found;
      const auto end = surface.returned(t, mask, at);
      // The return has taken the ratio of the trial; the stress is to be on the surface where it ends.
      const Pack ratio = surface.ratio(end.trace, angle) / t.ratio;
      const Pack now = smaller(Pack(ratio * end.size), size);
      const Pack none(Real(sizeof(Real) == sizeof(float) ? 1e-30 : 1e-200));
      const Pack scale = now / larger(size, none);
      const Pack pull = Pack(Real(-1.0 / 3.0)) * end.trace;
      const auto put = [&](Pack& to, const Pack& value) { to = select<Pack>(mask, value, to); };
      put(found.stress.xx, multiply_add(scale, deviator.xx, pull));
      put(found.stress.yy, multiply_add(scale, deviator.yy, pull));
      put(found.stress.zz, multiply_add(scale, deviator.zz, pull));
      put(found.stress.xy, scale * deviator.xy);
      put(found.stress.yz, scale * deviator.yz);
      put(found.stress.zx, scale * deviator.zx);
      put(found.trace, end.trace);
      put(found.size, now);
      store(place, select<Pack>(mask, Pack(end.cap - first), load<Pack>(place)));
      found.dilates = mask && end.dilates;
      return found;
    }

    /// `old` has been turned to the end of the step.
    CRUMPLE_INLINE TotalStress<Pack> updated(const Stress& old, const SolidStrain<Pack>& strain,
                                             const Turn<Pack>& turn, const History& history) const {
      const Pack whole(Real(1));
      const Stress total = follow_strain(history, strain, turn);
      const Pack left = whole - load<Pack>(one(history, Lost));
      const Stress viscous = elasticity.stress(scaled(old, Pack(whole / left)), strain);
      Stress over{};
      const bool rates = c[ConcreteRates] != 0;
      if (rates) over = turned(load_six<Stress>(six(history, Overstress), lanes), turn);
      const Plastic now = plastic(rates ? difference(viscous, over) : viscous, history);
      Stress stress = now.stress;
      Pack overstress(Real(0));
      if (rates) {
        const Pack rate = per_step() * effective_strain(strain);
        const Pack fluidity = damage.fluidity({now.trace, now.size}, rate);
        overstress = number(ConcreteYoungs) * (rate * fluidity);
        const Pack share = fluidity / larger(Pack(fluidity + Pack(step)), Pack(least_time));
        over = scaled(difference(viscous, now.stress), share);
        store_six(six(history, Overstress), lanes, over);
        stress = {stress.xx + over.xx, stress.yy + over.yy, stress.zz + over.zz,
                  stress.xy + over.xy, stress.yz + over.yz, stress.zx + over.zx};
      }
      const Pack lost = wear(now, total, overstress, history);
      store(one(history, Lost), lost);
      return {scaled(stress, Pack(whole - lost)), number(ConcreteWaveSquare)};
    }

    static constexpr Real least_time = sizeof(Real) == sizeof(float) ? Real(1e-30) : Real(1e-200);
    CRUMPLE_INLINE Pack per_step() const { return Pack(step > 0 ? Real(1) / step : Real(0)); }
    CRUMPLE_INLINE static Stress difference(const Stress& a, const Stress& b) {
      return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.yz - b.yz, a.zx - b.zx};
    }

    /// Share of the stress that is lost now; marks the point where it has failed.
    CRUMPLE_INLINE Pack wear(const Plastic& now, const Stress& strain, const Pack& overstress,
                             const History& history) const {
      typename ConcreteDamage<Pack>::Load load_now{};
      load_now.at = {now.trace, now.size};
      load_now.dilates = now.dilates;
      load_now.overstress = overstress;
      load_now.volume = strain.xx + (strain.yy + strain.zz);
      load_now.strain = load_now.energy = Pack(Real(0));
      Pack work = now.stress.zx * strain.zx;
      work = multiply_add(now.stress.yz, strain.yz, work);
      work = multiply_add(now.stress.xy, strain.xy, work);
      work = work + work;
      work = multiply_add(now.stress.zz, strain.zz, work);
      work = multiply_add(now.stress.yy, strain.yy, work);
      load_now.energy = multiply_add(now.stress.xx, strain.xx, work);
      Real* items[ConcreteDamageItems];
      for (int k = 0; k < ConcreteDamageItems; ++k) items[k] = one(history, Damage + k);
      const Pack zero(Real(0));
      const Mask tears = (now.trace < zero) && (now.dilates || (load<Pack>(items[BrittleStart]) > zero));
      const bool is_strain_known = any<Pack>(tears);
      if (is_strain_known) load_now.strain = greatest_principal(strain);
      const auto worn = damage.advance(load_now, load<Pack>(one(history, Length)), items);
      if (fails() && any<Pack>(worn.most > Pack(Real(0.99)))) {
        if (!is_strain_known) load_now.strain = greatest_principal(strain);
        const Mask gone = (worn.most > Pack(Real(0.99))) && (load_now.strain > number(ConcreteErosion));
        store(one(history, Failed), select<Pack>(gone, Pack(Real(1)), load<Pack>(one(history, Failed))));
      }
      return worn.lost;
    }
    /// Not inline: the rotations of both tensors are the longest part of the law.
    static Pack greatest_principal(const Stress& s) { return largest_principal(s); }
  };
};

}  // namespace crumple::materials
