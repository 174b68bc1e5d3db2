// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The constitutive laws: from the strain increments of a step to the stresses at its end. A law knows no
// element, an element no law; they meet in one function pointer, so that F formulations and M laws cost F + M
// kernels (docs/architecture.md).
//
//     formulation                          law, one call per tile (2 groups of 16 elements)
//     -----------                          -------------------------------------------------
//     strains()   strain increments  --->  for every point: stress(n) from stress(n-1), increment, history
//     forces()    stresses           <---  energy += 1/2 (stress(n-1) + stress(n)) : increment
//                                          thickness strain (shells), wave speed (solids), intact or failed
//
// Order of calls: once per block, through registry.cpp, which asks this list: shell_material_kind() finds the
// law, declare_history() adds what it keeps per point, shell_material_constants() gives the numbers that its
// kernel reads, prepare_element() sets what depends on the axes of an element. In every step the function
// that shell_material_update(isa, kind) returns is called with a MaterialTask for each tile and each point in
// plane. Solids have the same functions with `solid` in their names, but for the last of the preparation
// (common/solid_material.hpp); a pressure by an equation of state is added to the deviator that the law
// computes (eos_update.hpp).
//
// Rooms: laws/ has one file per law; plasticity/ the returns to the yield surface that laws share: in plane
// stress by J.C. Simo & R.L. Taylor, IJNME 22 (1986) 649-670, of solids the radial return of M.L. Wilkins,
// Methods in Computational Physics 3 (1964) 211-263; eos/ the equations of state; common/ tasks, stresses and
// the loop over points (tile_update.hpp; that of solids is solid_update.hpp, of cohesive solids
// separation_update.hpp). The kernels,
// kernels/shell_laws.cpp and solid_laws.cpp, compile all laws of a list once per instruction set. Equations,
// sources and limits of each law: docs/theory. How to add one: docs/adding_a_material.md.

#include "materials/eos/gruneisen.hpp"
#include "materials/eos/linear_polynomial.hpp"
#include "materials/laws/bilkhu_dubois_foam.hpp"
#include "materials/laws/blatz_ko.hpp"
#include "materials/laws/cap_concrete.hpp"
#include "materials/laws/cohesive.hpp"
#include "materials/laws/composite_damage.hpp"
#include "materials/laws/compression_tension.hpp"
#include "materials/laws/crushable_foam.hpp"
#include "materials/laws/elastic.hpp"
#include "materials/laws/fabric.hpp"
#include "materials/laws/failing_solid.hpp"
#include "materials/laws/holmquist_ceramic.hpp"
#include "materials/laws/holmquist_concrete.hpp"
#include "materials/laws/honeycomb.hpp"
#include "materials/laws/hydro_plasticity.hpp"
#include "materials/laws/johnson_cook.hpp"
#include "materials/laws/laminated_fabric.hpp"
#include "materials/laws/low_density_foam.hpp"
#include "materials/laws/mooney_rivlin.hpp"
#include "materials/laws/null.hpp"
#include "materials/laws/ogden_rubber.hpp"
#include "materials/laws/orthotropic_elastic.hpp"
#include "materials/laws/piecewise_linear_plasticity.hpp"
#include "materials/laws/plastic_kinematic.hpp"
#include "materials/laws/plasticity_with_damage.hpp"
#include "materials/laws/polynomial_rubber.hpp"
#include "materials/laws/power_law_plasticity.hpp"
#include "materials/laws/relaxing_rubber.hpp"
#include "materials/laws/sheet_plasticity.hpp"
#include "materials/laws/simplified_rubber.hpp"
#include "materials/laws/soil_and_foam.hpp"
#include "materials/laws/strain_limited_plasticity.hpp"
#include "materials/laws/three_surface_concrete.hpp"
#include "materials/laws/viscoelastic.hpp"
#include "materials/laws/viscous_foam.hpp"

namespace crumple::materials {

template <class... Laws>
struct LawList {
  static constexpr int count = sizeof...(Laws);
};

/// Every constitutive law of shells, one line each. What a law must have is written in tile_update.hpp (the
/// update, a template over the pack) and in registry.cpp (name, history and constants). Of two laws of the
/// same description the first that `takes` it counts.
using ShellLaws = LawList<         //
    ElasticLaw,                    //
    PlasticKinematicLaw,           //
    PlasticityWithDamageLaw,       //
    CompressionTensionLaw,         //
    StrainLimitedPlasticityLaw,    //
    PiecewiseLinearPlasticityLaw,  //
    PowerLawPlasticityLaw,         //
    JohnsonCookLaw,                //
    OrthotropicElasticLaw,         //
    CompositeDamageLaw,            //
    NullLaw,                       //
    FabricLaw,                     //
    NormalAnisotropyLaw,           //
    BarlatLaw,                     //
    LaminatedFabricLaw>;

/// Every constitutive law of solids. What a law must have is written in solid_update.hpp (its SolidUpdate).
using SolidLaws = LawList<         //
    ElasticLaw,                    //
    PlasticKinematicLaw,           //
    PlasticityWithDamageLaw,       //
    PiecewiseLinearPlasticityLaw,  //
    PowerLawPlasticityLaw,         //
    JohnsonCookLaw,                //
    NullLaw,                       //
    BlatzKoLaw,                    //
    MooneyRivlinLaw,               //
    CrushableFoamLaw,              //
    LowDensityFoamLaw,             //
    RelaxingOgdenLaw,              //
    OgdenRubberLaw,                //
    RelaxingPolynomialLaw,         //
    PolynomialRubberLaw,           //
    ViscoelasticLaw,               //
    HoneycombLaw,                  //
    SoilAndFoamLaw,                //
    ViscousFoamLaw,                //
    SimplifiedRubberLaw,           //
    BilkhuDuboisFoamLaw,           //
    CapConcreteLaw,                //
    ThreeSurfaceConcreteLaw,       //
    HolmquistCeramicLaw,           //
    HolmquistConcreteLaw,          //
    HydroPlasticityLaw,            //
    FailingSolidLaw,               //
    CompressionTensionLaw,         //
    CohesiveLaw>;

/// Every equation of state of solids. What one must have: `constants`, and at(constants, mu) as eos_point.hpp
/// says.
using EquationsOfState = LawList<  //
    GruneisenEquation,             //
    LinearPolynomialEquation>;

}  // namespace crumple::materials
