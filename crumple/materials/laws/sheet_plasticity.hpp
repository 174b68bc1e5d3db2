// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/plasticity/barlat_plasticity.hpp"
#include "materials/plasticity/plane_stress_plasticity.hpp"
#include "materials/plasticity/sheet_hardening.hpp"

namespace crumple::materials {

/// What both criteria of sheet metal have in common.
struct SheetLaw {
  using Model = model::SheetPlasticity;

  /// The table of hardening follows.
  enum Place {
    Youngs,
    Poissons,
    Rate,
    Exponent,
    Strength,
    Power,
    YieldStrain,
    Least,
    Points,
    First,   ///< weight of the sum; a of Barlat & Lian
    Second,  ///< weight of the rest; c of Barlat & Lian
    AcrossScale,
    ShearScale,
    YieldExponent,
    Count
  };

  static std::vector<double> constants_of(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }

  template <class Real>
  CRUMPLE_INLINE static SheetHardening<Real> hardening_of(const double* c) {
    return {PointTable<Real>{c + Count, static_cast<int>(c[Points])}, static_cast<Real>(c[Strength]),
            static_cast<Real>(c[Power]), static_cast<Real>(c[YieldStrain]), static_cast<Real>(c[Least])};
  }
  template <class Real>
  CRUMPLE_INLINE static CowperSymonds<Real> rate_of(const MaterialTask<Real>& task) {
    return {task.constants[Rate], task.constants[Exponent], task.step};
  }
};

/// Sheet metal with the same R in every direction of its plane: R. Hill, Proc. R. Soc. A 193 (1948) 281-297
/// (docs/theory/sheet_metal.md).
struct NormalAnisotropyLaw : SheetLaw {
  static constexpr const char* name = "transversely anisotropic plasticity";

  static bool takes(const model::ConstitutiveLaw& law) { return std::get<Model>(law).is_normal; }
  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);

  template <class Pack>
  struct Update : PlaneStressPlasticity<Pack, SheetHardening<RealOf<Pack>>> {
    using Plasticity = PlaneStressPlasticity<Pack, SheetHardening<RealOf<Pack>>>;
    using typename Plasticity::Real;

    CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& task)
        : Plasticity(task.constants[Youngs], task.constants[Poissons], 0, hardening_of<Real>(task.constants),
                     rate_of<Real>(task), 0, YieldWeights{task.constants[First], task.constants[Second]}) {}
  };
};

/// Sheet metal with three values of R: F. Barlat & J. Lian, Int. J. Plasticity 5 (1989) 51-66
/// (docs/theory/sheet_metal.md).
struct BarlatLaw : SheetLaw {
  static constexpr const char* name = "three-parameter Barlat plasticity";

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static void prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes,
                              domain::ElementBlock& block, Index history, Index place);

  template <class Pack>
  struct Update : BarlatPlasticity<Pack, SheetHardening<RealOf<Pack>>> {
    using Plasticity = BarlatPlasticity<Pack, SheetHardening<RealOf<Pack>>>;
    using typename Plasticity::Real;

    CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& task)
        : Plasticity(
              task.constants[Youngs], task.constants[Poissons],
              BarlatYield<Pack>(task.constants[First], task.constants[Second], task.constants[AcrossScale],
                                task.constants[ShearScale], task.constants[YieldExponent]),
              hardening_of<Real>(task.constants), rate_of<Real>(task)) {}
  };
};

}  // namespace crumple::materials
