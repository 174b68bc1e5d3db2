// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "domain/shell_block.hpp"
#include "elements/common/constants.hpp"
#include "elements/common/element_task.hpp"
#include "materials/common/shell_material.hpp"

namespace crumple::elements {

/// Numbers of a block that are the same for all its elements.
template <class Real>
struct ShellConstants {
  int points = 0;       ///< through the thickness
  int planes = 1;       ///< points in plane
  int formulation = 0;  ///< place in the list of formulations
  int material = 0;     ///< place in the list of constitutive laws
  Index history = 0;    ///< first component of the material's items in the state
  Index own = 0;        ///< first component of the element's items, see ElementState
  bool viscous = true;  ///< hourglass form: viscous, else stiffness
  bool thickness_change = false;
  bool can_fail = false;  ///< elements may erode; their energy is then kept, see element_state::energy
  Real place[materials::max_points] =
      {};  ///< of the points over half the thickness, from the surface of the nodes
  Real weight[materials::max_points] = {};  ///< of the points, summing to 1
  Real shear_root = 1;  ///< square root of the shear factor: on shear strains and, again, on their stresses
  Real hourglass_membrane = 0;  ///< see hourglass.hpp; with 2 x 2 points in plane the drilling modulus
  Real hourglass_warping = 0;
  Real hourglass_bending = 0;
  Real slowness = 0;        ///< 1 / plate wave speed [time/length]
  Real poissons_ratio = 0;  ///< of the elastic part, for assumed strains [-]
};

/// The element's own items, counted from ShellConstants::own.
namespace element_state {
inline constexpr Index thickness = 0;
inline constexpr Index active = 1;      ///< 1, or 0: no force, no energy, no limit on the step
inline constexpr Index frame = 2;       ///< two numbers, see lamina_frame.hpp
inline constexpr Index step_scale = 4;  ///< on area / longest side: triangles, mass, LoneElements
inline constexpr Index hourglass = 5;   ///< five generalised hourglass stresses
inline constexpr Index energy = 10;     ///< internal and hourglass energy of the element, if it can fail
}  // namespace element_state

/// Points through the thickness that one law brings up to date; see domain::LayerRun.
template <class Real>
struct LayerCall {
  materials::MaterialUpdate<Real> update = nullptr;
  int first = 0;
  int points = 0;
  Index history = 0;
  Index constants = 0;
  bool can_fail = false;
};

/// One chunk of one block.
template <class Real>
struct ShellTask : ElementTask<Real> {
  ShellConstants<Real> constants;
  materials::MaterialUpdate<Real> material = nullptr;  ///< of all points, unless there are layers
  const LayerCall<Real>* layers = nullptr;
  int layer_calls = 0;  ///< 0: one law for all points
  bool layers_hold = false;
};

}  // namespace crumple::elements
