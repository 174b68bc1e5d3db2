// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "base/index.hpp"
#include "domain/element_block.hpp"

namespace crumple::elements {

/// Numbers of the item "erosion" of one point: whether it has failed, the strain xx, yy, zz, xy, yz, zx
/// (shears of the tensor) and the impulse, and what rounding has taken from these seven: sums in float would
/// drift.
namespace erosion_item {
inline constexpr Index failed = 0;
inline constexpr Index strain = 1;
inline constexpr Index impulse = 7;
inline constexpr Index rest = 7;  ///< from a number to what it has lost
inline constexpr Index count = 15;
}  // namespace erosion_item

/// What makes points of one block fail beside its law (*MAT_ADD_EROSION): docs/theory/erosion.md.
struct ErosionCheck {
  const model::ErosionCriteria* criteria = nullptr;
  Index first = 0;           ///< component of the item "erosion"
  Index plastic_strain = 0;  ///< of the law's item, or no_index
  double time = 0;           ///< at the end of the step [time]
  double step = 0;           ///< [time]
};

/// The check of a block that has criteria.
ErosionCheck erosion_check(const domain::ElementBlock& block, double time, double step);

/// Adds the item to a block under construction whose points are known.
void declare_erosion(domain::ElementBlock& block);

/// One tile whose points the material has brought up to date. Rows of the scratch are tile_lanes apart.
template <class Real>
struct ErosionTile {
  Real* state = nullptr;  ///< of the first group; the stress stands at component 0
  std::ptrdiff_t group_stride = 0;
  Index groups = 0;
  int planes = 1;                          ///< of a shell
  int points = 1;                          ///< of one plane
  const Real* strain = nullptr;            ///< increments of the middle of the step [point][5 or 6]
  const Real* turn = nullptr;              ///< of solids: rotation less the unit matrix [point][9]
  const Real* thickness_strain = nullptr;  ///< of shells: increment zz [plane]
  const Real* weight = nullptr;            ///< of shells: share of a point in its plane
  const Real* area = nullptr;              ///< of shells: factor on that [point], or nullptr
  Real* energy = nullptr;                  ///< work density of the step: of solids [point], of shells [plane]
  Real* intact = nullptr;                  ///< [plane] of the law; zero where the element has failed
};

/// Counts the criteria of every point, takes the stress from those that have failed, with its share in the
/// work of the step, and leaves in `intact` which elements go. Plain loops over lanes: the same bits for
/// every instruction set.
template <class Real>
void check_erosion(const ErosionCheck& check, const ErosionTile<Real>& tile);

}  // namespace crumple::elements
