// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Constitutive laws at the points of the cross sections of beams. Model, constants and history are those of
// the laws of shells and solids; their updates stand here, as do those that have no stress.

#include "materials/laws/elastic.hpp"
#include "materials/laws/johnson_cook.hpp"
#include "materials/laws/null.hpp"
#include "materials/laws/piecewise_linear_plasticity.hpp"
#include "materials/laws/plastic_kinematic.hpp"
#include "materials/laws/plasticity_with_damage.hpp"
#include "materials/laws/power_law_plasticity.hpp"
#include "materials/plasticity/fibre_plasticity.hpp"

namespace crumple::materials {

/// A law with `can_yield` has returned(); one with `may_fail` has fails() and intact() as well.
struct SectionElastic : ElasticLaw {
  template <class Pack>
  struct FibreUpdate {
    static constexpr bool can_yield = false;
    static constexpr bool has_stress = true;
    FibreElasticity<Pack> elasticity;

    CRUMPLE_INLINE explicit FibreUpdate(const SectionTask& task)
        : elasticity(task.constants[0], task.constants[1]) {}
  };
};

/// Mass and a surface for contact.
struct SectionNull : NullLaw {
  template <class Pack>
  struct FibreUpdate {
    static constexpr bool can_yield = false;
    static constexpr bool has_stress = false;
    CRUMPLE_INLINE explicit FibreUpdate(const SectionTask& /*task*/) {}
  };
};

/// A law of plasticity with its own constants.
template <class Base>
struct YieldingFibre : Base {
  static constexpr bool can_yield = true;
  static constexpr bool has_stress = true;
  using Base::Base;
};

struct SectionPlasticKinematic : PlasticKinematicLaw {
  template <class Pack>
  using FibreUpdate = YieldingFibre<UpdateOf<FibrePlasticity<Pack, LinearHardening<double>>>>;
};

struct SectionPiecewiseLinear : PiecewiseLinearPlasticityLaw {
  template <class Pack>
  using FibreUpdate =
      YieldingFibre<UpdateOf<FibrePlasticity<Pack, TabulatedHardening<double>, TabulatedRate<double>>>>;
};

struct SectionPlasticityWithDamage : PlasticityWithDamageLaw {
  template <class Pack>
  using FibreUpdate = Fading<Pack, SectionPiecewiseLinear::FibreUpdate<Pack>>;
};

struct SectionPowerLaw : PowerLawPlasticityLaw {
  template <class Pack>
  using FibreUpdate = YieldingFibre<UpdateOf<FibrePlasticity<Pack, PowerHardening<double>>>>;
};

/// Without heat and damage, as *MAT_SIMPLIFIED_JOHNSON_COOK.
struct SectionJohnsonCook : JohnsonCookLaw {
  template <class Pack>
  struct Simplified : FibrePlasticity<Pack, JohnsonCookHardening<double>, LogarithmicRate<double>> {
    using Base = FibrePlasticity<Pack, JohnsonCookHardening<double>, LogarithmicRate<double>>;
    CRUMPLE_INLINE explicit Simplified(const SectionTask& task)
        : Base(task.constants[Youngs], task.constants[Poissons], 0,
               JohnsonCookHardening<double>{task.constants[Initial], task.constants[Modulus],
                                            task.constants[Exponent], task.constants[Largest],
                                            task.constants[Saturation]},
               LogarithmicRate<double>(task.constants[RateCoefficient], task.constants[ReferenceRate],
                                       task.step, task.constants[Viscoplastic] != 0),
               task.constants[Failure]) {}
  };
  template <class Pack>
  using FibreUpdate = YieldingFibre<Simplified<Pack>>;
};

/// Every constitutive law of integrated beams, one line each.
template <class... Laws>
struct SectionLawList {};
using SectionLaws = SectionLawList<  //
    SectionElastic,                  //
    SectionPlasticKinematic,         //
    SectionPlasticityWithDamage,     //
    SectionPiecewiseLinear,          //
    SectionPowerLaw,                 //
    SectionJohnsonCook,              //
    SectionNull>;

}  // namespace crumple::materials
