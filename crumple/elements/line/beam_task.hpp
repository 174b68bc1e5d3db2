// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "domain/beam_block.hpp"
#include "domain/node_fields.hpp"
#include "elements/common/element_sums.hpp"
#include "materials/common/section_material.hpp"

namespace crumple::elements {

/// Independent resultants in the middle of a weld.
inline constexpr int weld_modes = 6;

/// Numbers of a block of beams that are the same for all its elements.
struct BeamConstants {
  double area = 0;              ///< [length^2]
  double youngs_modulus = 0;    ///< E [stress]
  double bending_s = 0;         ///< E I about s [force length^2]
  double bending_t = 0;         ///< E I about t [force length^2]
  double twisting = 0;          ///< G J [force length^2]
  double shear_stiffness = 0;   ///< G times the shear area [force]; zero: no transverse shear
  double plastic = 0;           ///< 1: the law has a yield stress
  double yield_stress = 0;      ///< [stress]
  double isotropic = 0;         ///< isotropic part of the plastic modulus [stress]
  double kinematic = 0;         ///< kinematic part [stress]
  double rate = 0;              ///< C of Cowper and Symonds [1/time]; 0: no effect
  double rate_exponent = 1;     ///< 1/p of Cowper and Symonds [-]
  double failure_strain = 0;    ///< plastic strain at failure [-]; 0: none
  double plastic_force = 0;     ///< axial force at which the whole section yields [force]
  double plastic_moment_s = 0;  ///< moment at which it does, about s [force length]
  double plastic_moment_t = 0;  ///< about t [force length]
  double failure_time = 1e20;   ///< of welds [time]
  /// Of welds, the resultants at which the whole section yields by one alone, over the yield stress: axial,
  /// shear, shear, torsion, bending, bending [length^2, length^3].
  std::array<double, weld_modes> capacity{};
  std::array<double, weld_modes> strength{};  ///< those at which it fails; 0: does not count [force, moment]
  double section_points = 0;                  ///< of integrated beams
  double section_material = 0;                ///< materials::section_material_kind
  double section_fails = 0;                   ///< 1: its points can fail
  double shear_root = 1;                      ///< square root of the factor on the shear stiffness [-]
  double stress = 0;                          ///< first component of the item "stress"
  double history = 0;                         ///< first component of the material's items
  double first_share = 0.5;           ///< of discrete beams: of the first node in the turn of the axes
  std::array<double, 3> held_turn{};  ///< 1: these do not turn about that axis
};

/// What every beam's state begins with; the formulation's items follow.
namespace beam_state {
inline constexpr Index active = 0;            ///< 1, or 0: no force, no energy, no limit on the step
inline constexpr Index stable_step = 1;       ///< at the length of time zero, mass scaling included
inline constexpr Index reference_length = 2;  ///< at time zero
inline constexpr Index own = 3;
}  // namespace beam_state

/// Items of a truss.
namespace truss_state {
inline constexpr Index length = beam_state::own;  ///< at time n
inline constexpr Index stress = length + 1;
inline constexpr Index plastic_strain = stress + 1;
inline constexpr Index back_stress = plastic_strain + 1;
inline constexpr Index energy = back_stress + 1;  ///< internal energy of the element and a zero
inline constexpr Index count = energy + 2;
}  // namespace truss_state

/// Items of a beam: see belytschko_schwer.hpp.
namespace resultant_state {
inline constexpr Index axes = beam_state::own;       ///< of first and second end: r and s of the end, global
inline constexpr Index deformation = axes + 12;      ///< conjugate to `resultant`
inline constexpr Index resultant = deformation + 6;  ///< axial force, torsion, moments about s, t at each end
inline constexpr Index plastic =
    resultant + 6;  ///< if the law is plastic: stretch, turns about s, t at each end
}  // namespace resultant_state

/// Items of a spot weld besides those of `resultant_state`.
namespace weld_state {
inline constexpr Index plastic = resultant_state::plastic;  ///< deformations of the middle
inline constexpr Index plastic_strain = plastic + weld_modes;
inline constexpr Index energy = plastic_strain + 1;  ///< internal energy of the element and a zero
inline constexpr Index failure_time = energy + 2;    ///< zero while it holds
}  // namespace weld_state

/// Items of an integrated beam besides those of `resultant_state`; stresses and the law's history follow.
namespace integrated_state {
inline constexpr Index energy = resultant_state::plastic;  ///< internal energy of the element and a zero
}  // namespace integrated_state

/// Items of a discrete beam.
namespace discrete_beam_state {
inline constexpr Index axes = beam_state::own;  ///< r and s, global
inline constexpr Index reference = axes + 6;    ///< from node to node at time zero along r, s, t; of lines
                                                ///< the length without force first
inline constexpr Index deformation = reference + 3;  ///< displacements along, turns about r, s, t
inline constexpr Index resultant = deformation + 6;  ///< forces along, moments about them
inline constexpr Index energy = resultant + 6;       ///< internal energy of the element and a zero
inline constexpr Index history = energy + 2;         ///< of laws that unload on a path of their own
}  // namespace discrete_beam_state

/// One chunk of one block.
struct BeamTask {
  const domain::Vec3* position = nullptr;          ///< x at time n
  const domain::Vec3* angular_velocity = nullptr;  ///< omega at n - 1/2
  domain::NodeForce* force = nullptr;
  const Index* node = nullptr;    ///< of the first group
  const Index* target = nullptr;  ///< of the first group
  double* state = nullptr;        ///< of the first group
  Index components = 0;
  Index groups = 0;
  domain::GroupEnergy* energy = nullptr;  ///< of the first group
  double* group_step = nullptr;           ///< of the first group, where mass is scaled; else nullptr
  double step = 0;                        ///< from n-1 to n [time]
  double time = 0;                        ///< n [time]
  model::StiffnessDamping damping{};
  Index damping_item = 0;  ///< first component of the item "damping"; 0: there is none
  BeamConstants constants;
  materials::SectionUpdate section = nullptr;  ///< of integrated beams
  const double* section_places = nullptr;      ///< their points [point][section_place]
  const double* material = nullptr;            ///< ElementBlock::material_constants
};

/// ElementBlock::element_constants and back. The places of a section's points may follow the numbers.
std::vector<double> to_numbers(const BeamConstants& constants);
BeamConstants beam_constants(const std::vector<double>& numbers);
const double* section_places(const std::vector<double>& numbers);

}  // namespace crumple::elements
