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

template <class Real>
struct SmallVector;
template <>
struct SmallVector<float> {
  using type = math::Float4;
};
template <>
struct SmallVector<double> {
  using type = math::Double4;
};

template <class Vector>
CRUMPLE_INLINE math::Double4 to_double(const Vector& v) {
  return __builtin_convertvector(v, math::Double4);
}

/// Forces (or moments) of four elements at one node each, as vectors; rows are x, y, z.
template <class Real, int Width>
CRUMPLE_INLINE auto columns_of(const Real (*rows)[Width], int lane) {
  using Vector = typename SmallVector<Real>::type;
  return math::transposed(math::read<Vector>(&rows[0][lane]), math::read<Vector>(&rows[1][lane]),
                          math::read<Vector>(&rows[2][lane]), Vector{});
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
      using Vector = typename SmallVector<Real>::type;
      math::Four<Vector> force[4];
      math::Four<Vector> moment[4];
      for (int k = 0; k < 4; ++k) {
        force[k] = columns_of<Real, width>(rows[k], lane);
        moment[k] = columns_of<Real, width>(rows[k] + 3, lane);
      }
      for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) {
          domain::NodeForce& sum = sums[target[k * lanes + lane + i]];
          math::write(sum.force, math::read<math::Double4>(sum.force) - to_double(force[k].row[i]));
          math::write(sum.moment, math::read<math::Double4>(sum.moment) - to_double(moment[k].row[i]));
        }
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
