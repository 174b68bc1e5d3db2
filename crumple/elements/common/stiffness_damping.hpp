// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "base/index.hpp"
#include "domain/damped_block.hpp"
#include "materials/common/shell_material.hpp"

namespace crumple::elements {

/// Numbers of the item "damping" of an element: its stable step without damping, then the damping stresses of
/// its points as the item "stress" has its own.
namespace damping_item {
inline constexpr Index stable_step = 0;
inline constexpr Index stress = 1;
}  // namespace damping_item

/// What the elements of one block resist the rates of their strains with: docs/theory/stiffness_damping.md.
struct StiffnessDamping {
  model::StiffnessDamping given;
  Index first = 0;    ///< component of the item "damping"
  double direct = 0;  ///< elastic stress along a strain, per strain [stress]
  double cross = 0;   ///< across it
  double shear = 0;   ///< of an engineering shear strain
  double step = 0;    ///< of the present cycle [time]
};

/// The damping of a shell's stress in its plane, or of a solid's; `averages` leaves mean stresses out.
StiffnessDamping shell_damping(const materials::ElasticConstants& elastic);
StiffnessDamping solid_damping(const materials::ElasticConstants& elastic, bool averages);

/// Adds item and moduli to a block under construction whose points are known. Does nothing without damping.
void declare_damping(const StiffnessDamping& damping, Index components, domain::DampedBlock& block);

/// The damping of a block that has some.
StiffnessDamping damping_of(const domain::DampedBlock& block, double step);

/// The part of an undamped stable step that is stable with damping, sqrt(1 + x^2) - x with the share x of
/// critical damping at the highest frequency: velocities are half a step late (own derivation,
/// docs/theory/stiffness_damping.md).
double damped_share(const model::StiffnessDamping& damping, double undamped_step);

/// One tile whose points the material has brought up to date. Rows of the scratch are tile_lanes apart.
template <class Real>
struct DampingTile {
  Real* state = nullptr;  ///< of the first group; the stress stands at component 0
  std::ptrdiff_t group_stride = 0;
  Index groups = 0;
  int planes = 1;                ///< of a shell
  int points = 1;                ///< of one plane
  Real* strain = nullptr;        ///< in: increments of the middle of the step [point][5 or 6]
  const Real* turn = nullptr;    ///< of solids: rotation less the unit matrix [point][9]
  const Real* weight = nullptr;  ///< of shells: share of a point in its plane
  const Real* area = nullptr;    ///< of shells: factor on that [point], or nullptr
  Real* work = nullptr;          ///< out: work density of the step, of solids [point], of shells [plane]
  Real* limit = nullptr;         ///< stable step
};

/// Adds the damping stresses to those of the points, where the law leaves any: for the forces alone. Keeps
/// the law's own in the place of the strain increments. Plain loops over lanes: the same bits for every
/// instruction set.
template <class Real>
void add_damping(const StiffnessDamping& damping, const DampingTile<Real>& tile);

/// Puts the law's own stresses back, and shortens the stable step.
template <class Real>
void end_damping(const StiffnessDamping& damping, const DampingTile<Real>& tile);

}  // namespace crumple::elements
