// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/aligned_array.hpp"
#include "domain/node_fields.hpp"
#include "math/pack_vec3.hpp"
#include "math/small_vectors.hpp"

namespace crumple::elements {

/// Internal forces and moments at the four nodes, global axes.
template <class Pack>
struct ShellForces {
  math::PackVec3<Pack> force[4];
  math::PackVec3<Pack> moment[4];
};

/// Forces and moments at one node of each of four elements: the rows fx, fy, fz, mx, my, mz turned into one
/// item per element.
template <int Width>
CRUMPLE_INLINE math::Four<math::Float8> items_of(const float (*rows)[Width], int lane) {
  using math::Float4;
  const auto both = [&](int row) {
    return math::joined(math::read<Float4>(&rows[row][lane]), math::read<Float4>(&rows[row + 3][lane]));
  };
  return math::transposed(both(0), both(1), both(2), math::Float8{});
}

struct DoubleItems {
  math::Four<math::Double4> force, moment;
};
template <int Width>
CRUMPLE_INLINE DoubleItems items_of(const double (*rows)[Width], int lane) {
  using math::Double4;
  const auto columns = [&](int row) {
    return math::transposed(math::read<Double4>(&rows[row][lane]), math::read<Double4>(&rows[row + 1][lane]),
                            math::read<Double4>(&rows[row + 2][lane]), Double4{});
  };
  return {columns(0), columns(3)};
}

CRUMPLE_INLINE void subtract_item(domain::NodeForce& sum, const math::Four<math::Float8>& items, int i) {
  math::subtract_from(sum.force, items.row[i]);
}
CRUMPLE_INLINE void subtract_item(domain::NodeForce& sum, const DoubleItems& items, int i) {
  math::write(sum.force, math::read<math::Double4>(sum.force) - items.force.row[i]);
  math::write(sum.moment, math::read<math::Double4>(sum.moment) - items.moment.row[i]);
}

/// Subtracts internal forces from the sums at the nodes, in double, element after element and in each node
/// after node, so that the order of the sum does not depend on the width of the pack. `target` is [4][lanes]
/// from the first element.
template <class Pack>
CRUMPLE_INLINE void scatter(domain::NodeForce* sums, const Index* target, const ShellForces<Pack>& internal) {
  using Real = RealOf<Pack>;
  constexpr int width = width_of<Pack>;
  alignas(cache_line) Real rows[4][6][width];
  for (int k = 0; k < 4; ++k) {
    store(rows[k][0], internal.force[k].x);
    store(rows[k][1], internal.force[k].y);
    store(rows[k][2], internal.force[k].z);
    store(rows[k][3], internal.moment[k].x);
    store(rows[k][4], internal.moment[k].y);
    store(rows[k][5], internal.moment[k].z);
  }
  if constexpr (width >= 4) {
    for (int lane = 0; lane < width; lane += 4) {
      const decltype(items_of<width>(rows[0], lane)) items[4] = {
          items_of<width>(rows[0], lane), items_of<width>(rows[1], lane), items_of<width>(rows[2], lane),
          items_of<width>(rows[3], lane)};
      for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) subtract_item(sums[target[k * lanes + lane + i]], items[k], i);
    }
  } else {
    for (int lane = 0; lane < width; ++lane)
      for (int k = 0; k < 4; ++k) {
        domain::NodeForce& sum = sums[target[k * lanes + lane]];
        for (int axis = 0; axis < 3; ++axis) {
          sum.force[axis] -= static_cast<double>(rows[k][axis][lane]);
          sum.moment[axis] -= static_cast<double>(rows[k][3 + axis][lane]);
        }
      }
  }
}

}  // namespace crumple::elements
