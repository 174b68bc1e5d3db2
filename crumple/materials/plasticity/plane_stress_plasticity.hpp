// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/plane_stress.hpp"
#include "materials/common/tile_update.hpp"
#include "materials/plasticity/cowper_symonds.hpp"
#include "materials/plasticity/plastic_point.hpp"
#include "materials/plasticity/yield_point.hpp"

namespace crumple::materials {

/// Of the squares of half the sum of the direct stresses, and of half their difference and the shears, in the
/// square of the equivalent stress. Those of von Mises; Hill's with normal anisotropy differ.
struct YieldWeights {
  double sum = 1;
  double rest = 3;
};

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
    Pack sum_square;   ///< 1/4 (xx + yy)^2, by its weight
    Pack rest_square;  ///< 1/4 (xx - yy)^2 + xy^2 + yz^2 + zx^2, by its weight
    Pack radius;       ///< yield stress at the old plastic strain and the present rate
    Pack rate_factor;
    Pack slope;       ///< of the yield stress at rest over the plastic strain
    Pack plastic_zz;  ///< increment of plastic strain zz
    Pack flow;        ///< increment of the effective plastic strain
    Pack aside;       ///< what the hardening wants to know in the return
    Pack strain;      ///< effective strain increment, where the rate is that of the plastic strain
  };
  static constexpr bool can_yield = true;
  static constexpr bool may_fail = true;

  PlaneStressElasticity<Real> elasticity;
  Hardening hardening;
  Rate rate;
  Real kinematic;   ///< 2/3 of the kinematic hardening modulus; 0: there is no back stress in the state
  Real sum_slope;   ///< by which gamma divides the sum: 1 + sum_slope gamma
  Real rest_slope;  ///< the same for difference and shears
  Real sum_weight;  ///< of the square of the sum, not of its half
  Real rest_weight;
  Real thinning;  ///< minus the plastic strain zz, over gamma and half the sum

  CRUMPLE_INLINE PlaneStressPlasticity(double youngs_modulus, double poissons_ratio, double kinematic_modulus,
                                       const Hardening& hardening_law, const Rate& rate_effect,
                                       double failure_strain, const YieldWeights& weights = {})
      : Point(failure_strain),
        elasticity(youngs_modulus, poissons_ratio),
        hardening(hardening_law),
        rate(rate_effect),
        kinematic(static_cast<Real>(2.0 / 3.0 * kinematic_modulus)),
        sum_slope(static_cast<Real>(youngs_modulus * weights.sum / (3 * (1 - poissons_ratio)) +
                                    2.0 / 3.0 * kinematic_modulus)),
        rest_slope(static_cast<Real>(youngs_modulus * (weights.rest / 3) / (1 + poissons_ratio) +
                                     2.0 / 3.0 * kinematic_modulus)),
        sum_weight(static_cast<Real>(0.25 * weights.sum)),
        rest_weight(static_cast<Real>(weights.rest)),
        thinning(static_cast<Real>(2.0 / 3.0 * weights.sum)) {}

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
    const YieldPoint<Pack> yield = hardening.at(load<Pack>(plastic_strain(history)), aside);
    Pack radius = factor * yield.stress;
    // What has failed does not flow any more: its plastic strain stays what it was.
    if (fails()) radius = select<Pack>(intact(history), radius, Pack(unreachable));
    return {Pack(sum_weight) * (sum * sum),
            Pack(rest_weight) * rest,
            radius,
            factor,
            yield.slope,
            Pack(Real(0)),
            Pack(Real(0)),
            aside,
            by_plastic_rate() ? effective_strain(strain) : Pack(Real(0))};
  }

  /// The return then starts from the strain of the step, nearly all of which is plastic in steady flow.
  CRUMPLE_INLINE bool by_plastic_rate() const { return rate.viscoplastic || hardening.viscoplastic(); }

  CRUMPLE_INLINE Mask yields(const Trial& t) const {
    return t.sum_square + t.rest_square > t.radius * t.radius;
  }

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

  /// The way to the consistency parameter, lane by lane; stresses over the old radius, strains as such [-].
  struct Return {
    Pack sum_square, rest_square;
    Pack old_strain;
    Pack strain_unit;  ///< plastic strain increment for x and size of 1
    Pack scale;        ///< rate factor over the old radius
    Pack aside;
    Pack x;          ///< the consistency parameter times rest_slope
    Pack low, high;  ///< bracket it
    Pack size;       ///< equivalent stress at x
    Returned left;   ///< at x
    Mask open;       ///< lanes that are not there yet
    int steps;       ///< that may still be made
  };

  /// Starts where Newton's method is after its first step from zero: there the trial has all that the step
  /// needs, and one division does for it.
  CRUMPLE_INLINE void begin_return(const Trial& t, const Mask& mask, const History& history,
                                   Return& r) const {
    constexpr int most_steps = 60;
    const Pack one(Real(1));
    const Pack ratio(sum_slope / rest_slope);
    const Real slowest = sum_slope < rest_slope ? rest_slope / sum_slope : Real(1);
    const Pack over_radius = one / t.radius;
    const Pack over_square = over_radius * over_radius;
    r.sum_square = t.sum_square * over_square;
    r.rest_square = t.rest_square * over_square;
    r.old_strain = load<Pack>(plastic_strain(history));
    r.strain_unit = t.radius * Pack(Real(2.0 / 3.0) / rest_slope);
    r.scale = t.rate_factor * over_radius;
    r.aside = t.aside;
    const Pack square = r.sum_square + r.rest_square;
    const Pack size = square_root(square);
    r.low = Pack(Real(0));
    const Pack floor_stress = r.scale * hardening.least(t.aside);
    r.high = multiply_add(Pack(size / floor_stress - one), Pack(slowest), Pack(Real(1e-6)));
    if (by_plastic_rate()) {
      // The increment is strain_unit x size, with about size / (1 + x) left of the trial.
      const Pack all = r.strain_unit * size;
      const Pack flow = smaller(t.strain, Pack(Pack(Real(0.999)) * all));
      r.x = within(r, larger(Pack(flow / (all - flow)), Pack(Pack(Real(1e-3)) * r.high)));
    } else {
      const Pack growth = Pack(r.scale * t.slope) * Pack(r.strain_unit * size);
      const Pack fall = multiply_add(ratio, r.sum_square, r.rest_square);
      r.x = within(r, Pack(Pack(size - one) * square / multiply_add(growth, square, fall)));
    }
    r.size = one;
    r.left = {one, one};
    r.open = mask;
    r.steps = most_steps;
  }

  /// A proposal for x, or the middle of the bracket if it lies outside.
  CRUMPLE_INLINE static Pack within(const Return& r, const Pack& proposed) {
    const Mask inside = (proposed > r.low) && (proposed < r.high);
    return select<Pack>(inside, proposed, Pack(Pack(Real(0.5)) * (r.low + r.high)));
  }

  /// A step of Newton's method on 1 = yield stress / equivalent stress, which is nearly linear in x and, for
  /// linear hardening, concave: it approaches the root from below without fail. Kinks of a table may throw it
  /// off; the bracket then halves. A lane that has converged is left alone, so that its bits do not depend on
  /// its neighbours. False once all have.
  CRUMPLE_INLINE bool improve(Return& r) const {
    // Powers have round-off of their own.
    const bool rough = Hardening::rough || rate.viscoplastic;
    constexpr bool single = sizeof(Real) == sizeof(float);
    const Real tolerance =
        rough ? (single ? Real(5e-7) : Real(4e-14)) : (single ? Real(2.5e-7) : Real(4e-15));
    const Pack zero(Real(0));
    const Pack one(Real(1));
    const Returned left = returned(r.x);
    const Pack ua = r.sum_square * (left.sum * left.sum);
    const Pack vb = r.rest_square * (left.rest * left.rest);
    const Pack square = ua + vb;
    const Pack size = square_root(square);
    const Pack over_size = size * Pack(one / square);
    const Pack fall =
        multiply_add(Pack(Pack(sum_slope / rest_slope) * ua), left.sum, Pack(vb * left.rest)) * over_size;
    const Pack increment = r.strain_unit * (r.x * size);
    auto yield = hardening.at(Pack(r.old_strain + increment), hardening.viscoplastic() ? increment : r.aside);
    if (rate.viscoplastic) yield = rate.raised(yield, increment);
    const Pack quotient = r.scale * yield.stress * over_size;
    const Pack g = quotient - one;
    r.size = select<Pack>(r.open, size, r.size);
    r.left = {select<Pack>(r.open, left.sum, r.left.sum), select<Pack>(r.open, left.rest, r.left.rest)};
    r.open = r.open && (absolute(g) > Pack(tolerance));
    if (!any<Pack>(r.open) || --r.steps == 0) return false;
    r.low = select<Pack>(g < zero, r.x, r.low);
    r.high = select<Pack>(g < zero, r.high, r.x);
    const Pack growth = r.scale * yield.slope * r.strain_unit * multiply_add(Pack(-r.x), fall, size);
    const Pack next = r.x - g * size / multiply_add(quotient, fall, growth);
    r.x = select<Pack>(r.open, within(r, next), r.x);
    return true;
  }

  /// Puts the trial stress back in the lanes of the mask, once improve() has come to its end.
  CRUMPLE_INLINE void correct(PlaneStress<Pack>& stress, Trial& t, const Mask& mask, const Return& solution,
                              const History& history) const {
    const Pack zero(Real(0));
    const Pack half(Real(0.5));
    const PlaneStress<Pack> s = relative(stress, history);
    const Pack gamma = solution.x * Pack(Real(1) / rest_slope);
    const Returned& left = solution.left;
    const Pack sum = half * (left.sum * (s.xx + s.yy));
    const Pack difference = half * (left.rest * (s.xx - s.yy));
    PlaneStress<Pack> now{sum + difference, sum - difference, left.rest * s.xy, left.rest * s.yz,
                          left.rest * s.zx};
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
    t.plastic_zz = select<Pack>(mask, Pack(-(Pack(thinning) * gamma * sum)), zero);
  }
};

}  // namespace crumple::materials
