// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "contact/bodies.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::sliding_test {
namespace {

using test::at;
using test::Bodies;
using test::Vec3;

/// A small triangle whose first node is the tip that slides; the rest of it stands off along `up`.
Index add_tip(Bodies& bodies, const Vec3& x, const Vec3& up) {
  const Vec3 side = std::fabs(up.y) < 0.5 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  const Index tip = bodies.node(x);
  const Index b = bodies.node(x + up + 0.3 * side);
  const Index c = bodies.node(x + up - 0.3 * side);
  bodies.shell(tip, b, c, c);
  return tip;
}

/// Forces on the tip along a path: the other two nodes of the triangle keep their distance from it.
std::vector<Vec3> forces_along(const Bodies& bodies, Index tip, int steps,
                               const std::function<Vec3(double)>& path) {
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  std::vector<Vec3> forces;
  for (int i = 0; i <= steps; ++i) {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    const Vec3 shift = path(static_cast<double>(i) / steps) - x[at(made, tip)];
    for (Index n = tip; n < tip + 3; ++n) x[at(made, n)] += shift;
    test::move_to(touching, made, x, 1e-4);
    forces.push_back(made.contact_force[at(made, tip)]);
  }
  return forces;
}

double largest_jump(const std::vector<Vec3>& forces, std::size_t from = 0) {
  double jump = 0;
  for (std::size_t i = from + 1; i < forces.size(); ++i)
    jump = test::larger_of(jump, norm(forces[i] - forces[i - 1]));
  return jump;
}

constexpr double thickness = 0.05;
constexpr double gap = 0.04;

/// Two faces of four elements that meet in a ridge along y at the origin; x runs across. The second face is
/// turned down by `angle` (convex seen from above) or up (negative).
Bodies ridge(double angle) {
  Bodies bodies(thickness);
  bodies.sheet(4, 2, [&](double u, double v) {
    const double s = 2 * (u - 0.5) * 1.0;
    return s <= 0 ? Vec3{s, v, 0} : Vec3{s * std::cos(angle), v, -s * std::sin(angle)};
  });
  return bodies;
}

TEST(Sliding, FlatSheetGivesAConstantForce) {
  Bodies bodies = ridge(0);
  const Index tip = add_tip(bodies, {-0.7, 0.27, 2 * thickness}, {0, 0, 0.5});
  const auto forces = forces_along(bodies, tip, 800, [](double t) {
    return t < 0.1 ? Vec3{-0.7, 0.27, thickness + (0.1 - t) / 0.1 * 0.04 - (thickness - gap)}
                   : Vec3{-0.7 + 1.4 * (t - 0.1) / 0.9, 0.27, gap};
  });
  const std::string tip_slides = "tip slides over a flat sheet: ";
  test::Largest normal(tip_slides + "normal force, change", "constant", 1e-12);
  test::Largest across(tip_slides + "tangential force", "none", 1e-12);
  for (std::size_t i = 81; i < forces.size(); ++i) {
    normal.compare(forces[i].z, forces[81].z);
    across.add(std::fabs(forces[i].x));
  }
  EXPECT_GT(forces[81].z, 0.1);
}

TEST(Sliding, ConvexRidgeTurnsTheForceWithoutAJump) {
  const std::string ridges = "tip slides over ridges of 17 to 150 degrees: ";
  test::Largest sizes(ridges + "size of the force, relative change", "constant distance", 1e-11);
  test::Largest jumps(ridges + "largest turn of the force in a step over that of the way, off 1", "no jump",
                      1e-4);
  for (const double angle : {0.3, 1.0, 2.0, 150.0 / 180 * std::numbers::pi}) {
    Bodies bodies = ridge(angle);
    const Index tip = add_tip(bodies, {-0.4, 0.27, 2 * thickness}, {0, 0, 0.5});
    // Down onto the first face, along it, round the ridge on an arc, and along the second face.
    const int steps = 3000;
    const auto forces = forces_along(bodies, tip, steps, [&](double t) {
      if (t < 0.1) return Vec3{-0.4, 0.27, gap + (0.1 - t) * 0.2};
      if (t < 0.5) return Vec3{-(0.5 - t), 0.27, gap};
      if (t < 0.7) {
        const double a = angle * (t - 0.5) / 0.2;
        return Vec3{gap * std::sin(a), 0.27, gap * std::cos(a)};
      }
      const double s = t - 0.7;
      return Vec3{s * std::cos(angle) + gap * std::sin(angle), 0.27,
                  -s * std::sin(angle) + gap * std::cos(angle)};
    });
    const std::size_t first = static_cast<std::size_t>(0.1 * steps) + 1;
    const double size = norm(forces[first]);
    EXPECT_GT(size, 0.1);
    for (std::size_t i = first; i < forces.size(); ++i)
      sizes.compare(norm(forces[i]), size, size,
                    "angle " + std::to_string(angle) + " step " + std::to_string(i));
    // The direction turns by no more than the arc of one step.
    jumps.compare(largest_jump(forces, first) / (size * angle / (0.2 * steps)), 1);
  }
}

TEST(Sliding, ShallowConcaveRidgeKeepsTheSizeOfTheForce) {
  const double angle = 20.0 / 180 * std::numbers::pi;
  Bodies bodies = ridge(-angle);
  const Index tip = add_tip(bodies, {-0.4, 0.27, 2 * thickness}, {0, 0, 0.5});
  const auto forces = forces_along(bodies, tip, 2000, [&](double t) {
    if (t < 0.1) return Vec3{-0.4, 0.27, gap + (0.1 - t) * 0.2};
    // At the distance `gap` from the nearer face all the way, through the bisector.
    const double x = -0.4 + (t - 0.1) * 0.8;
    return Vec3{x, 0.27, std::max(gap, x * std::tan(angle) + gap / std::cos(angle))};
  });
  const double size = norm(forces[201]);
  EXPECT_GT(size, 0.1);
  int turns = 0;
  test::Largest sizes("tip slides through a hollow of 20 degrees: size of the force, relative change",
                      "constant distance", 1e-11);
  for (std::size_t i = 202; i < forces.size(); ++i) {
    sizes.compare(norm(forces[i]), size, size);
    if (norm(forces[i] - forces[i - 1]) > 1e-9) ++turns;
  }
  EXPECT_EQ(turns, 1);
  test::verified("tip slides through a hollow of 20 degrees: jump over the force", "2 sin(angle / 2)")
      .near(largest_jump(forces, 201) / size, 2 * std::sin(0.5 * angle), 1e-9);
}

// Two walls at a right angle push apart from each other: the second force grows from nothing.
TEST(Sliding, CornerOfTwoWallsPushesBothWays) {
  Bodies bodies = ridge(-0.5 * std::numbers::pi);
  const Index tip = add_tip(bodies, {-0.4, 0.27, 2 * thickness}, {-0.4, 0, 0.5});
  const int steps = 2000;
  const auto forces = forces_along(bodies, tip, steps, [&](double t) {
    return t < 0.1 ? Vec3{-0.4, 0.27, gap + (0.1 - t) * 0.2} : Vec3{-0.4 + (t - 0.1) * 0.4, 0.27, gap};
  });
  const Vec3 end = forces.back();
  test::verified("tip in a corner of two walls: force across over the one down", "equal")
      .near(end.x / end.z, -1, 1e-12);
  EXPECT_NEAR(end.z, forces[201].z, 1e-12);
  const double stiffness = end.z / (thickness - gap);
  EXPECT_LT(largest_jump(forces, 201), 1.01 * stiffness * 0.4 / steps);
}

TEST(Sliding, FreeEdgeIsRound) {
  Bodies bodies(thickness);
  bodies.sheet(2, 2, [](double u, double v) { return Vec3{u - 1, v, 0}; });
  const Index tip = add_tip(bodies, {-0.3, 0.27, 2 * thickness}, {0, 0, 0.5});
  const auto forces = forces_along(bodies, tip, 2000, [&](double t) {
    if (t < 0.1) return Vec3{-0.3, 0.27, gap + (0.1 - t) * 0.2};
    if (t < 0.4) return Vec3{-(0.4 - t), 0.27, gap};
    const double a = (t - 0.4) / 0.6 * 0.6 * std::numbers::pi;  // past the middle of the rim
    return Vec3{gap * std::sin(a), 0.27, gap * std::cos(a)};
  });
  const double size = norm(forces[201]);
  EXPECT_GT(size, 0.1);
  test::Largest sizes("tip slides round a free edge: size of the force, relative change", "constant distance",
                      1e-11);
  for (std::size_t i = 201; i < forces.size(); ++i) sizes.compare(norm(forces[i]), size, size);
  const double last = 0.6 * std::numbers::pi;
  const std::string round = "tip slides round a free edge by 108 degrees: ";
  test::verified(round + "force along the sheet", "sine").near(forces.back().x / size, std::sin(last), 1e-9);
  test::verified(round + "force across the sheet", "cosine")
      .near(forces.back().z / size, std::cos(last), 1e-9);
}

// Going round a free edge to the other side is no crossing: the node is pushed off the side it has come to.
TEST(Sliding, RoundAFreeEdgeToTheOtherSide) {
  Bodies bodies(thickness);
  bodies.sheet(2, 2, [](double u, double v) { return Vec3{u - 1, v, 0}; });
  const Index tip = add_tip(bodies, {-0.3, 0.27, 2 * thickness}, {1.0, 0, 0});
  const auto forces = forces_along(bodies, tip, 2000, [&](double t) {
    if (t < 0.1) return Vec3{-0.1, 0.27, gap + (0.1 - t) * 0.2};
    if (t < 0.2) return Vec3{-(0.2 - t), 0.27, gap};
    if (t < 0.8) {
      const double a = (t - 0.2) / 0.6 * std::numbers::pi;
      return Vec3{gap * std::sin(a), 0.27, gap * std::cos(a)};
    }
    return Vec3{-(t - 0.8), 0.27, -gap};
  });
  const double size = norm(forces[201]);
  test::Largest sizes("tip goes round a free edge to the other side: size of the force, relative change",
                      "constant distance", 1e-11);
  for (std::size_t i = 201; i < forces.size(); ++i) sizes.compare(norm(forces[i]), size, size);
  EXPECT_NEAR(forces.back().z, -size, 1e-9 * size);
}

}  // namespace
}  // namespace crumple::sliding_test
