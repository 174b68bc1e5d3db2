// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/eos/gruneisen.hpp"
#include "materials/eos/linear_polynomial.hpp"
#include "materials/laws/blatz_ko.hpp"
#include "materials/laws/crushable_foam.hpp"
#include "materials/laws/elastic.hpp"
#include "materials/laws/johnson_cook.hpp"
#include "materials/laws/mooney_rivlin.hpp"
#include "materials/laws/null.hpp"
#include "materials/laws/orthotropic_elastic.hpp"
#include "materials/laws/piecewise_linear_plasticity.hpp"
#include "materials/laws/plastic_kinematic.hpp"
#include "materials/laws/power_law_plasticity.hpp"

namespace crumple::materials {

template <class... Laws>
struct LawList {
  static constexpr int count = sizeof...(Laws);
};

/// Every constitutive law of shells, one line each. What a law must have is written in tile_update.hpp (the
/// update, a template over the pack) and in registry.cpp (name, history and constants).
using ShellLaws = LawList<         //
    ElasticLaw,                    //
    PlasticKinematicLaw,           //
    PiecewiseLinearPlasticityLaw,  //
    PowerLawPlasticityLaw,         //
    JohnsonCookLaw,                //
    OrthotropicElasticLaw,         //
    NullLaw>;

/// Every constitutive law of solids. What a law must have is written in solid_update.hpp (its SolidUpdate).
using SolidLaws = LawList<         //
    ElasticLaw,                    //
    PlasticKinematicLaw,           //
    PiecewiseLinearPlasticityLaw,  //
    PowerLawPlasticityLaw,         //
    JohnsonCookLaw,                //
    NullLaw,                       //
    BlatzKoLaw,                    //
    MooneyRivlinLaw,               //
    CrushableFoamLaw>;

/// Every equation of state of solids. What one must have: `constants`, and at(constants, mu) as eos_point.hpp
/// says.
using EquationsOfState = LawList<  //
    GruneisenEquation,             //
    LinearPolynomialEquation>;

}  // namespace crumple::materials
