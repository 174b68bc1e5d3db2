// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/cowper_symonds.hpp"
#include "materials/plane_stress.hpp"
#include "materials/plastic_point.hpp"
#include "materials/tile_update.hpp"
#include "materials/yield_point.hpp"

namespace crumple::materials {

/// J2 plasticity in plane stress with two transverse shears: the return of Simo & Taylor (IJNME 22 (1986)
/// 649-670) in the five components at once, since sum, difference and shears of the stress are the
/// eigenvectors of both elasticity and yield function (docs/theory/plane_stress_plasticity.md). `Hardening`
/// gives at(strain, aside) -> YieldPoint, where aside is what it asked to be kept in the trial by
/// aside(strain increment, factor), and least(aside), a bound that the yield stress never falls below. `Rate`
/// gives factor(strain increment), viscoplastic and raised(YieldPoint, plastic increment).
template <class Pack, class Hardening, class Rate = CowperSymonds<RealOf<Pack>>>
struct PlaneStressPlasticity : PlasticPoint<Pack> {
  using Point = PlasticPoint<Pack>;
  using typename Point::History;
  using typename Point::Mask;
  using typename Point::Real;
  using Task = MaterialTask<Real>;
  using Stress = PlaneStress<Pack>;
  using Strain = PlaneStrain<Pack>;
  using Point::add_plastic_strain;
  using Point::fails;
  using Point::intact;
  using Point::plastic_strain;
  using Point::unreachable;

  /// The trial stress relative to the back stress, as its squares.
  struct Trial {
    Pack sum_square;   ///< 1/4 (xx + yy)^2
    Pack rest_square;  ///< 3/4 (xx - yy)^2 + 3 (xy^2 + yz^2 + zx^2)
    Pack radius;       ///< yield stress at the old plastic strain and the present rate
    Pack rate_factor;
    Pack plastic_zz;  ///< increment of plastic strain zz
    Pack flow;        ///< increment of the effective plastic strain
    Pack aside;       ///< what the hardening wants to know in the return
  };
  static constexpr bool can_yield = true;
  static constexpr bool may_fail = true;

  PlaneStressElasticity<Real> elasticity;
  Hardening hardening;
  Rate rate;
  Real kinematic;   ///< 2/3 of the kinematic hardening modulus; 0: there is no back stress in the state
  Real sum_slope;   ///< by which gamma divides the sum: 1 + sum_slope gamma
  Real rest_slope;  ///< the same for difference and shears

  CRUMPLE_INLINE PlaneStressPlasticity(double youngs_modulus, double poissons_ratio, double kinematic_modulus,
                                       const Hardening& hardening_law, const Rate& rate_effect,
                                       double failure_strain)
      : Point(failure_strain),
        elasticity(youngs_modulus, poissons_ratio),
        hardening(hardening_law),
        rate(rate_effect),
        kinematic(static_cast<Real>(2.0 / 3.0 * kinematic_modulus)),
        sum_slope(
            static_cast<Real>(youngs_modulus / (3 * (1 - poissons_ratio)) + 2.0 / 3.0 * kinematic_modulus)),
        rest_slope(static_cast<Real>(youngs_modulus / (1 + poissons_ratio) + 2.0 / 3.0 * kinematic_modulus)) {
  }

  CRUMPLE_INLINE static Real* back_stress(const History& history) {
    return Point::back_stress(history, components);
  }

  CRUMPLE_INLINE PlaneStress<Pack> relative(const PlaneStress<Pack>& stress, const History& history) const {
    if (kinematic == 0) return stress;
    const auto back = load_five<PlaneStress<Pack>>(back_stress(history), lanes);
    return {stress.xx - back.xx, stress.yy - back.yy, stress.xy - back.xy, stress.yz - back.yz,
            stress.zx - back.zx};
  }

  CRUMPLE_INLINE Trial trial(const PlaneStress<Pack>& stress, const PlaneStrain<Pack>& strain,
                             const History& history) const {
    return trial_with(stress, strain, history, rate.factor(strain));
  }

  /// The trial with a given factor on the yield stress.
  CRUMPLE_INLINE Trial trial_with(const PlaneStress<Pack>& stress, const PlaneStrain<Pack>& strain,
                                  const History& history, const Pack& factor) const {
    const PlaneStress<Pack> s = relative(stress, history);
    const Pack sum = s.xx + s.yy;
    const Pack difference = s.xx - s.yy;
    Pack rest = Pack(Real(0.25)) * (difference * difference);
    rest = multiply_add(s.xy, s.xy, rest);
    rest = multiply_add(s.yz, s.yz, rest);
    rest = multiply_add(s.zx, s.zx, rest);
    const Pack aside = hardening.aside(strain, factor);
    const Pack yield = hardening.at(load<Pack>(plastic_strain(history)), aside).stress;
    Pack radius = factor * yield;
    // What has failed does not flow any more: its plastic strain stays what it was.
    if (fails()) radius = select<Pack>(intact(history), radius, Pack(unreachable));
    return {Pack(Real(0.25)) * (sum * sum),
            Pack(Real(3)) * rest,
            radius,
            factor,
            Pack(Real(0)),
            Pack(Real(0)),
            aside};
  }

  CRUMPLE_INLINE Mask yields(const Trial& t) const {
    return t.sum_square + t.rest_square > t.radius * t.radius;
  }

  /// The consistency parameter times rest_slope, in the lanes of the mask.
  struct Solution {
    Pack x;
    Pack size;  ///< equivalent stress over the old radius
  };

  /// What is left of the sum and of difference and shears. One division for both.
  struct Returned {
    Pack sum, rest;
  };
  CRUMPLE_INLINE Returned returned(const Pack& x) const {
    const Pack one(Real(1));
    const Pack a = multiply_add(Pack(sum_slope / rest_slope), x, one);
    const Pack b = one + x;
    const Pack over_both = one / (a * b);
    return {over_both * b, over_both * a};
  }

  /// Newton's method on 1 = yield stress / equivalent stress, which is nearly linear in x and, for linear
  /// hardening, concave: it approaches the root from below without fail. Kinks of a table may throw it off;
  /// the bracket then halves. A lane that has converged is left alone, so that its bits do not depend on its
  /// neighbours.
  CRUMPLE_INLINE Solution solve(const Trial& t, const Mask& mask, const Pack& old_strain) const {
    // Powers have round-off of their own.
    const bool rough = Hardening::rough || rate.viscoplastic;
    constexpr bool single = sizeof(Real) == sizeof(float);
    const Real tolerance =
        rough ? (single ? Real(5e-7) : Real(4e-14)) : (single ? Real(2.5e-7) : Real(4e-15));
    constexpr int most_iterations = 60;
    const Pack zero(Real(0));
    const Pack one(Real(1));
    const Pack over_radius = one / t.radius;
    const Pack u = t.sum_square * over_radius * over_radius;
    const Pack v = t.rest_square * over_radius * over_radius;
    const Pack ratio(sum_slope / rest_slope);
    const Pack strain_unit = t.radius * Pack(Real(2.0 / 3.0) / rest_slope);
    const Pack scale = t.rate_factor * over_radius;
    const Real slowest = sum_slope < rest_slope ? sum_slope / rest_slope : Real(1);
    const Pack floor_stress = scale * hardening.least(t.aside);
    Pack low = zero;
    Pack high = (square_root(Pack(u + v)) / floor_stress - one) / Pack(slowest) + Pack(Real(1e-6));
    // A power of the plastic strain rate rises without bound from zero: start beside it.
    Solution found{rate.viscoplastic ? Pack(Real(1e-3) * high) : zero, one};
    Mask open = mask;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      const Returned r = returned(found.x);
      const Pack ua = u * (r.sum * r.sum);
      const Pack vb = v * (r.rest * r.rest);
      const Pack size = square_root(Pack(ua + vb));
      const Pack over_size = one / size;
      const Pack fall = multiply_add(Pack(ratio * ua), r.sum, Pack(vb * r.rest)) * over_size;
      const Pack increment = strain_unit * (found.x * size);
      auto yield = hardening.at(Pack(old_strain + increment), hardening.viscoplastic() ? increment : t.aside);
      if (rate.viscoplastic) yield = rate.raised(yield, increment);
      const Pack quotient = scale * yield.stress * over_size;
      const Pack g = quotient - one;
      found.size = select<Pack>(open, size, found.size);
      open = open && (absolute(g) > Pack(tolerance));
      if (!any<Pack>(open)) break;
      low = select<Pack>(g < zero, found.x, low);
      high = select<Pack>(g < zero, high, found.x);
      const Pack growth = scale * yield.slope * strain_unit * multiply_add(Pack(-found.x), fall, size);
      Pack next = found.x - g * size / multiply_add(quotient, fall, growth);
      const Mask inside = (next > low) && (next < high);
      next = select<Pack>(inside, next, Pack(Real(0.5) * (low + high)));
      found.x = select<Pack>(open, next, found.x);
    }
    return found;
  }

  CRUMPLE_INLINE void correct(PlaneStress<Pack>& stress, Trial& t, const Mask& mask,
                              const History& history) const {
    const Pack zero(Real(0));
    const Pack half(Real(0.5));
    const Pack old_strain = load<Pack>(plastic_strain(history));
    const Solution solution = solve(t, mask, old_strain);
    const PlaneStress<Pack> s = relative(stress, history);
    const Pack gamma = solution.x * Pack(Real(1) / rest_slope);
    const Returned r = returned(solution.x);
    const Pack sum = half * (r.sum * (s.xx + s.yy));
    const Pack difference = half * (r.rest * (s.xx - s.yy));
    PlaneStress<Pack> now{sum + difference, sum - difference, r.rest * s.xy, r.rest * s.yz, r.rest * s.zx};
    if (kinematic != 0) {
      // The back stress follows the relative stress: d alpha = 2/3 H_k gamma (sigma - alpha).
      const Pack follow = Pack(kinematic) * gamma;
      auto back = load_five<PlaneStress<Pack>>(back_stress(history), lanes);
      const auto advance = [&](Pack& alpha, Pack& sigma) {
        alpha = select<Pack>(mask, multiply_add(follow, sigma, alpha), alpha);
        sigma = sigma + alpha;
      };
      advance(back.xx, now.xx);
      advance(back.yy, now.yy);
      advance(back.xy, now.xy);
      advance(back.yz, now.yz);
      advance(back.zx, now.zx);
      store_five(back_stress(history), lanes, back);
    }
    stress.xx = select<Pack>(mask, now.xx, stress.xx);
    stress.yy = select<Pack>(mask, now.yy, stress.yy);
    stress.xy = select<Pack>(mask, now.xy, stress.xy);
    stress.yz = select<Pack>(mask, now.yz, stress.yz);
    stress.zx = select<Pack>(mask, now.zx, stress.zx);
    t.flow = select<Pack>(mask, Pack(Pack(Pack(Real(2.0 / 3.0)) * gamma) * (solution.size * t.radius)), zero);
    add_plastic_strain(history, t.flow);
    t.plastic_zz = select<Pack>(mask, Pack(-(Pack(Real(2.0 / 3.0)) * gamma * sum)), zero);
  }
};

}  // namespace crumple::materials
