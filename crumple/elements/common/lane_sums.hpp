// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "base/aligned_array.hpp"
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

/// Sums of a chunk, lane by lane over the groups: the same bits for every width of pack.
template <class Pack>
struct LaneSums {
  using Real = RealOf<Pack>;
  alignas(cache_line) double internal[lanes] = {};
  alignas(cache_line) double hourglass[lanes] = {};
  alignas(cache_line) Real shortest[lanes];

  LaneSums() {
    for (Real& limit : shortest) limit = Real(1e30);
  }
  CRUMPLE_INLINE void add_group(const Real* rows) {
    add(internal, rows + sum_row::internal_energy * materials::tile_lanes);
    add(hourglass, rows + sum_row::hourglass_energy * materials::tile_lanes);
    const Real* const limit = rows + sum_row::shortest_step * materials::tile_lanes;
    for (Index lane = 0; lane < lanes; lane += width_of<Pack>)
      store(shortest + lane, smaller(load<Pack>(limit + lane), load<Pack>(shortest + lane)));
  }
  CRUMPLE_INLINE static void add(double* sums, const Real* row) {
    using Four = std::conditional_t<sizeof(Real) == sizeof(float), math::Float4, math::Double4>;
    for (Index lane = 0; lane < lanes; lane += 4)
      math::write(sums + lane,
                  math::read<math::Double4>(sums + lane) + math::to_double(math::read<Four>(row + lane)));
  }
  /// Adds up over the lanes in order.
  void add_to(ElementSums& sums) const {
    for (Index lane = 0; lane < lanes; ++lane) {
      sums.internal_energy += internal[lane];
      sums.hourglass_energy += hourglass[lane];
      const auto limit = static_cast<double>(shortest[lane]);
      sums.shortest_step = limit < sums.shortest_step ? limit : sums.shortest_step;
    }
  }
};

/// Adds up what damping took of the elements of a tile, in their order.
template <class Pack>
void add_damping_energy(const RealOf<Pack>* row, Index groups, ElementSums& sums) {
  for (Index place = 0; place < groups * lanes; ++place)
    sums.damping_energy += static_cast<double>(row[place]);
}

}  // namespace crumple::elements
