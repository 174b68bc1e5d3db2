// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/rigid_motion.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::constraints {

using domain::RigidBody;
using math::Matrix3;
using math::Quaternion;
using math::Vec3;

namespace {

Vec3 by_axis(const Vec3& a, const Vec3& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// About an axis on which all of a body's nodes lie there is neither inertia nor rotation.
Vec3 inverse_inertia(const RigidBody& body) {
  Vec3 inverse;
  for (int axis = 0; axis < 3; ++axis)
    inverse[axis] = body.principal_inertia[axis] > 0 ? 1 / body.principal_inertia[axis] : 0.0;
  return inverse;
}

bool any(const std::array<bool, 3>& axes) {
  return axes[0] || axes[1] || axes[2];
}

/// The tensor of inertia in the axes that are held.
Matrix3 held_inertia(const RigidBody& body, const Quaternion& turn) {
  const Matrix3 tensor = inertia_tensor(body, turn);
  Matrix3 turned;
  for (std::size_t axis = 0; axis < 3; ++axis)
    turned.column[axis] = math::transposed_product(body.held_axes, tensor * body.held_axes.column[axis]);
  return turned;
}

/// Angular velocity for the momentum where some axes are held at the angular velocity `held`; all components
/// are along the axes that are held.
Vec3 held_components(const RigidBody& body, const Matrix3& inertia, const Vec3& momentum, const Vec3& held) {
  Vec3 driven;
  for (int axis = 0; axis < 3; ++axis)
    if (body.held_rotation[static_cast<std::size_t>(axis)]) driven[axis] = held[axis];
  Vec3 right = momentum - inertia * driven;
  Matrix3 matrix = inertia;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_held = body.held_rotation[static_cast<std::size_t>(axis)];
    if (!is_held && matrix.column[static_cast<std::size_t>(axis)][axis] > 0) continue;
    for (int other = 0; other < 3; ++other) {
      matrix.column[static_cast<std::size_t>(axis)][other] = 0;
      matrix.column[static_cast<std::size_t>(other)][axis] = 0;
    }
    matrix.column[static_cast<std::size_t>(axis)][axis] = 1;
    right[axis] = is_held ? held[axis] : 0.0;
  }
  return math::solve(matrix, right);
}

/// The same in global axes, the momentum too.
Vec3 held_spin(const RigidBody& body, const Quaternion& turn, const Vec3& momentum, const Vec3& held) {
  return body.held_axes * held_components(body, held_inertia(body, turn),
                                          math::transposed_product(body.held_axes, momentum), held);
}

/// What is left of a change of the centre's velocity where some axes are held.
Vec3 free_change(const RigidBody& body, const Vec3& change) {
  if (!any(body.held_translation)) return change;
  Vec3 components = math::transposed_product(body.held_axes, change);
  for (int axis = 0; axis < 3; ++axis)
    if (body.held_translation[static_cast<std::size_t>(axis)]) components[axis] = 0;
  return body.held_axes * components;
}

/// Mean momentum of the step in the body's axes: mu = m + step/2 mu x (inverse mu), by Newton's method.
Vec3 mean_momentum(const Vec3& momentum, const Vec3& inverse, double step) {
  constexpr int most_iterations = 12;
  const double tolerance = 4e-16 * norm(momentum);
  Vec3 mean = momentum;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Vec3 spin = by_axis(inverse, mean);
    const Vec3 residual = mean - momentum - 0.5 * step * cross(mean, spin);
    if (norm(residual) <= tolerance) break;
    Matrix3 slope;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 unit;
      unit[axis] = 1;
      slope.column[static_cast<std::size_t>(axis)] =
          unit - 0.5 * step * (cross(unit, spin) + cross(mean, by_axis(inverse, unit)));
    }
    mean -= math::solve(slope, residual);
  }
  return mean;
}

/// tan(a) / a for the half angle of a step, by its series: held bodies turn by exactly step times velocity.
double tangent_factor(double angle) {
  const double q = angle * angle;
  return 1 + q * (1.0 / 3 + q * (2.0 / 15 + q * (17.0 / 315 + q * (62.0 / 2835 + q * (1382.0 / 155925)))));
}

/// The angular velocity in the middle of the step of a body that is held about some axes.
Vec3 held_mean_spin(const RigidBody& body, double step) {
  const auto free_axes = std::count(body.held_rotation.begin(), body.held_rotation.end(), false);
  if (free_axes < 2) return body.spin;
  constexpr int iterations = 8;
  Vec3 spin = body.spin;
  for (int i = 0; i < iterations; ++i)
    spin = spin_of(body, math::cayley_rotation(0.25 * step * spin) * body.turn, body.angular_momentum);
  return spin;
}

}  // namespace

Matrix3 inertia_tensor(const RigidBody& body, const Quaternion& turn) {
  const Matrix3 axes = math::matrix_of(turn);
  Matrix3 tensor;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 unit;
    unit[axis] = 1;
    tensor.column[static_cast<std::size_t>(axis)] =
        axes * by_axis(body.principal_inertia, math::transposed_product(axes, unit));
  }
  return tensor;
}

Vec3 spin_of(const RigidBody& body, const Quaternion& turn, const Vec3& momentum) {
  if (any(body.held_rotation)) return held_spin(body, turn, momentum, body.prescribed_spin);
  const Matrix3 axes = math::matrix_of(turn);
  return axes * by_axis(inverse_inertia(body), math::transposed_product(axes, momentum));
}

Vec3 velocity_at(const RigidBody& body, const Vec3& arm) {
  return body.velocity + cross(body.spin, arm);
}

Vec3 response_at(const RigidBody& body, const Vec3& arm, const Vec3& direction) {
  const Vec3 moment = cross(arm, direction);
  Vec3 spin;
  if (any(body.held_rotation)) {
    spin = held_spin(body, body.turn, moment, Vec3{});
  } else {
    const Matrix3 axes = math::matrix_of(body.turn);
    spin = axes * by_axis(inverse_inertia(body), math::transposed_product(axes, moment));
  }
  return cross(spin, arm) + free_change(body, (1 / body.mass) * direction);
}

void give_impulse(RigidBody& body, const Vec3& arm, const Vec3& impulse) {
  body.impulse += impulse;
  body.angular_impulse += cross(arm, impulse);
  body.velocity += free_change(body, (1 / body.mass) * impulse);
  body.angular_momentum += cross(arm, impulse);
  body.spin = spin_of(body, body.turn, body.angular_momentum);
}

void hold_translation(RigidBody& body, int axis, double velocity) {
  body.held_translation[static_cast<std::size_t>(axis)] = true;
  body.prescribed_velocity[axis] = velocity;
  Vec3 components = math::transposed_product(body.held_axes, body.velocity);
  components[axis] = velocity;
  body.velocity = body.held_axes * components;
}

void hold_rotation(RigidBody& body, int axis, double spin) {
  body.held_rotation[static_cast<std::size_t>(axis)] = true;
  body.prescribed_spin[axis] = spin;
  body.spin = spin_of(body, body.turn, body.angular_momentum);
}

void turn_over_step(RigidBody& body, double step) {
  Vec3 half;
  if (any(body.held_rotation)) {
    const Vec3 spin = held_mean_spin(body, step);
    half = 0.5 * step * tangent_factor(0.5 * step * norm(spin)) * spin;
  } else {
    const Matrix3 axes = math::matrix_of(body.turn);
    const Vec3 inverse = inverse_inertia(body);
    const Vec3 mean = mean_momentum(math::transposed_product(axes, body.angular_momentum), inverse, step);
    half = 0.5 * step * (axes * by_axis(inverse, mean));
  }
  body.next_turn = math::unit_quaternion(math::cayley_rotation(half) * body.turn);
  body.angular_velocity = (2 / step) * half;
}

}  // namespace crumple::constraints
