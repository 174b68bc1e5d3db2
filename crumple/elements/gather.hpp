// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/aligned_array.hpp"
#include "domain/node_fields.hpp"
#include "math/pack_vec3.hpp"

namespace crumple::elements {

/// What a four-node shell needs of its nodes. All of it is differences, taken in double for the positions, so
/// that float keeps its digits however far the element is from the origin. 31 is node 3 less node 1; "mode"
/// is the hourglass pattern, node 1 - 2 + 3 - 4; "sum" adds all four.
template <class Pack>
struct ShellNodes {
  using Vec = math::PackVec3<Pack>;
  Vec r31, r42, r_mode;         ///< positions at time n
  Vec v31, v42, v_mode;         ///< velocities at n - 1/2
  Vec w31, w42, w_mode, w_sum;  ///< angular velocities at n - 1/2
};

/// Reads the nodes of width_of<Pack> elements; `node` is [4][lanes] from the first of them.
template <class Pack>
CRUMPLE_INLINE ShellNodes<Pack> gather(const domain::NodeRecord<RealOf<Pack>>* nodes, const Index* node) {
  using Real = RealOf<Pack>;
  constexpr int width = width_of<Pack>;
  alignas(cache_line) Real rows[30][width];
  for (int lane = 0; lane < width; ++lane) {
    const auto& n1 = nodes[node[lane]];
    const auto& n2 = nodes[node[lanes + lane]];
    const auto& n3 = nodes[node[2 * lanes + lane]];
    const auto& n4 = nodes[node[3 * lanes + lane]];
    for (int axis = 0; axis < 3; ++axis) {
      const double r31 = n3.position[axis] - n1.position[axis];
      const double r42 = n4.position[axis] - n2.position[axis];
      const double r21 = n2.position[axis] - n1.position[axis];
      rows[axis][lane] = static_cast<Real>(r31);
      rows[3 + axis][lane] = static_cast<Real>(r42);
      rows[6 + axis][lane] = static_cast<Real>((r31 - r42) - 2 * r21);
      const Real v31 = n3.velocity[axis] - n1.velocity[axis];
      const Real v42 = n4.velocity[axis] - n2.velocity[axis];
      const Real v21 = n2.velocity[axis] - n1.velocity[axis];
      rows[9 + axis][lane] = v31;
      rows[12 + axis][lane] = v42;
      rows[15 + axis][lane] = (v31 - v42) - (v21 + v21);
      const Real w13 = n1.angular_velocity[axis] + n3.angular_velocity[axis];
      const Real w24 = n2.angular_velocity[axis] + n4.angular_velocity[axis];
      rows[18 + axis][lane] = n3.angular_velocity[axis] - n1.angular_velocity[axis];
      rows[21 + axis][lane] = n4.angular_velocity[axis] - n2.angular_velocity[axis];
      rows[24 + axis][lane] = w13 - w24;
      rows[27 + axis][lane] = w13 + w24;
    }
  }
  const auto vec = [&](int row) {
    return math::PackVec3<Pack>{load<Pack>(rows[row]), load<Pack>(rows[row + 1]), load<Pack>(rows[row + 2])};
  };
  return {vec(0), vec(3), vec(6), vec(9), vec(12), vec(15), vec(18), vec(21), vec(24), vec(27)};
}

/// Internal forces and moments at the four nodes, global axes.
template <class Pack>
struct ShellForces {
  math::PackVec3<Pack> force[4];
  math::PackVec3<Pack> moment[4];
};

/// Subtracts internal forces from the sums at the nodes, in double, element after element, so that the order
/// of the sum does not depend on the width of the pack. `target` is [4][lanes] from the first element.
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
  for (int lane = 0; lane < width; ++lane)
    for (int k = 0; k < 4; ++k) {
      domain::NodeForce& sum = sums[target[k * lanes + lane]];
      for (int axis = 0; axis < 3; ++axis) {
        sum.force[axis] -= static_cast<double>(rows[k][axis][lane]);
        sum.moment[axis] -= static_cast<double>(rows[k][3 + axis][lane]);
      }
    }
}

}  // namespace crumple::elements
