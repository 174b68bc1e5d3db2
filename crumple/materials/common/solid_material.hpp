// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/index.hpp"
#include "base/isa.hpp"
#include "domain/element_block.hpp"
#include "materials/common/shell_material.hpp"
#include "math/vec3.hpp"
#include "model/equation_of_state.hpp"
#include "model/material.hpp"

namespace crumple::materials {

/// Stress and strain components of a solid in global axes: xx, yy, zz, xy, yz, zx. Shear strains are
/// engineering ones (twice the tensor's).
inline constexpr int solid_components = 6;

/// Corners of a solid at time zero, as a list for hexahedra: a tetrahedron repeats its third and fourth.
using SolidCorners = std::array<math::Vec3, 8>;

/// Largest number of integration points of a solid.
inline constexpr int max_solid_points = 8;

/// One call of a material: all points of up to tile_groups groups of solids.
template <class Real>
struct SolidMaterialTask {
  Real* state = nullptr;            ///< state of the first group: [group][component][lane], updated in place
  std::ptrdiff_t group_stride = 0;  ///< from one group's state to the next
  Index groups = 0;
  int points = 0;
  Index stress = 0;              ///< first component of "stress" [point][6] in the state
  Index history = 0;             ///< first component of the material's own items
  const Real* strain = nullptr;  ///< increments of the middle of the step [point][6][tile_lanes], whose
                                 ///< stress is added after the turn
  const Real* turn = nullptr;    ///< rotation R of the step less the unit matrix, row by row [point][9]
                               ///< [tile_lanes]: float keeps that of a small rotation to full precision. The
                               ///< old stress s, and every tensor in the history, becomes R s R^T first
  const double* constants = nullptr;  ///< ElementBlock::material_constants
  Real step = 0;                      ///< the step that the increments belong to [time]; may be 0
  Real* energy = nullptr;             ///< out: [point][tile_lanes] 1/2 (turned old + new stress) : strain
  Real* intact = nullptr;  ///< out, if not nullptr: 1 where any of the points has not failed, else 0
  /// What eos_constants() returned, or nullptr: the law brings the pressure itself.
  const double* equation_of_state = nullptr;
  /// [tile_lanes] mean over the step of the pressure of bulk viscosity, for the energy; nullptr: none.
  const Real* viscosity = nullptr;
  /// Out, if not nullptr: [tile_lanes] largest speed of longitudinal waves over the points. Laws whose speed
  /// does not vary leave it alone.
  Real* wave_speed = nullptr;
};

template <class Real>
using SolidMaterialUpdate = void (*)(const SolidMaterialTask<Real>& task);

/// Place of the law in the list of those for solids, or -1 if solids cannot use it.
int solid_material_kind(const model::ConstitutiveLaw& law);

/// Adds the law's own items to a block whose points are set; returns the first component.
Index declare_solid_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block);

/// Adds the items of an equation of state; returns the first component.
Index declare_eos_history(domain::ElementBlock& block);

/// The numbers that the update reads. Throws Error naming the material if one is out of its range.
std::vector<double> solid_material_constants(const model::Material& material,
                                             const model::EquationOfState* equation = nullptr);

/// Sets what the law keeps for each element, once before the run; `history` is what declare_solid_history
/// returned. Throws Error naming the solid if its axes do not fit.
void prepare_solid_element(const model::ConstitutiveLaw& law, const SolidCorners& corners, UserId solid,
                           domain::ElementBlock& block, Index history, Index place);

/// Those of an equation of state, for SolidMaterialTask::equation_of_state; `history` is the first component
/// of its items less that of the law's. Throws as before.
std::vector<double> eos_constants(const model::Material& material, const model::EquationOfState& equation,
                                  Index history);

/// What elements need to know of a material of solids before they have a state.
struct SolidStart {
  double density = 0;           ///< [mass/volume]
  double wave_speed = 0;        ///< of longitudinal waves [length/time]
  bool varies = false;          ///< the update returns the wave speed of every step
  double linear_viscosity = 0;  ///< least coefficient of the linear bulk viscosity [-]
  bool own_viscosity = false;   ///< there is no other bulk viscosity than that
  double stiffness_share = 1;   ///< share of the elastic moduli that resists at time zero [-]
};
SolidStart solid_start(const model::Material& material, const model::EquationOfState* equation);

/// True if points of this material can fail in solids: SolidMaterialTask::intact must be given then.
bool solid_can_fail(const model::Material& material);

/// The update of a kind for an instruction set. Every one computes the same; AVX2 and AVX-512 to the bit, and
/// scalar and baseline to the bit.
template <class Real>
SolidMaterialUpdate<Real> solid_material_update(Isa isa, int kind);

}  // namespace crumple::materials
