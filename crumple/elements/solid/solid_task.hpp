// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "elements/common/constants.hpp"
#include "elements/common/element_task.hpp"
#include "materials/common/solid_material.hpp"

namespace crumple::elements {

/// Numbers of a block of solids that are the same for all its elements.
template <class Real>
struct SolidConstants {
  int points = 1;
  int formulation = 0;  ///< place in the list of formulations
  int material = 0;     ///< place in the list of constitutive laws of solids
  Index history = 0;    ///< first component of the material's items in the state
  Index own = 0;        ///< first component of the element's items, see solid_state
  bool can_fail = false;
  bool exact_volume = false;        ///< mean gradients over the volume in the place of those at the centre
  bool without_linear_part = true;  ///< hourglass control spares linear velocity fields that are no patterns
  bool viscous = true;              ///< hourglass form: viscous, else stiffness
  bool assumed_strain = false;  ///< stiffness form in the element's own axes, see hexahedron_hourglass.hpp
  Real hourglass = 0;           ///< see hourglass_modulus(); with assumed strains QM mu
  // Of assumed strains: roots of the moduli over mu, of pairs of modes that bend and of the one that warps.
  Real bend_together = 0;  ///< sqrt((1 + nu) / (1 - nu)); 1 where the two are opposed [-]
  Real warp = 0;           ///< sqrt(2 (1 + nu) / 3) [-]
  Real density = 0;        ///< at time zero [mass/volume]
  Real shear_share = 0;    ///< 2 mu / (lambda + 2 mu) at time zero, at most 1 [-]
  Real wave_speed = 0;     ///< of longitudinal waves without lateral strain, at time zero [length/time]
  /// Component of the state with the wave speed at the end of the last step, where the material tells a new
  /// one every step; 0: it does not vary.
  Index present_wave_speed = 0;
  Index equation_of_state = 0;     ///< first of its numbers in the material's constants; 0: there is none
  Real interior_modulus = 0;       ///< of interior contact [stress]; 0: there is none
  Real interior_volume = 0;        ///< relative volume below which it acts [-]
  Real interior_speed_square = 0;  ///< what it adds to the square of the wave speed [(length/time)^2]
  Real bulk_quadratic = 0;         ///< Q1 [-]
  Real bulk_linear = 0;            ///< Q2 [-]
  Real point_place = 0;            ///< of cohesive solids: coordinates of the points in the parent square [-]
};

/// The element's own items, counted from SolidConstants::own.
namespace solid_state {
inline constexpr Index reference_volume = 0;  ///< at time zero; of cohesive solids the area
inline constexpr Index active = 1;            ///< 1, or 0: no force, no energy, no limit on the step
inline constexpr Index step_scale = 2;        ///< on the stable step: mass scaling, LoneElements; of cohesive
                                              ///< solids, which have a length and speed of one, the step
inline constexpr Index bulk_viscosity = 3;    ///< pressure that resists compression
inline constexpr Index own = 4;               ///< what the formulation keeps, see KeptItem
}  // namespace solid_state

/// What a formulation of solids keeps of an element from step to step, beside the stress. Behind it stand the
/// internal and the hourglass energy of the element, if it can fail.
struct KeptItem {
  const char* name = "";
  const char* unit = "";
  Index count = 0;
};

/// One chunk of one block.
template <class Real>
struct SolidTask : ElementTask<Real> {
  SolidConstants<Real> constants;
  materials::SolidMaterialUpdate<Real> material = nullptr;
};

}  // namespace crumple::elements
