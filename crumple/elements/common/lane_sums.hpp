// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <type_traits>

#include "base/aligned_array.hpp"
#include "domain/element_block.hpp"
#include "elements/common/element_sums.hpp"
#include "materials/common/shell_material.hpp"
#include "math/small_vectors.hpp"

namespace crumple::elements {

/// The first rows of every kind's scratch.
namespace sum_row {
inline constexpr int internal_energy = 0;   ///< increment of the step
inline constexpr int hourglass_energy = 1;  ///< the same
inline constexpr int shortest_step = 2;     ///< stable step
inline constexpr int count = 3;
}  // namespace sum_row

/// Sum of a row over the lanes of a group, in double and in one order for every width of pack. As in
/// shell/chunk.hpp the pack is among the parameters.
template <class Pack>
CRUMPLE_INLINE double sum_of_lanes(const RealOf<Pack>* row) {
  using Real = RealOf<Pack>;
  using Four = std::conditional_t<sizeof(Real) == sizeof(float), math::Float4, math::Double4>;
  static_assert(lanes == 16);
  const auto four = [&](Index lane) { return math::to_double(math::read<Four>(row + lane)); };
  const math::Double4 sum = (four(0) + four(4)) + (four(8) + four(12));
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// Where the sums over a group go.
struct GroupSums {
  domain::GroupEnergy* energy = nullptr;
  double* shortest_step = nullptr;  ///< see domain::ElementBlock::group_step; may be null
};

/// Those of one group of a chunk, counted from its first.
template <class Task>
CRUMPLE_INLINE GroupSums sums_of_group(const Task& task, std::ptrdiff_t group) {
  return {task.energy + group, task.group_step == nullptr ? nullptr : task.group_step + group};
}

/// Sums of a group, and the smallest stable step of a chunk lane by lane.
template <class Pack>
struct LaneSums {
  using Real = RealOf<Pack>;
  alignas(cache_line) Real shortest[lanes];

  LaneSums() {
    for (Real& limit : shortest) limit = Real(1e30);
  }
  CRUMPLE_INLINE void add_group(const Real* rows, const GroupSums& group) {
    using materials::tile_lanes;
    group.energy->internal += sum_of_lanes<Pack>(rows + sum_row::internal_energy * tile_lanes);
    group.energy->hourglass += sum_of_lanes<Pack>(rows + sum_row::hourglass_energy * tile_lanes);
    const Real* const limit = rows + sum_row::shortest_step * tile_lanes;
    for (Index lane = 0; lane < lanes; lane += width_of<Pack>)
      store(shortest + lane, smaller(load<Pack>(limit + lane), load<Pack>(shortest + lane)));
    if (group.shortest_step != nullptr) *group.shortest_step = smallest(limit);
  }
  double shortest_step() const { return smallest(shortest); }

 private:
  static double smallest(const Real* limits) {
    Real least = Real(1e30);
    for (Index lane = 0; lane < lanes; ++lane) least = limits[lane] < least ? limits[lane] : least;
    return static_cast<double>(least);
  }
};

/// Adds up what damping took of the elements of each group of a tile.
template <class Pack>
void add_damping_energy(const RealOf<Pack>* row, Index groups, domain::GroupEnergy* energy) {
  for (Index group = 0; group < groups; ++group)
    energy[group].damping += sum_of_lanes<Pack>(row + group * lanes);
}

}  // namespace crumple::elements
