// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "base/aligned_array.hpp"
#include "domain/node_fields.hpp"
#include "math/pack_vec3.hpp"
#include "math/small_vectors.hpp"

namespace crumple::elements {

/// The vectors of a pack's width of elements: number r of four has those of elements r, 4 + r, 8 + r and so
/// on side by side, which is what transposed() makes packs of. Narrow packs take one element at a time.
template <class Real, int Width>
using ItemsOf =
    std::conditional_t<std::is_same_v<Real, float>,
                       std::conditional_t<Width == 16, math::Float16,
                                          std::conditional_t<Width == 8, math::Float8, math::Float4>>,
                       std::conditional_t<Width == 8, math::Double8, math::Double4>>;

/// Internal forces at the nodes of solids, global axes.
template <class Pack, int Corners = 8>
struct SolidForces {
  math::PackVec3<Pack> of[Corners];
};

/// Nodal forces of one group of solids on their way to the nodes: four numbers of an element side by side.
template <class Real, int Corners>
struct GroupForces {
  alignas(cache_line) Real of[Corners][lanes * 4];
};

/// Place of an element in GroupForces::of[corner]: turning rows to columns in wide vectors leaves every
/// fourth element of a pack side by side.
template <int Width>
CRUMPLE_INLINE constexpr int place_in_group(int element) {
  if constexpr (Width < 4) return element * 4;
  const int in_pack = element % Width;
  return (element - in_pack) * 4 + in_pack % 4 * Width + in_pack / 4 * 4;
}

/// Puts the forces of the pack whose first element is `first` into those of its group.
template <class Pack, int Corners>
CRUMPLE_INLINE void keep_forces(GroupForces<RealOf<Pack>, Corners>& group, Index first,
                                const SolidForces<Pack, Corners>& internal) {
  using Real = RealOf<Pack>;
  constexpr int width = width_of<Pack>;
  for (int k = 0; k < Corners; ++k) {
    const math::PackVec3<Pack>& force = internal.of[k];
    Real* const to = group.of[k] + 4 * first;
    if constexpr (width >= 4) {
      using Items = ItemsOf<Real, width>;
      const auto item =
          math::transposed(__builtin_bit_cast(Items, force.x), __builtin_bit_cast(Items, force.y),
                           __builtin_bit_cast(Items, force.z), Items{});
      for (int r = 0; r < 4; ++r) math::write(to + r * width, item.row[r]);
    } else {
      alignas(Pack) Real row[3][width];
      store(row[0], force.x);
      store(row[1], force.y);
      store(row[2], force.z);
      for (int lane = 0; lane < width; ++lane) {
        for (int axis = 0; axis < 3; ++axis) to[4 * lane + axis] = row[axis][lane];
        to[4 * lane + 3] = Real(0);
      }
    }
  }
}

/// Subtracts the internal forces of a group from the sums at the nodes, in double: corner after corner, in
/// each element after element. So a node is left alone for a while before the next element adds to it: what
/// has just been written is slow to be read again. `target` is [corner][lanes].
template <class Pack, int Corners>
CRUMPLE_INLINE void scatter_group(domain::NodeForce* sums, const Index* target,
                                  const GroupForces<RealOf<Pack>, Corners>& group) {
  using Item = ItemsOf<RealOf<Pack>, 4>;
  for (int k = 0; k < Corners; ++k)
    for (int element = 0; element < lanes; ++element) {
      double* const sum = sums[target[k * lanes + element]].force;
      const auto force = math::read<Item>(group.of[k] + place_in_group<width_of<Pack>>(element));
      math::write(sum, math::read<math::Double4>(sum) - math::to_double(force));
    }
}

}  // namespace crumple::elements
