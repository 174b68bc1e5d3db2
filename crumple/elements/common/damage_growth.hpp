// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "base/index.hpp"
#include "domain/element_block.hpp"
#include "elements/common/point_tile.hpp"

namespace crumple::elements {

// Damage D that grows with the plastic strain (F. Neukamm, M. Feucht & A. Haufe, Considering damage history
// in crashworthiness simulations, 7th European LS-DYNA Conference, 2009): docs/theory/gissmo.md.
//
// The law works on the stress that the material would have without damage. The state holds the damaged one,
// so that forces, contact and output need not know: restore_stress() takes the damage out of it before the
// law is called, grow_damage() puts what it has become back in. Where there is none both leave the stress
// alone.

/// Numbers of the item "damage_history": of the element its size, then for each point these. Sums have what
/// rounding has taken from them behind them.
namespace damage_item {
inline constexpr Index size = 0;  ///< [length], at time zero
inline constexpr Index points = 1;
inline constexpr Index lost = 0;         ///< share of the stress that damage takes; 1: the point has failed
inline constexpr Index root = 1;         ///< D^(1/n), two numbers
inline constexpr Index instability = 3;  ///< F^(1/n), two numbers
inline constexpr Index critical = 5;     ///< D when F reached one
inline constexpr Index plastic_strain = 6;  ///< before the step, two numbers
inline constexpr Index work = 8;            ///< that the lost stress of the step's start would have done
inline constexpr Index per_point = 9;
}  // namespace damage_item

/// What makes damage grow in one block.
struct DamageGrowth {
  const model::GissmoDamage* law = nullptr;
  Index damage = 0;                                    ///< component of the item "gissmo_damage" [point]
  Index history = 0;                                   ///< and of "damage_history"
  std::vector<std::array<Index, 2>> plastic_strain{};  ///< by point: components of the sum
  double step = 0;                                     ///< [time]
};

/// The growth of a block that has damage. Throws Error if its law has no plastic strain at a point.
DamageGrowth damage_growth(const domain::ElementBlock& block, double step);

/// Adds the items to a block under construction whose points, and the items of whose law, are known.
void declare_damage(domain::ElementBlock& block);

/// Sets the size [length] that an element had at time zero: of shells the root of the area, of solids the
/// cubic root of the volume.
void set_damage_size(domain::ElementBlock& block, Index place, double size);

/// Before the law: makes undamaged stresses of those in the state.
template <class Real>
void restore_stress(const DamageGrowth& growth, const PointTile<Real>& tile);

/// After it: adds to the damage, lowers the stresses, corrects the work of the step, and leaves in `intact`
/// which elements go. Plain loops over lanes: the same bits for every instruction set.
template <class Real>
void grow_damage(const DamageGrowth& growth, const PointTile<Real>& tile);

}  // namespace crumple::elements
