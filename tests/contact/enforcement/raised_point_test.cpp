// SPDX-License-Identifier: BSD-3-Clause
// What a force does to the nodes of a segment from a height above it, against differences of where it acts.
#include "contact/enforcement/raised_point.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "contact/surface/segment_shape.hpp"
#include "support/largest.hpp"

namespace crumple::contact::raised_point_test {
namespace {

/// Unit normal of a quadrilateral or triangle.
Vec3 normal_of(const std::vector<Vec3>& corner) {
  return math::normalised(cross(corner[2] - corner[0], corner.back() - corner[1]));
}

class RaisedPoint : public ::testing::TestWithParam<int> {
 protected:
  Vec3 any() { return {number_(random_), number_(random_), number_(random_)}; }
  std::vector<Vec3> any_segment() {
    std::vector<Vec3> corner{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    corner.resize(static_cast<std::size_t>(GetParam()));
    for (Vec3& x : corner) x += 0.3 * any();
    return corner;
  }

  std::mt19937 random_{11};
  std::uniform_real_distribution<double> number_{-1, 1};
};

TEST_P(RaisedPoint, ForcesDoTheWorkOfTheTurningNormal) {
  constexpr double h = 1e-5;
  const std::string segment = "force above a segment of " + std::to_string(GetParam()) + " nodes: ";
  test::Largest work(segment + "forces on its nodes, error", "central differences", 1e-8);
  test::Largest sum(segment + "their sum", "conservation", 1e-14);
  test::Largest moment(segment + "their moment less that of the force", "conservation", 1e-14);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<Vec3> corner = any_segment();
    const Vec3 force = any();
    const double height = -0.4;
    const auto forces = turning_forces(corner, height, force);
    Vec3 total;
    Vec3 turning = -cross(height * normal_of(corner), force);
    for (std::size_t i = 0; i < corner.size(); ++i) {
      total += forces[i];
      turning += cross(corner[i], forces[i]);
      for (int axis = 0; axis < 3; ++axis) {
        std::vector<Vec3> ahead = corner;
        std::vector<Vec3> behind = corner;
        ahead[i][axis] += h;
        behind[i][axis] -= h;
        const double slope = height * dot(force, normal_of(ahead) - normal_of(behind)) / (2 * h);
        work.compare(forces[i][axis], slope);
      }
    }
    sum.add(norm(total));
    moment.add(norm(turning));
  }
}

TEST_P(RaisedPoint, NothingTurnsWhereThereIsNoArea) {
  const std::vector<Vec3> corner(static_cast<std::size_t>(GetParam()));
  for (const Vec3& force : turning_forces(corner, 1, {1, 2, 3})) EXPECT_EQ(norm(force), 0);
}

INSTANTIATE_TEST_SUITE_P(Nodes, RaisedPoint, ::testing::Values(3, 4));

}  // namespace
}  // namespace crumple::contact::raised_point_test
