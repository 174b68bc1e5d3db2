// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "base/isa.hpp"
#include "base/lanes.hpp"
#include "domain/element_block.hpp"
#include "math/vec3.hpp"
#include "model/material.hpp"

namespace crumple::materials {

/// Largest number of integration points through the thickness of a shell, and in its plane.
inline constexpr int max_points = 20;
inline constexpr int max_plane_points = 4;

/// Stress and strain components of a shell in lamina axes: xx, yy, xy, yz, zx. Shear strains are engineering
/// ones (twice the tensor's).
inline constexpr int components = 5;

/// Groups of `lanes` elements that a formulation hands to the material in one call: few enough that their
/// strains and geometry stay in the first-level cache, enough to make the call free.
inline constexpr Index tile_groups = 2;
inline constexpr Index tile_lanes = tile_groups * lanes;

/// Rows of MaterialTask::yield.
namespace yield_row {
inline constexpr int stress = 0;  ///< present yield stress, mean over the thickness; `unlimited` without one
inline constexpr int left = 1;    ///< what the return to the yield surface left of the trial stress, mean [-]
inline constexpr int count = 2;
}  // namespace yield_row

/// The yield stress of what does not yield. Its product with lengths is a number in any system of units.
inline constexpr double unlimited = 1e18;

/// One call of a material: the points over one point in plane, of up to tile_groups groups of elements.
template <class Real>
struct MaterialTask {
  Real* state = nullptr;            ///< state of the first group: [group][component][lane], updated in place
  std::ptrdiff_t group_stride = 0;  ///< from one group's state to the next
  Index groups = 0;
  int points = 0;                     ///< to bring up to date: those through the thickness
  int first_point = 0;                ///< number of the first of them in the element
  int all_points = 0;                 ///< of the element, in plane and through the thickness
  Index stress = 0;                   ///< first component of "stress" [all points][5] in the state
  Index history = 0;                  ///< first component of the material's own items
  const Real* strain = nullptr;       ///< increments [point][5][tile_lanes]
  const Real* weight = nullptr;       ///< [point], summing to 1
  const Real* area = nullptr;         ///< [point][tile_lanes] factor on the energy; nullptr is 1
  const double* constants = nullptr;  ///< ElementBlock::material_constants
  Real step = 0;                      ///< the step that the increments belong to [time]; may be 0
  Real* energy = nullptr;  ///< out: mean over the thickness of area * 1/2 (old + new stress) : strain
  Real* thickness_strain = nullptr;  ///< out: mean increment of the strain zz over the thickness
  Real* yield = nullptr;             ///< out, if not nullptr: yield_row::count rows of tile_lanes
  Real* intact = nullptr;  ///< out, if not nullptr: 1 where any of the points has not failed, else 0
};

template <class Real>
using MaterialUpdate = void (*)(const MaterialTask<Real>& task);

/// What the elements need of the elastic part, for step size, hourglass control and mass.
struct ElasticConstants {
  double youngs_modulus = 0;  ///< [stress]
  double poissons_ratio = 0;
  double density = 0;  ///< [mass/volume]

  double shear_modulus() const { return 0.5 * youngs_modulus / (1 + poissons_ratio); }
  /// Speed of longitudinal waves in a plate, sqrt(E / (rho (1 - nu^2))) [length/time].
  double plate_wave_speed() const;
  /// Speed of longitudinal waves without lateral strain, sqrt((lambda + 2 mu) / rho) [length/time].
  double bulk_wave_speed() const;
};

/// Place of the law in the list (materials/list.hpp), or -1 if shells cannot use it.
int shell_material_kind(const model::ConstitutiveLaw& law);

/// Name of the law, in words.
const char* shell_material_name(const model::ConstitutiveLaw& law);

/// Adds the law's own items ("plastic_strain", ...) to a block whose points are set; returns the first
/// component (the present end of the state if the law has none).
Index declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block);

/// The numbers that the update reads. Throws Error naming the material if one is out of its range.
std::vector<double> shell_material_constants(const model::Material& material);

/// Axes of an element at time zero.
struct LaminaAxes {
  math::Vec3 e1, e2, e3;  ///< those that stresses are counted in, see lamina_frame.hpp
  math::Vec3 side;        ///< from the first to the second node
  double angle = 0;       ///< model::ShellElement::material_angle [rad]
  UserId shell = 0;
  double layer_angle = 0;  ///< added to `angle`, or to the material's, in a layered shell [rad]
};

/// Sets what the law keeps for each element, once before the run; `history` is what declare_history returned.
/// Throws Error naming the shell if its axes do not fit.
void prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes, domain::ElementBlock& block,
                     Index history, Index place);

/// True if the law has axes in the plane, so that layers of it differ by their angles.
bool has_axes(const model::ConstitutiveLaw& law);

/// False if the material never has a stress: its shells limit no step and have no hourglass control.
bool has_stiffness(const model::ConstitutiveLaw& law);

/// True if points of this material can fail: MaterialTask::intact must be given then.
bool can_fail(const model::Material& material);

ElasticConstants elastic_constants(const model::Material& material);

/// The update of a kind for an instruction set. Every one computes the same; AVX2 and AVX-512 to the bit, and
/// scalar and baseline to the bit.
template <class Real>
MaterialUpdate<Real> shell_material_update(Isa isa, int kind);

}  // namespace crumple::materials
