// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "base/aligned_array.hpp"
#include "domain/node_fields.hpp"
#include "math/pack_vec3.hpp"
#include "math/small_vectors.hpp"

namespace crumple::elements {

/// Internal forces at the nodes of solids, global axes.
template <class Pack, int Corners = 8>
struct SolidForces {
  math::PackVec3<Pack> of[Corners];
};

CRUMPLE_INLINE void subtract_force(domain::NodeForce& sum, const math::Float4& v) {
  math::write(sum.force, math::read<math::Double4>(sum.force) - math::to_double(v));
}
CRUMPLE_INLINE void subtract_force(domain::NodeForce& sum, const math::Double4& v) {
  math::write(sum.force, math::read<math::Double4>(sum.force) - v);
}

/// Subtracts internal forces from the sums at the nodes as scatter() does for shells; `target` is
/// [corner][lanes].
template <class Pack, int Corners>
CRUMPLE_INLINE void scatter_solids(domain::NodeForce* sums, const Index* target,
                                   const SolidForces<Pack, Corners>& internal) {
  using Real = RealOf<Pack>;
  using Item = std::conditional_t<std::is_same_v<Real, float>, math::Float4, math::Double4>;
  constexpr int width = width_of<Pack>;
  alignas(cache_line) Real rows[Corners][3][width];
  for (int k = 0; k < Corners; ++k) {
    store(rows[k][0], internal.of[k].x);
    store(rows[k][1], internal.of[k].y);
    store(rows[k][2], internal.of[k].z);
  }
  if constexpr (width >= 4) {
    for (int lane = 0; lane < width; lane += 4) {
      math::Four<Item> items[Corners];
      for (int k = 0; k < Corners; ++k)
        items[k] = math::transposed(math::read<Item>(&rows[k][0][lane]), math::read<Item>(&rows[k][1][lane]),
                                    math::read<Item>(&rows[k][2][lane]), Item{});
      for (int i = 0; i < 4; ++i)
        for (int k = 0; k < Corners; ++k) subtract_force(sums[target[k * lanes + lane + i]], items[k].row[i]);
    }
  } else {
    for (int lane = 0; lane < width; ++lane)
      for (int k = 0; k < Corners; ++k)
        for (int axis = 0; axis < 3; ++axis)
          sums[target[k * lanes + lane]].force[axis] -= static_cast<double>(rows[k][axis][lane]);
  }
}

}  // namespace crumple::elements
