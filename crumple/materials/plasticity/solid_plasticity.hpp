// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/solid_material.hpp"
#include "materials/common/solid_stress.hpp"
#include "materials/plasticity/cowper_symonds.hpp"
#include "materials/plasticity/plastic_point.hpp"
#include "materials/plasticity/yield_point.hpp"

namespace crumple::materials {

/// J2 plasticity of solids: the radial return of Wilkins (Methods in Computational Physics 3 (1964) 211-263),
/// with isotropic and kinematic hardening as in Simo & Hughes, Computational Inelasticity (1998), chapter 3
/// (docs/theory/solid_plasticity.md). `Hardening` and `Rate` are those of PlaneStressPlasticity.
template <class Pack, class Hardening, class Rate = CowperSymonds<RealOf<Pack>>>
struct SolidPlasticity : PlasticPoint<Pack> {
  using Point = PlasticPoint<Pack>;
  using typename Point::History;
  using typename Point::Mask;
  using typename Point::Real;
  using Task = SolidMaterialTask<Real>;
  using Stress = SolidStress<Pack>;
  using Strain = SolidStrain<Pack>;
  using Point::add_plastic_strain;
  using Point::fails;
  using Point::intact;
  using Point::plastic_strain;
  using Point::unreachable;

  struct Trial {
    Pack square;  ///< of the equivalent of the trial stress relative to the back stress
    Pack radius;  ///< yield stress at the old plastic strain and the present rate
    Pack slope;   ///< of the yield stress over the plastic strain, there
    Pack rate_factor;
    Pack flow;   ///< increment of the effective plastic strain
    Pack aside;  ///< what the hardening wants to know in the return
    /// Effective strain increment, where the rate is that of the plastic strain. The return then starts from
    /// it: in steady flow nearly all of it is plastic.
    Pack strain;
  };
  static constexpr bool can_yield = true;
  static constexpr bool may_fail = true;

  SolidElasticity<Real> elasticity;
  Hardening hardening;
  Rate rate;
  Real kinematic;  ///< kinematic hardening modulus; 0: there is no back stress in the state
  Real stiffness;  ///< by which plastic strain lowers the equivalent stress: 3 G + kinematic

  CRUMPLE_INLINE SolidPlasticity(double youngs_modulus, double poissons_ratio, double kinematic_modulus,
                                 const Hardening& hardening_law, const Rate& rate_effect,
                                 double failure_strain)
      : Point(failure_strain),
        elasticity(youngs_modulus, poissons_ratio),
        hardening(hardening_law),
        rate(rate_effect),
        kinematic(static_cast<Real>(kinematic_modulus)),
        stiffness(static_cast<Real>(1.5 * youngs_modulus / (1 + poissons_ratio) + kinematic_modulus)) {}

  CRUMPLE_INLINE static Real* back_stress(const History& history) {
    return Point::back_stress(history, solid_components);
  }
  CRUMPLE_INLINE void turn_history(const History& history, const Turn<Pack>& turn) const {
    if (kinematic == 0) return;
    Real* const place = back_stress(history);
    store_six(place, lanes, turned(load_six<Stress>(place, lanes), turn));
  }

  CRUMPLE_INLINE Stress relative(const Stress& stress, const History& history) const {
    if (kinematic == 0) return stress;
    const auto back = load_six<Stress>(back_stress(history), lanes);
    return {stress.xx - back.xx, stress.yy - back.yy, stress.zz - back.zz,
            stress.xy - back.xy, stress.yz - back.yz, stress.zx - back.zx};
  }

  CRUMPLE_INLINE Trial trial(const Stress& stress, const Strain& strain, const History& history) const {
    return trial_with(stress, strain, history, rate.factor(strain));
  }

  /// The trial with a given factor on the yield stress.
  CRUMPLE_INLINE Trial trial_with(const Stress& stress, const Strain& strain, const History& history,
                                  const Pack& factor) const {
    const Pack aside = hardening.aside(strain, factor);
    const YieldPoint<Pack> yield = hardening.at(load<Pack>(plastic_strain(history)), aside);
    Pack radius = factor * yield.stress;
    // What has failed does not flow any more: its plastic strain stays what it was.
    if (fails()) radius = select<Pack>(intact(history), radius, Pack(unreachable));
    return {equivalent_square(relative(stress, history)),
            radius,
            factor * yield.slope,
            factor,
            Pack(Real(0)),
            aside,
            by_plastic_rate() ? effective_strain(strain) : Pack(Real(0))};
  }
  CRUMPLE_INLINE bool by_plastic_rate() const { return rate.viscoplastic || hardening.viscoplastic(); }

  CRUMPLE_INLINE Mask yields(const Trial& t) const { return t.square > t.radius * t.radius; }

  /// Increment of the effective plastic strain, and the yield stress that it leads to.
  struct Solution {
    Pack flow, yield;
  };

  /// Solves size - stiffness flow = yield stress(flow), in the lanes of the mask.
  CRUMPLE_INLINE Solution solve(const Trial& t, const Mask& mask, const Pack& size,
                                const Pack& old_strain) const {
    // Exact if the yield stress is linear in the flow, and Newton's first step if it is not. It is taken even
    // if the excess is round-off beside the stress: in slow flow it always is.
    const Pack first = (size - t.radius) / (Pack(stiffness) + t.slope);
    if constexpr (requires { Hardening::is_linear; })
      if (!rate.viscoplastic) return {first, multiply_add(t.slope, first, t.radius)};
    return iterate(t, mask, size, old_strain, first);
  }

  /// Newton's method: where the yield stress is concave in the flow it approaches the root from below without
  /// fail. Kinks of a table may throw it off; the bracket then halves. A lane that has converged is left
  /// alone, so that its bits do not depend on its neighbours.
  CRUMPLE_INLINE Solution iterate(const Trial& t, const Mask& mask, const Pack& size, const Pack& old_strain,
                                  const Pack& first) const {
    // Powers have round-off of their own.
    const bool rough = Hardening::rough || rate.viscoplastic;
    constexpr bool single = sizeof(Real) == sizeof(float);
    const Real tolerance =
        rough ? (single ? Real(5e-7) : Real(4e-14)) : (single ? Real(2.5e-7) : Real(4e-15));
    constexpr int most_iterations = 60;
    const Pack zero(Real(0));
    const Pack down(-stiffness);
    const Pack over_stiffness(Real(1) / stiffness);
    const Pack floor_stress = t.rate_factor * hardening.least(t.aside);
    Pack low = zero;
    Pack high = multiply_add(Pack(Real(1e-6)), size, Pack(size - floor_stress)) * over_stiffness;
    Solution found{smaller(first, high), t.radius};
    if (by_plastic_rate())
      found.flow = smaller(larger(t.strain, Pack(Pack(Real(1e-3)) * high)), Pack(Pack(Real(0.999)) * high));
    Mask open = mask;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      auto yield =
          hardening.at(Pack(old_strain + found.flow), hardening.viscoplastic() ? found.flow : t.aside);
      if (rate.viscoplastic) yield = rate.raised(yield, found.flow);
      const Pack stress = t.rate_factor * yield.stress;
      const Pack excess = multiply_add(down, found.flow, size) - stress;
      found.yield = select<Pack>(open, stress, found.yield);
      open = open && (absolute(excess) > Pack(Pack(tolerance) * size));
      if (!any<Pack>(open)) break;
      low = select<Pack>(excess > zero, found.flow, low);
      high = select<Pack>(excess > zero, high, found.flow);
      Pack next = found.flow + excess / multiply_add(t.rate_factor, yield.slope, Pack(stiffness));
      const Mask inside = (next > low) && (next < high);
      next = select<Pack>(inside, next, Pack(Real(0.5) * (low + high)));
      found.flow = select<Pack>(open, next, found.flow);
    }
    return found;
  }

  /// The deviator of the relative stress is scaled to the yield stress found, so that the yield condition
  /// holds to round-off whatever the root's own error.
  CRUMPLE_INLINE void correct(Stress& stress, Trial& t, const Mask& mask, const History& history) const {
    const Pack size = square_root(t.square);
    const Pack over_size = Pack(Real(1)) / size;
    const Solution solution = solve(t, mask, size, load<Pack>(plastic_strain(history)));
    const Pack scale = solution.yield * over_size;
    const Stress s = relative(stress, history);
    const Pack mean = mean_stress(s);
    const Stress deviator{s.xx - mean, s.yy - mean, s.zz - mean, s.xy, s.yz, s.zx};
    Stress now{multiply_add(scale, deviator.xx, mean),
               multiply_add(scale, deviator.yy, mean),
               multiply_add(scale, deviator.zz, mean),
               scale * deviator.xy,
               scale * deviator.yz,
               scale * deviator.zx};
    if (kinematic != 0) {
      // The back stress moves along the relative stress: d alpha = H_k d p (relative deviator / size).
      const Pack follow = Pack(kinematic) * (solution.flow * over_size);
      auto back = load_six<Stress>(back_stress(history), lanes);
      const auto advance = [&](Pack& alpha, const Pack& direction, Pack& sigma) {
        alpha = select<Pack>(mask, multiply_add(follow, direction, alpha), alpha);
        sigma = sigma + alpha;
      };
      advance(back.xx, deviator.xx, now.xx);
      advance(back.yy, deviator.yy, now.yy);
      advance(back.zz, deviator.zz, now.zz);
      advance(back.xy, deviator.xy, now.xy);
      advance(back.yz, deviator.yz, now.yz);
      advance(back.zx, deviator.zx, now.zx);
      store_six(back_stress(history), lanes, back);
    }
    stress = {select<Pack>(mask, now.xx, stress.xx), select<Pack>(mask, now.yy, stress.yy),
              select<Pack>(mask, now.zz, stress.zz), select<Pack>(mask, now.xy, stress.xy),
              select<Pack>(mask, now.yz, stress.yz), select<Pack>(mask, now.zx, stress.zx)};
    t.flow = select<Pack>(mask, solution.flow, Pack(Real(0)));
    add_plastic_strain(history, t.flow);
  }
};

}  // namespace crumple::materials
