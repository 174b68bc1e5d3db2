// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/body_share.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace crumple::constraints::body_share_test {
namespace {

/// Masses of 1 at the corners of a cube of side 2: M = 8, each principal moment 16.
class BodyShareTest : public ::testing::Test {
 protected:
  BodyShareTest() {
    domain_.nodes.mass.assign(8, 1.0);
    body_.mass = 8;
    body_.principal_inertia = {16, 16, 16};
    for (Index i = 0; i < 8; ++i) {
      body_.nodes.push_back(i);
      body_.arm.push_back({(i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0});
    }
  }
  double share() const { return share_of_masses(body_, domain_.nodes); }

  domain::Domain domain_;
  domain::RigidBody body_;
};

TEST_F(BodyShareTest, IsOneWhereTheInertiaIsThatOfTheNodes) {
  EXPECT_EQ(share(), 1);
  body_.principal_inertia = {100, 16, 20};
  EXPECT_EQ(share(), 1);
}

TEST_F(BodyShareTest, IsTheLeastRatioOfInertia) {
  body_.principal_inertia = {16, 0.16, 16};
  EXPECT_NEAR(share(), 0.01, 0.01 * 0.015);
  EXPECT_LE(share(), 0.01);
  body_.principal_inertia = {16, 16, 16};
  body_.mass = 4;
  EXPECT_NEAR(share(), 0.5, 0.5 * 0.03);
  EXPECT_LE(share(), 0.5);
}

/// With the centre off the nodes' own by d a turn moves it: of the matrix [1, x; x, 1 + d^2 M / I] with x =
/// d sqrt(M / I).
TEST_F(BodyShareTest, KnowsOfAnotherCentre) {
  const double d = 0.5;
  for (math::Vec3& arm : body_.arm) arm.x += d;
  const double square = d * d * 8 / 16;
  const double largest = 1 + 0.5 * square + std::sqrt(0.25 * square * square + square);
  EXPECT_NEAR(share(), 1 / largest, 0.02 / largest);
  EXPECT_LE(share(), 1 / largest);
}

}  // namespace
}  // namespace crumple::constraints::body_share_test
