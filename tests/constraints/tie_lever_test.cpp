// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/tie_lever.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace crumple::tie_lever_test {
namespace {

using math::Vec3;

/// Numbers with no order in them.
double scattered(int seed) {
  return std::sin(37.0 * seed + 11);
}

/// A large step: the velocity must take the end of the lever to where it belongs.
TEST(TieLever, VelocityTakesItsEndToItsPlace) {
  std::array<Vec3, 4> corner{Vec3{0, 0, 0}, Vec3{4, 0.3, 0.1}, Vec3{4.2, 3.8, -0.2}, Vec3{0.1, 4, 0.2}};
  std::array<Vec3, 4> velocity;
  for (int k = 0; k < 4; ++k) velocity[k] = {scattered(3 * k), scattered(3 * k + 1), scattered(3 * k + 2)};
  const constraints::TieLever before(corner, 0.7);
  const double step = 0.8;
  const Vec3 moved = before.height * before.normal + step * before.velocity(velocity, step);
  for (int k = 0; k < 4; ++k) corner[k] += step * velocity[k];
  const constraints::TieLever after(corner, 0.7);
  EXPECT_GT(norm(after.normal - before.normal), 0.1);
  EXPECT_LT(norm(moved - after.height * after.normal), 1e-14);
}

/// Power of the couple on the corners is that of the force at the lever's end; it has no resultant and the
/// moment of the force about the foot.
TEST(TieLever, CoupleHasTheMomentAndThePowerOfTheForce) {
  const std::array<Vec3, 4> corner{Vec3{0, 0, 0}, Vec3{4, 0.3, 0.1}, Vec3{4.2, 3.8, -0.2}, Vec3{0.1, 4, 0.2}};
  const constraints::TieLever lever(corner, -0.7);
  const Vec3 force{0.3, -0.8, 0.5};
  const std::array<Vec3, 4> couple = lever.couple(force);
  std::array<Vec3, 4> velocity;
  Vec3 sum;
  Vec3 moment;
  double power = 0;
  for (int k = 0; k < 4; ++k) {
    velocity[k] = {scattered(3 * k), scattered(3 * k + 1), scattered(3 * k + 2)};
    sum += couple[k];
    moment += cross(corner[k], couple[k]);
    power += dot(couple[k], velocity[k]);
  }
  EXPECT_LT(norm(sum), 1e-15);
  EXPECT_LT(norm(moment - cross(lever.height * lever.normal, force)), 1e-14);
  EXPECT_NEAR(power, dot(force, lever.velocity(velocity, 0)), 1e-15);
}

/// The spin is that of a rigid rotation, and the couple has the moment and the power at any motion.
TEST(TieLever, TurnsWithItsSegment) {
  const std::array<Vec3, 4> corner{Vec3{0, 0, 0}, Vec3{4, 0.3, 0.1}, Vec3{4.2, 3.8, -0.2}, Vec3{0.1, 4, 0.2}};
  const constraints::TieLever lever(corner, 0);
  const Vec3 spin{0.4, -0.7, 1.1};
  const Vec3 moment{0.3, 0.9, -0.6};
  const std::array<Vec3, 4> couple = lever.couple_of_moment(moment);
  std::array<Vec3, 4> turning;
  std::array<Vec3, 4> any;
  Vec3 sum;
  Vec3 of_couple;
  double power = 0;
  for (int k = 0; k < 4; ++k) {
    turning[k] = cross(spin, corner[k]);
    any[k] = {scattered(3 * k), scattered(3 * k + 1), scattered(3 * k + 2)};
    sum += couple[k];
    of_couple += cross(corner[k], couple[k]);
    power += dot(couple[k], any[k]);
  }
  EXPECT_LT(norm(lever.spin(turning, 0) - spin), 1e-14);
  EXPECT_LT(norm(sum), 1e-15);
  EXPECT_LT(norm(of_couple - moment), 1e-14);
  EXPECT_NEAR(power, dot(moment, lever.spin(any, 0)), 1e-15);
}

}  // namespace
}  // namespace crumple::tie_lever_test
