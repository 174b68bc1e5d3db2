// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/index.hpp"

namespace crumple::model {

enum class ShellFormulation {
  BelytschkoTsay,             ///< one-point corotational shell, Belytschko, Lin & Tsay 1984
  HughesLiu,                  ///< degenerated Mindlin-Reissner shell, Hughes & Liu 1981, one point in plane
  BelytschkoWongChiang,       ///< Belytschko-Tsay with warping stiffness, Belytschko, Wong & Chiang 1992
  HughesLiuSelectiveReduced,  ///< Hughes & Liu with 2 x 2 points in plane and one for the transverse shear
  FullyIntegrated,  ///< 2 x 2 points in plane with assumed strains, Engelmann, Whirley & Goudreau 1989
  Triangle,         ///< C0 triangle, Kennedy, Belytschko & Lin 1986
  Membrane,         ///< Belytschko-Tsay without bending and transverse shear
  FullyIntegratedMembrane,  ///< the membrane part of FullyIntegrated
  MembraneTriangle,         ///< constant strain; triangles in parts of the two before
};

/// True for those that have forces in their plane alone and leave the rotations of their nodes free.
constexpr bool is_membrane(ShellFormulation formulation) {
  return formulation == ShellFormulation::Membrane ||
         formulation == ShellFormulation::FullyIntegratedMembrane ||
         formulation == ShellFormulation::MembraneTriangle;
}

/// True for those that compute elements of three nodes.
constexpr bool is_triangular(ShellFormulation formulation) {
  return formulation == ShellFormulation::Triangle || formulation == ShellFormulation::MembraneTriangle;
}

/// True for those that have patterns of motion for hourglass control to hold.
constexpr bool is_hourglassing(ShellFormulation formulation) {
  return !is_triangular(formulation) && formulation != ShellFormulation::FullyIntegrated &&
         formulation != ShellFormulation::FullyIntegratedMembrane;
}

enum class ThicknessRule {
  Gauss,
  Lobatto,
  Trapezoid,  ///< equally spaced from surface to surface
};

struct ShellSection {
  UserId id = 0;
  std::string title;
  ShellFormulation formulation = ShellFormulation::BelytschkoTsay;
  double shear_factor = 1.0;  ///< correction of the transverse shear stiffness [-]
  int thickness_points = 2;   ///< integration points through the thickness
  ThicknessRule thickness_rule = ThicknessRule::Gauss;
  std::array<double, 4> thickness{};  ///< at the element's four nodes [length]
  /// Where the nodes lie: 1 on the upper surface, 0 in the middle, -1 on the lower one (NLOC) [-].
  double node_place = 0;
};

/// One integration point through the thickness of a layered shell, with its own material.
struct ShellLayer {
  Index material = no_index;  ///< in Model::materials
  double place = 0;           ///< over half the thickness: -1 lower, 1 upper surface [-]
  double share = 0;           ///< of the thickness; those of all layers sum to 1 [-]
  double angle =
      0;  ///< from the axes of an orthotropic material to those of the layer, about the normal [rad]
};

/// The layers of shells from the lower surface to the upper one (docs/theory/layered_shells.md).
struct Layup {
  std::vector<ShellLayer> layers;
  /// Places and shares are those of the section's rule, not those of the layers.
  bool follows_rule = false;
  /// The element stays as long as it has layers that cannot fail (FAILOPT = 1 of *INTEGRATION_SHELL); else it
  /// goes when all those have failed that can.
  bool unfailing_layers_hold = false;
  Index material = no_index;  ///< in Model::materials: what stands in for all of them, see layup_material()
};

enum class SolidFormulation {
  OnePointHexahedron,        ///< uniform strain, Flanagan & Belytschko 1981
  SelectiveHexahedron,       ///< 2 x 2 x 2 points with the mean dilatation, Hughes 1980
  AssumedStrainHexahedron,   ///< the same with assumed strains of bending, for elements longer than thick
  Tetrahedron,               ///< one point, constant stress
  NodalPressureTetrahedron,  ///< with the dilatation averaged at the nodes, Bonet & Burton 1998
  QuadraticTetrahedron,      ///< ten nodes, four points
  CohesiveHexahedron,        ///< two faces of four nodes that tractions hold together, 2 x 2 points
};

/// True for those whose material is tractions over the separation of two faces; their volume may be zero.
constexpr bool is_cohesive(SolidFormulation formulation) {
  return formulation == SolidFormulation::CohesiveHexahedron;
}

/// True for those that compute tetrahedra of ten nodes.
constexpr bool is_quadratic(SolidFormulation formulation) {
  return formulation == SolidFormulation::QuadraticTetrahedron;
}

/// True for those that compute tetrahedra, of four or of ten nodes.
constexpr bool is_tetrahedral(SolidFormulation formulation) {
  return formulation == SolidFormulation::Tetrahedron ||
         formulation == SolidFormulation::NodalPressureTetrahedron || is_quadratic(formulation);
}

/// True for hexahedra with 2 x 2 x 2 points.
constexpr bool is_selective(SolidFormulation formulation) {
  return formulation == SolidFormulation::SelectiveHexahedron ||
         formulation == SolidFormulation::AssumedStrainHexahedron;
}

struct SolidSection {
  UserId id = 0;
  std::string title;
  SolidFormulation formulation = SolidFormulation::OnePointHexahedron;
  bool nominal_strain = false;  ///< honeycomb has its curves over the nominal strain (ELFORM 0 and 9)
};

enum class BeamFormulation {
  Truss,             ///< axial force alone
  BelytschkoSchwer,  ///< resultants in axes that move with the beam, Belytschko, Schwer & Klein 1977
  SpotWeld,          ///< the same, elastic-plastic, fails by its resultants
  Integrated,        ///< stresses at points of the cross section half way, after Hughes & Liu 1981
  Discrete,          ///< a force or moment over a displacement or turn in each of six directions
};

/// What discrete beams have in the place of a cross section.
struct DiscreteBeamData {
  double volume = 0;   ///< half of it at each node; zero: cable area times length [length^3]
  double inertia = 0;  ///< half of it at each node [mass length^2]
  std::optional<std::array<std::array<double, 3>, 3>> axes{};  ///< r, s, t at time zero; absent: global
  double cable_area = 0;                                       ///< [length^2]
  double cable_offset = 0;  ///< length at time zero less length without force [length]
  double place = 0;  ///< the axes turn with the first node (-1), the second (1) or the mean of both (0)
  std::array<bool, 3> held{};  ///< they do not turn about r, s, t
};

/// An integration point of a cross section, from the line of the nodes.
struct SectionPoint {
  double s = 0;     ///< [length]
  double t = 0;     ///< [length]
  double area = 0;  ///< [length^2]
};

/// A cross section of a beam. Of a truss only the area counts. That of an integrated beam is its points: see
/// beam_section.hpp, which also gives the areas that follow from them.
struct BeamSection {
  UserId id = 0;
  std::string title;
  BeamFormulation formulation = BeamFormulation::BelytschkoSchwer;
  double area = 0;          ///< [length^2]
  double inertia_s = 0;     ///< second moment of area about s: bending in the plane of r and t [length^4]
  double inertia_t = 0;     ///< about t: bending in the plane of r and s [length^4]
  double torsion = 0;       ///< torsional constant J [length^4]
  double shear_area = 0;    ///< [length^2]; zero: no transverse shear
  double shear_factor = 1;  ///< of integrated beams, on the stiffness in transverse shear [-]
  std::vector<SectionPoint> points{};  ///< of integrated beams
  DiscreteBeamData discrete{};         ///< of discrete beams
};

struct DiscreteSection {
  UserId id = 0;
  std::string title;
  bool torsional = false;  ///< turns about its axis, moments; else lengthens, forces
};

enum class HourglassForm {
  Viscous,    ///< LS-DYNA's IHQ 1, 2, 3 for shells
  Stiffness,  ///< LS-DYNA's IHQ 4, 5 for shells
  Material,   ///< the stiffness that the material has in the patterns; of solids see solid_hourglass_of()
};

/// Of hexahedra with one point, in the order of LS-DYNA's IHQ 1 to 6; its default for explicit runs is the
/// second.
enum class SolidHourglassForm {
  StandardViscous,            ///< against the patterns alone, Hallquist 1982
  FlanaganBelytschkoViscous,  ///< against what is left of the motion without its linear part
  ExactVolumeViscous,         ///< the same with the mean gradient in the place of that at the centre
  FlanaganBelytschkoStiffness,
  ExactVolumeStiffness,
  AssumedStrain,  ///< stiffness of the material in the element's own axes, Belytschko & Bindeman 1993
};

struct HourglassControl {
  HourglassForm form = HourglassForm::Viscous;  ///< of shells
  double coefficient = 0.1;                     ///< QM: solids, and the membrane of shells [-]
  double bending = 0.1;                         ///< QB: bending of shells [-]
  double warping = 0.1;                         ///< QW: warping (transverse shear) of shells [-]
  double bulk_quadratic = 0;  ///< Q1: bulk viscosity of solids [-]; 0 takes Control::bulk_quadratic
  double bulk_linear = 0;     ///< Q2 [-]; 0 takes Control::bulk_linear
  SolidHourglassForm solid_form = SolidHourglassForm::FlanaganBelytschkoViscous;
};

}  // namespace crumple::model
