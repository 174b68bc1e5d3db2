// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/plane_stress.hpp"
#include "materials/common/ply_axes.hpp"
#include "materials/common/tile_update.hpp"
#include "materials/plasticity/barlat_yield.hpp"
#include "materials/plasticity/cowper_symonds.hpp"
#include "materials/plasticity/plastic_point.hpp"
#include "materials/plasticity/yield_point.hpp"

namespace crumple::materials {

/// Plasticity of sheets in plane stress by the criterion of Barlat & Lian, which leaves the transverse shears
/// elastic. The stress returns to the closest point of the yield surface in the norm of the elastic energy,
/// by Newton's method on its three components and the plastic strain (J.C. Simo & T.J.R. Hughes,
/// Computational Inelasticity (1998), section 3.6) with the line search of W.M. Scherzinger, CMAME 317 (2017)
/// 526-553. `Hardening` as of PlaneStressPlasticity.
template <class Pack, class Hardening>
struct BarlatPlasticity : PlasticPoint<Pack> {
  using Point = PlasticPoint<Pack>;
  using typename Point::History;
  using typename Point::Mask;
  using typename Point::Real;
  using Plane = SheetPlane<Pack>;
  using Matrix = SheetMatrix<Pack>;

  struct Trial {
    Plane stress;  ///< along the axes of the sheet
    Pack size;     ///< equivalent stress of the trial
    Pack radius;   ///< yield stress at the old plastic strain and the present rate
    Pack rate_factor;
    Pack slope;       ///< of the yield stress over the plastic strain
    Pack plastic_zz;  ///< increment of plastic strain zz
  };
  static constexpr bool can_yield = true;
  static constexpr bool may_fail = false;

  PlaneStressElasticity<Real> elasticity;
  BarlatYield<Pack> yield;
  Hardening hardening;
  CowperSymonds<Real> rate;
  Real youngs, poissons;

  CRUMPLE_INLINE BarlatPlasticity(double youngs_modulus, double poissons_ratio,
                                  const BarlatYield<Pack>& criterion, const Hardening& hardening_law,
                                  const CowperSymonds<Real>& rate_effect)
      : Point(0),
        elasticity(youngs_modulus, poissons_ratio),
        yield(criterion),
        hardening(hardening_law),
        rate(rate_effect),
        youngs(static_cast<Real>(youngs_modulus)),
        poissons(static_cast<Real>(poissons_ratio)) {}

  /// The angle of the sheet's axes stands behind what the law keeps of each point.
  CRUMPLE_INLINE static PlyAxes<Pack> axes_of(const History& history) {
    return {history, 2 * history.points};
  }

  CRUMPLE_INLINE Trial trial(const PlaneStress<Pack>& stress, const PlaneStrain<Pack>& strain,
                             const History& history) const {
    Trial t;
    const PlyPlane<Pack> along = axes_of(history).stress(stress);
    t.stress = {along.a, along.b, along.ab};
    t.size = yield.size(t.stress);
    t.rate_factor = rate.factor(strain);
    const YieldPoint<Pack> at = hardening.at(load<Pack>(this->plastic_strain(history)), t.rate_factor);
    t.radius = t.rate_factor * at.stress;
    t.slope = t.rate_factor * at.slope;
    t.plastic_zz = Pack(Real(0));
    return t;
  }
  CRUMPLE_INLINE Mask yields(const Trial& t) const { return t.size > t.radius; }

  struct Left {
    Pack sum, rest;  ///< alike: what is left of the equivalent stress of the trial
  };
  /// Stresses over the old yield stress, strains over the elastic one of that.
  struct Return {
    Plane trial;
    Pack old_strain, strain_unit, scale;
    Plane base, step;  ///< stress found so far, and the way from there
    Pack flow, flow_step;
    Pack part;    ///< of the step that is tried
    Pack merit;   ///< half the square of all residuals at the base
    Pack enough;  ///< merit below which the lane has converged
    Pack size;    ///< equivalent stress at the base
    Plane normal;
    Pack yield;  ///< yield stress at the base
    Left left;
    Mask open;  ///< lanes that are not there yet
    int steps;  ///< that may still be made
  };

  CRUMPLE_INLINE Plane compliant(const Plane& s) const {
    const Pack nu(poissons);
    return {s.x - nu * s.y, s.y - nu * s.x, Pack(Real(2) + Real(2) * poissons) * s.s};
  }
  CRUMPLE_INLINE Plane stiff(const Plane& e) const {
    const Pack nu(poissons);
    const Pack over(Real(1) / (Real(1) - poissons * poissons));
    return {over * (e.x + nu * e.y), over * (e.y + nu * e.x), Pack(Real(0.5) / (Real(1) + poissons)) * e.s};
  }
  CRUMPLE_INLINE static Plane select_plane(const Mask& mask, const Plane& a, const Plane& b) {
    return {select<Pack>(mask, a.x, b.x), select<Pack>(mask, a.y, b.y), select<Pack>(mask, a.s, b.s)};
  }
  CRUMPLE_INLINE static Plane along(const Plane& from, const Pack& factor, const Plane& way) {
    return {multiply_add(factor, way.x, from.x), multiply_add(factor, way.y, from.y),
            multiply_add(factor, way.s, from.s)};
  }

  /// Starts where the trial stress, made smaller, meets the yield surface.
  CRUMPLE_INLINE void begin_return(const Trial& t, const Mask& mask, const History& history,
                                   Return& r) const {
    constexpr int most_steps = 60;
    constexpr bool single = sizeof(Real) == sizeof(float);
    const Pack zero(Real(0));
    const Pack one(Real(1));
    const Pack over = one / t.radius;
    r.trial = {over * t.stress.x, over * t.stress.y, over * t.stress.s};
    r.old_strain = load<Pack>(this->plastic_strain(history));
    r.strain_unit = t.radius * Pack(Real(1) / youngs);
    r.scale = t.rate_factor * over;
    const Pack size = select<Pack>(mask, Pack(over * t.size), one);
    const Pack smaller_by = one / size;
    r.base = {smaller_by * r.trial.x, smaller_by * r.trial.y, smaller_by * r.trial.s};
    const Plane normal = yield.at(r.base).normal;
    const Pack drop = dot(normal, stiff(normal));
    r.flow = larger(Pack((size - one) / (drop + larger(Pack(over * t.slope * r.strain_unit), zero))), zero);
    r.step = {zero, zero, zero};
    r.flow_step = zero;
    r.part = one;
    r.merit = Pack(Real(1e30));
    const Real tolerance = single ? Real(2e-6) : Real(2e-14);
    r.enough = Pack(tolerance * tolerance) * (size * size);
    r.size = one;
    r.normal = normal;
    r.yield = one;
    r.left = {one, one};
    r.open = mask;
    r.steps = most_steps;
  }

  /// Evaluates the residuals where the present step leads, takes it if it is good enough, and finds the next
  /// one; else makes it shorter. False once all lanes have converged.
  CRUMPLE_INLINE bool improve(Return& r) const {
    const Pack zero(Real(0));
    const Pack one(Real(1));
    const Plane stress = along(r.base, r.part, r.step);
    const Pack flow = larger(multiply_add(r.part, r.flow_step, r.flow), zero);
    const auto value = yield.at(stress);
    const YieldPoint<Pack> strength =
        hardening.at(multiply_add(flow, r.strain_unit, r.old_strain), Pack(one));
    const Pack yield_stress = r.scale * strength.stress;
    // What is missing in the strain, and in the yield condition.
    const Plane plastic = compliant({r.trial.x - stress.x, r.trial.y - stress.y, r.trial.s - stress.s});
    const Plane gap = along(plastic, Pack(-flow), value.normal);
    const Pack excess = value.size - yield_stress;
    const Pack merit = multiply_add(excess, excess, dot(gap, gap));
    const Mask good = merit <= r.merit * multiply_add(Pack(Real(-1e-4)), r.part, one);
    const Mask taken = r.open && (good || (r.part < Pack(Real(1e-3))));
    const Pack shorter = r.part * larger(Pack(Real(0.1)), Pack(r.merit / (r.merit + merit)));
    r.base = select_plane(taken, stress, r.base);
    r.flow = select<Pack>(taken, flow, r.flow);
    r.merit = select<Pack>(taken, merit, r.merit);
    r.size = select<Pack>(taken, value.size, r.size);
    r.normal = select_plane(taken, value.normal, r.normal);
    r.yield = select<Pack>(taken, yield_stress, r.yield);
    const Step next = step_from(value, flow, gap, excess, Pack(r.scale * strength.slope * r.strain_unit));
    r.step = select_plane(taken, next.stress, r.step);
    r.flow_step = select<Pack>(taken, next.flow, r.flow_step);
    r.part = select<Pack>(taken, one, shorter);
    r.open = r.open && (r.merit > r.enough);
    return any<Pack>(r.open) && --r.steps > 0;
  }

  struct Step {
    Plane stress;
    Pack flow;
  };
  /// Newton's step from where `value` is; `slope` is that of the yield stress over the flow.
  CRUMPLE_INLINE Step step_from(const typename BarlatYield<Pack>::Value& value, const Pack& flow,
                                const Plane& gap, const Pack& excess, const Pack& slope) const {
    const Pack one(Real(1));
    const Matrix& k = value.curvature;
    const Matrix all{multiply_add(flow, k.xx, one),
                     multiply_add(flow, k.yy, one),
                     multiply_add(flow, k.ss, Pack(Real(2) + Real(2) * poissons)),
                     multiply_add(flow, k.xy, Pack(-poissons)),
                     flow * k.ys,
                     flow * k.sx};
    const Matrix over = all.inverse();
    const Plane by_gap = over.times(gap);
    const Plane by_normal = over.times(value.normal);
    const Pack step = (excess + dot(value.normal, by_gap)) / (dot(value.normal, by_normal) + slope);
    return {along(by_gap, Pack(-step), by_normal), step};
  }

  /// Puts the stress found into the lanes of the mask; what is missing on the yield surface is made up for by
  /// a factor.
  CRUMPLE_INLINE void correct(PlaneStress<Pack>& stress, Trial& t, const Mask& mask, Return& r,
                              const History& history) const {
    const Pack zero(Real(0));
    const Pack factor = t.radius * (r.yield / r.size);
    const PlyPlane<Pack> now =
        axes_of(history).lamina_stress({factor * r.base.x, factor * r.base.y, factor * r.base.s});
    stress.xx = select<Pack>(mask, now.a, stress.xx);
    stress.yy = select<Pack>(mask, now.b, stress.yy);
    stress.xy = select<Pack>(mask, now.ab, stress.xy);
    const Pack flow = select<Pack>(mask, Pack(r.flow * r.strain_unit), zero);
    this->add_plastic_strain(history, flow);
    t.plastic_zz = -(flow * (r.normal.x + r.normal.y));
    const Pack left = t.radius * r.yield / t.size;
    r.left = {left, left};
  }
};

}  // namespace crumple::materials
