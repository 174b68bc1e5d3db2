// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/section_material.hpp"
#include "materials/plasticity/cowper_symonds.hpp"
#include "materials/plasticity/plastic_point.hpp"
#include "materials/plasticity/yield_point.hpp"

namespace crumple::materials {

/// Stress of a point of a beam's cross section: along the beam and the shears with s and t. The other
/// stresses are zero.
template <class Pack>
struct FibreStress {
  Pack rr, rs, rt;
};
/// Strain there; shears are engineering ones.
template <class Pack>
struct FibreStrain {
  Pack rr, rs, rt;
};

template <class Pack>
CRUMPLE_INLINE FibreStress<Pack> scaled(const FibreStress<Pack>& stress, const Pack& factor) {
  return {factor * stress.rr, factor * stress.rs, factor * stress.rt};
}

/// As for PlaneStrain: effective strain increment if the material keeps its volume, sqrt(2/3 e : e).
template <class Pack>
CRUMPLE_INLINE Pack effective_strain(const FibreStrain<Pack>& strain) {
  Pack shears = strain.rs * strain.rs;
  shears = multiply_add(strain.rt, strain.rt, shears);
  return square_root(multiply_add(strain.rr, strain.rr, Pack(Pack(1.0 / 3.0) * shears)));
}

/// E along the beam, G across.
template <class Pack>
struct FibreElasticity {
  double youngs_modulus, shear_modulus;

  CRUMPLE_INLINE FibreElasticity(double young, double poisson)
      : youngs_modulus(young), shear_modulus(young / (2 * (1 + poisson))) {}
  CRUMPLE_INLINE FibreStress<Pack> stress(const FibreStress<Pack>& old,
                                          const FibreStrain<Pack>& strain) const {
    const Pack shear(shear_modulus);
    return {multiply_add(Pack(youngs_modulus), strain.rr, old.rr), multiply_add(shear, strain.rs, old.rs),
            multiply_add(shear, strain.rt, old.rt)};
  }
};

/// J2 plasticity where the stresses across the beam are zero: elasticity and the yield function
/// sigma^2 + 3 (tau_s^2 + tau_t^2) have the same eigenvectors, so that the return of Simo & Taylor (IJNME 22
/// (1986) 649-670) has one unknown here as well, x = (E + H_k) d p / size
/// (docs/theory/integrated_beams.md). `Hardening` and `Rate` as for PlaneStressPlasticity.
template <class Pack, class Hardening, class Rate = CowperSymonds<RealOf<Pack>>>
struct FibrePlasticity : PlasticPoint<Pack> {
  using Point = PlasticPoint<Pack>;
  using typename Point::History;
  using typename Point::Mask;
  using Task = SectionTask;
  using Stress = FibreStress<Pack>;
  using Strain = FibreStrain<Pack>;
  using Point::fails;
  using Point::intact;

  FibreElasticity<Pack> elasticity;
  Hardening hardening;
  Rate rate;
  double kinematic;     ///< H_k; 0: there is no back stress in the state
  double axial_sum;     ///< E + H_k
  double shear_factor;  ///< (3 G + H_k) / (E + H_k), not below 1

  CRUMPLE_INLINE FibrePlasticity(double youngs_modulus, double poissons_ratio, double kinematic_modulus,
                                 const Hardening& hardening_law, const Rate& rate_effect,
                                 double failure_strain)
      : Point(failure_strain),
        elasticity(youngs_modulus, poissons_ratio),
        hardening(hardening_law),
        rate(rate_effect),
        kinematic(kinematic_modulus),
        axial_sum(youngs_modulus + kinematic_modulus),
        shear_factor((3 * elasticity.shear_modulus + kinematic_modulus) / axial_sum) {}

  /// The way to x, lane by lane. Squares and sizes are those of the stress relative to the back stress.
  struct Return {
    Pack axial_square, shear_square;  ///< of the trial: sigma^2, 3 tau^2
    Pack old_strain, rate_factor, aside;
    Pack x, low, high;
    Pack size;                    ///< equivalent stress at x
    Pack axial_left, shear_left;  ///< what is left of the trial stress at x
    Mask open;                    ///< lanes that are not there yet
  };

  CRUMPLE_INLINE static Pack within(const Return& r, const Pack& proposed) {
    const Mask inside = (proposed > r.low) && (proposed < r.high);
    return select<Pack>(inside, proposed, Pack(Pack(0.5) * (r.low + r.high)));
  }

  /// A step of Newton's method on 1 = yield stress / equivalent stress, within a bracket. A lane that has
  /// converged is left alone, so that its bits do not depend on its neighbours. False once all have.
  CRUMPLE_INLINE bool improve(Return& r) const {
    const double tolerance = Hardening::rough || rate.viscoplastic ? 4e-14 : 4e-15;
    const Pack one(1.0);
    const Pack ratio(shear_factor);
    const Pack per_sum(1 / axial_sum);
    const Pack axial = one / (one + r.x);
    const Pack shear = one / multiply_add(ratio, r.x, one);
    const Pack axial_part = r.axial_square * (axial * axial);
    const Pack shear_part = r.shear_square * (shear * shear);
    const Pack size = square_root(Pack(axial_part + shear_part));
    const Pack fall = multiply_add(axial_part, axial, Pack(ratio * (shear_part * shear))) / size;
    const Pack increment = per_sum * (r.x * size);
    auto yield = hardening.at(Pack(r.old_strain + increment), hardening.viscoplastic() ? increment : r.aside);
    if (rate.viscoplastic) yield = rate.raised(yield, increment);
    const Pack quotient = r.rate_factor * yield.stress / size;
    const Pack beyond = quotient - one;
    r.size = select<Pack>(r.open, size, r.size);
    r.axial_left = select<Pack>(r.open, axial, r.axial_left);
    r.shear_left = select<Pack>(r.open, shear, r.shear_left);
    r.open = r.open && (absolute(beyond) > Pack(tolerance));
    if (!any<Pack>(r.open)) return false;
    r.low = select<Pack>(beyond < Pack(0.0), r.x, r.low);
    r.high = select<Pack>(beyond < Pack(0.0), r.high, r.x);
    const Pack growth = r.rate_factor * yield.slope * per_sum * multiply_add(Pack(-r.x), fall, size);
    const Pack next = r.x - beyond * size / multiply_add(quotient, fall, growth);
    r.x = select<Pack>(r.open, within(r, next), r.x);
    return true;
  }

  CRUMPLE_INLINE Stress back_of(const History& history) const {
    const Pack zero(0.0);
    if (kinematic == 0) return {zero, zero, zero};
    const double* const back = Point::back_stress(history, section_components);
    return {load<Pack>(back), load<Pack>(back + lanes), load<Pack>(back + 2 * lanes)};
  }

  /// Brings a trial stress that is outside of the yield surface back onto it, and the history up to date.
  CRUMPLE_INLINE Stress returned(const Stress& trial, const Strain& strain, const History& history) const {
    constexpr int most_steps = 60;
    const Pack one(1.0);
    const Pack zero(0.0);
    const Stress back = back_of(history);
    const Stress s{trial.rr - back.rr, trial.rs - back.rs, trial.rt - back.rt};
    Return r;
    r.axial_square = s.rr * s.rr;
    r.shear_square = Pack(3.0) * multiply_add(s.rs, s.rs, Pack(s.rt * s.rt));
    r.old_strain = load<Pack>(Point::plastic_strain(history));
    r.rate_factor = rate.factor(strain);
    r.aside = hardening.aside(strain, r.rate_factor);
    r.size = square_root(Pack(r.axial_square + r.shear_square));
    const Pack radius = r.rate_factor * hardening.at(r.old_strain, r.aside).stress;
    r.open = r.size > radius;
    // What has failed does not flow any more: its plastic strain stays what it was.
    if (fails()) r.open = r.open && intact(history);
    const Mask mask = r.open;
    if (!any<Pack>(mask)) return trial;
    r.low = zero;
    const Pack least = r.rate_factor * hardening.least(r.aside);
    r.high = Pack(r.size / least - one) + Pack(1e-6);
    // A power of the plastic strain rate rises without bound from zero: start beside it.
    r.x = rate.viscoplastic ? Pack(Pack(1e-3) * r.high) : zero;
    r.axial_left = r.shear_left = one;
    for (int step = 0; step < most_steps; ++step)
      if (!improve(r)) break;
    return corrected(trial, s, mask, r, history);
  }

  CRUMPLE_INLINE Stress corrected(const Stress& trial, const Stress& relative, const Mask& mask,
                                  const Return& r, const History& history) const {
    const Pack zero(0.0);
    Stress now{r.axial_left * relative.rr, r.shear_left * relative.rs, r.shear_left * relative.rt};
    if (kinematic != 0) {
      // The back stress follows the relative stress: d alpha = H_k d p / size (sigma - alpha).
      const Pack follow = Pack(kinematic / axial_sum) * r.x;
      double* const place = Point::back_stress(history, section_components);
      int component = 0;
      for (Pack* const stress : {&now.rr, &now.rs, &now.rt}) {
        double* const own = place + component++ * lanes;
        const Pack old = load<Pack>(own);
        const Pack alpha = select<Pack>(mask, multiply_add(follow, *stress, old), old);
        store(own, alpha);
        *stress = *stress + alpha;
      }
    }
    Point::add_plastic_strain(history, select<Pack>(mask, Pack(Pack(1 / axial_sum) * (r.x * r.size)), zero));
    return {select<Pack>(mask, now.rr, trial.rr), select<Pack>(mask, now.rs, trial.rs),
            select<Pack>(mask, now.rt, trial.rt)};
  }
};

}  // namespace crumple::materials
