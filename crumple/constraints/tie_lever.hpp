// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A node that follows a segment at a height over it stands on a lever, the segment's normal:
//
//     x = sum of w_k x_k + h n,    n = N/|N|,    N = d_1 x d_2,    d_1 = x_3 - x_1,  d_2 = x_4 - x_2.
//
// What follows of it is exact for finite steps: the velocity takes the node to the end of its lever, however
// far the segment turns, and force and moment of force arrive at the corners whole (own derivation,
// docs/theory/tied.md).

#include <array>
#include <cmath>

#include "math/vec3.hpp"

namespace crumple::constraints {

/// The normal of a segment, and how it turns.
struct TieLever {
  math::Vec3 first;   ///< d_1, a diagonal of the segment [length]
  math::Vec3 second;  ///< d_2 [length]
  math::Vec3 normal;  ///< n
  double size = 0;    ///< |N|, twice the area; 0: the segment has no normal [length^2]
  double height = 0;  ///< h, of either sign [length]

  TieLever(const std::array<math::Vec3, 4>& corner, double height_over)
      : first(corner[2] - corner[0]), second(corner[3] - corner[1]), height(height_over) {
    const math::Vec3 product = cross(first, second);
    size = norm(product);
    if (size > 0) normal = (1 / size) * product;
  }

  /// Mean velocity of the end of the lever against its foot in a step in which the corners have these
  /// velocities; with a step of zero the velocity now [length/time].
  math::Vec3 velocity(const std::array<math::Vec3, 4>& corner_velocity, double step) const {
    return height * normal_rate(corner_velocity, step);
  }

  /// What a force at the end of the lever puts on the corners beside its share by weights: forces that add up
  /// to zero and have the moment of h n x force.
  std::array<math::Vec3, 4> couple(const math::Vec3& force) const { return couple_of(height * force); }

  /// Angular velocity of the segment: that of its normal, and about it the mean of its diagonals [rad/time].
  math::Vec3 spin(const std::array<math::Vec3, 4>& corner_velocity, double step) const {
    if (!(size > 0)) return {};
    const auto about_normal = [&](const math::Vec3& diagonal, const math::Vec3& rate) {
      return 0.5 * dot(normal, cross(diagonal, rate)) / dot(diagonal, diagonal);
    };
    const double turning = about_normal(first, corner_velocity[2] - corner_velocity[0]) +
                           about_normal(second, corner_velocity[3] - corner_velocity[1]);
    return cross(normal, normal_rate(corner_velocity, step)) + turning * normal;
  }

  /// Forces on the corners with the resultant zero, this moment, and its power at spin().
  std::array<math::Vec3, 4> couple_of_moment(const math::Vec3& moment) const {
    if (!(size > 0)) return {};
    std::array<math::Vec3, 4> force = couple_of(cross(moment, normal));
    const auto turn = [&](const math::Vec3& diagonal, std::size_t from, std::size_t to) {
      const math::Vec3 push = (0.5 * dot(moment, normal) / dot(diagonal, diagonal)) * cross(normal, diagonal);
      force[to] += push;
      force[from] -= push;
    };
    turn(first, 0, 2);
    turn(second, 1, 3);
    return force;
  }

 private:
  /// dn/dt, as velocity() has it [1/time].
  math::Vec3 normal_rate(const std::array<math::Vec3, 4>& corner_velocity, double step) const {
    if (!(size > 0)) return {};
    const math::Vec3 of_first = corner_velocity[2] - corner_velocity[0];
    const math::Vec3 of_second = corner_velocity[3] - corner_velocity[1];
    // Of N, and of its length, without the difference of two nearly equal numbers.
    const math::Vec3 rate =
        cross(first, of_second) + cross(of_first, second) + step * cross(of_first, of_second);
    const math::Vec3 before = size * normal;
    const double after = norm(before + step * rate);
    if (!(after > 0)) return {};
    const double growth = (2 * dot(before, rate) + step * dot(rate, rate)) / (after + size);
    return (1 / after) * (rate - growth * normal);
  }

  /// Forces on the corners whose power is that of `pull` at dn/dt.
  std::array<math::Vec3, 4> couple_of(const math::Vec3& pull) const {
    if (!(size > 0)) return {};
    const math::Vec3 arm = (1 / size) * (pull - dot(pull, normal) * normal);
    const math::Vec3 on_first = cross(second, arm);
    const math::Vec3 on_second = cross(arm, first);
    return {-1 * on_first, -1 * on_second, on_first, on_second};
  }
};

}  // namespace crumple::constraints
