// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"
#include "domain/element_block.hpp"
#include "elements/common/point_tile.hpp"

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

/// Counts the criteria of every point, takes the stress from those that have failed, with its share in the
/// work of the step, and leaves in `intact` which elements go. Plain loops over lanes: the same bits for
/// every instruction set.
template <class Real>
void check_erosion(const ErosionCheck& check, const PointTile<Real>& tile);

}  // namespace crumple::elements
