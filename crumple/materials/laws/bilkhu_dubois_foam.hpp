// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/common/solid_material.hpp"
#include "materials/laws/volume_history.hpp"
#include "materials/plasticity/yield_point.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Crushable foam whose yield surface is an ellipse in pressure and von Mises stress, after S.S. Bilkhu, M.
/// Founas & G.S. Nusholtz, SAE 930433 (1993), and P. Du Bois (docs/theory/bilkhu_dubois_foam.md).
struct BilkhuDuboisFoamLaw {
  using Model = model::BilkhuDuboisFoam;
  static constexpr const char* name = "Bilkhu-Dubois foam";

  static void declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                              Index /*tensor*/) {
    declare_volume(block);
  }
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }
  static double linear_viscosity(const model::ConstitutiveLaw& law) { return std::get<Model>(law).damping; }

  /// Strengths in tension: a share of the curve in compression and what does not vary with the volume; of a
  /// zero the other counts, of both zero there is none of that kind.
  enum Place {
    Youngs,
    Poissons,
    HydrostaticShare,
    Hydrostatic,
    UniaxialShare,
    Uniaxial,
    PressurePoints,  ///< points of each curve; behind Count they follow each other, three numbers a point
    UniaxialPoints,
    RatePoints,
    Count
  };

  template <class Pack>
  struct SolidUpdate {
    using Real = RealOf<Pack>;
    using Mask = MaskOf<Pack>;
    using History = HistoryView<Real>;
    static constexpr bool can_yield = true;
    static constexpr bool may_fail = false;

    /// Yield is k^2 square - k linear = constant, with a factor k on the stress.
    struct Trial {
      Pack square, linear, constant;
    };

    const double* c;
    SolidElasticity<Real> elasticity;
    Real per_step;  ///< 1 / dt; 0: no rate

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : c(task.constants),
          elasticity(task.constants[Youngs], task.constants[Poissons]),
          per_step(task.step > 0 ? Real(1) / task.step : Real(0)) {}

    CRUMPLE_INLINE Pack number(Place place) const { return Pack(static_cast<Real>(c[place])); }
    CRUMPLE_INLINE PointTable<Real> pressure_curve() const {
      return {c + Count, static_cast<int>(c[PressurePoints])};
    }
    CRUMPLE_INLINE PointTable<Real> uniaxial_curve() const {
      return {pressure_curve().rows + 3 * pressure_curve().count, static_cast<int>(c[UniaxialPoints])};
    }
    CRUMPLE_INLINE PointTable<Real> rate_curve() const {
      return {uniaxial_curve().rows + 3 * uniaxial_curve().count, static_cast<int>(c[RatePoints])};
    }

    CRUMPLE_INLINE void follow(const History& history, const SolidStrain<Pack>& strain,
                               const Turn<Pack>& turn) const {
      follow_volume(history, 0, strain, turn);
    }
    CRUMPLE_INLINE static void turn_history(const History& /*history*/, const Turn<Pack>& /*turn*/) {}

    CRUMPLE_INLINE Pack rate_factor(const SolidStrain<Pack>& strain) const {
      if (c[RatePoints] == 0) return Pack(Real(1));
      const Pack rate = Pack(per_step) * absolute(Pack(strain.xx + (strain.yy + strain.zz)));
      return rate_curve().at(rate).stress;
    }

    /// Strength under tension from all sides that gives the ellipse the wanted one in uniaxial tension; the
    /// points of compression are `hydrostatic` and `uniaxial`.
    CRUMPLE_INLINE static Pack by_uniaxial_tension(const Pack& tension, const Pack& hydrostatic,
                                                   const Pack& uniaxial) {
      const Pack third(Real(1.0 / 3.0));
      const Pack pulled = uniaxial * uniaxial * multiply_add(third, tension, hydrostatic);
      const Pack pressed = tension * tension * (hydrostatic - third * uniaxial);
      return third * multiply_add(pulled, tension, Pack(pressed * uniaxial)) / (pulled - pressed);
    }

    CRUMPLE_INLINE Pack tensile_strength(const Pack& hydrostatic, const Pack& uniaxial) const {
      const bool by_pressure = c[HydrostaticShare] > 0 || c[Hydrostatic] > 0;
      const bool by_stress = c[UniaxialShare] > 0 || c[Uniaxial] > 0;
      const Pack pressure =
          c[HydrostaticShare] > 0 ? Pack(number(HydrostaticShare) * hydrostatic) : number(Hydrostatic);
      if (!by_stress) return pressure;
      const Pack wanted = c[UniaxialShare] > 0 ? Pack(number(UniaxialShare) * uniaxial) : number(Uniaxial);
      // Above the strength in compression the ellipse has no point of uniaxial tension.
      const Pack stress = by_uniaxial_tension(smaller(wanted, uniaxial), hydrostatic, uniaxial);
      return by_pressure ? smaller(pressure, stress) : stress;
    }

    CRUMPLE_INLINE Trial trial(const SolidStress<Pack>& stress, const SolidStrain<Pack>& strain,
                               const History& history) const {
      const Pack third(Real(1.0 / 3.0));
      const Pack volume = Pack(Real(1)) + load<Pack>(history.at(history.point));
      const Pack crush = larger(Pack(Real(-0.69314718055994531)) * math::binary_log(volume), Pack(Real(0)));
      const Pack factor = rate_factor(strain);
      const Pack hydrostatic = factor * pressure_curve().at(crush).stress;
      const Pack uniaxial = factor * uniaxial_curve().at(crush).stress;
      const Pack tension = tensile_strength(hydrostatic, uniaxial);
      // q^2 = b (hydrostatic - p) (p + tension) goes through the point of uniaxial compression.
      const Pack at = third * uniaxial;
      const Pack b = uniaxial * uniaxial / (Pack(hydrostatic - at) * Pack(at + tension));
      const Pack p = -mean_stress(stress);
      return {multiply_add(b * p, p, equivalent_square(stress)), b * p * (hydrostatic - tension),
              b * hydrostatic * tension};
    }
    CRUMPLE_INLINE Mask yields(const Trial& t) const { return t.square - t.linear > t.constant; }

    /// The flow has the direction of the elastic strain, so that the stress goes straight to the origin.
    CRUMPLE_INLINE void correct(SolidStress<Pack>& stress, Trial& t, const Mask& mask,
                                const History& /*history*/) const {
      const Pack one(Real(1));
      const Pack two(Real(2));
      const Pack four(Real(4));
      const Pack root = square_root(multiply_add(t.linear, t.linear, Pack(four * t.square * t.constant)));
      const Mask pressed = t.linear >= Pack(Real(0));
      const Pack above = select<Pack>(pressed, Pack(t.linear + root), Pack(two * t.constant));
      const Pack below = select<Pack>(pressed, Pack(two * t.square), Pack(root - t.linear));
      const Pack k = select<Pack>(mask, Pack(above / select<Pack>(mask, below, one)), one);
      stress = {k * stress.xx, k * stress.yy, k * stress.zz, k * stress.xy, k * stress.yz, k * stress.zx};
    }
  };
};

}  // namespace crumple::materials
