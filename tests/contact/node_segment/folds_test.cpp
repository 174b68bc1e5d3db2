// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "contact/bodies.hpp"
#include "contact/intersections.hpp"
#include "support/largest.hpp"

namespace crumple::folds_test {
namespace {

using test::at;
using test::Bodies;
using test::Vec3;

/// A strip of unit elements, its right part turned up about x = 4 by `angle`.
Vec3 folded(double s, double y, double angle) {
  return s <= 4 ? Vec3{s, y, 0} : Vec3{4 + (s - 4) * std::cos(angle), y, (s - 4) * std::sin(angle)};
}

std::vector<Vec3> fold_positions(const domain::Domain& made, Index first, double angle) {
  std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 2; ++j) x[at(made, first + 3 * i + j)] = folded(i, 0.9 * j, angle);
  return x;
}

struct Strip {
  Strip() : bodies(0.3) {
    first = bodies.sheet(8, 2, [](double u, double v) { return Vec3{8 * u, 1.8 * v, 0}; });
  }
  Bodies bodies;
  Index first = 0;
};

// Contact distance 0.3: while the strip folds, a node at the distance s from the fold touches the other half
// as soon as s sin(angle) < 0.3, also the first one next to the fold, and not before.
TEST(Folds, TightFoldIsNotMissed) {
  Strip strip;
  domain::Domain made = strip.bodies.build();
  contact::Interface touching = strip.bodies.attach(made);
  test::add_forces(touching, made);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  for (double degrees = 0; degrees < 177; degrees += 0.5) {
    const double angle = degrees / 180 * std::numbers::pi;
    test::move_to(touching, made, fold_positions(made, strip.first, angle), 1e-4);
    for (int i = 5; i <= 8; ++i) {
      const double distance = degrees > 90 ? (i - 4) * std::sin(angle) : 1e9;
      const Vec3 force = made.contact_force[at(made, strip.first + 3 * i + 1)];
      if (distance < 0.3 - 1e-9) {
        ASSERT_GT(norm(force), 0.0) << degrees << " degrees, node " << i;
      } else if (distance > 0.3 + 1e-9) {
        ASSERT_EQ(norm(force), 0.0) << degrees << " degrees, node " << i;
      }
      // The upper half is pushed up, away from the lower.
      if (distance < 0.25) {
        ASSERT_GT(force.z, 0.0);
      }
    }
  }
  EXPECT_TRUE(contact::intersecting_segments(touching.surface(), made.nodes.position, 1).empty());
}

// Pushed on through: the halves never change sides, however far they are driven.
TEST(Folds, ClosedFoldKeepsItsSides) {
  Strip strip;
  domain::Domain made = strip.bodies.build();
  contact::Interface touching = strip.bodies.attach(made);
  test::add_forces(touching, made);
  for (double degrees = 0; degrees <= 184; degrees += 0.25) {
    const double angle = degrees / 180 * std::numbers::pi;
    test::move_to(touching, made, fold_positions(made, strip.first, angle), 1e-4);
  }
  // Now the right half is below the left one, by 8 degrees at most times the distance from the fold.
  for (int i = 5; i <= 7; ++i)
    EXPECT_GT(made.contact_force[at(made, strip.first + 3 * i + 1)].z, 0.0) << "node " << i;
  EXPECT_GT(touching.statistics().nodes_astray, 0);
}

// In a fold of 150 degrees a foreign node touches both walls, and outside it only the one it is next to.
TEST(Folds, NodeInASharpFoldTouchesBothWalls) {
  const double angle = 150.0 / 180 * std::numbers::pi;
  const double half = 0.5 * (std::numbers::pi - angle);
  Strip strip;
  const Vec3 along{-std::cos(half), 0, std::sin(half)};  // bisector of the fold's inside, from (4, y, 0)
  const Vec3 deep = Vec3{4, 0.7, 0} + 0.8 * along;
  const Vec3 start = Vec3{4, 0.7, 0} + 3.0 * along;
  const Index tip = strip.bodies.node(start);
  const Index b = strip.bodies.node(start + 3.0 * along + Vec3{0, 0.5, 0});
  const Index c = strip.bodies.node(start + 3.0 * along - Vec3{0, 0.5, 0});
  strip.bodies.shell(tip, b, c, c);
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 2; ++j) {
      const Vec3 x = folded(i, 0.9 * j, angle);
      strip.bodies.model.nodes.position[strip.first + 3 * i + j] = {x.x, x.y, x.z};
    }
  domain::Domain made = strip.bodies.build();
  contact::Interface touching = strip.bodies.attach(made);
  test::add_forces(touching, made);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  for (int i = 1; i <= 50; ++i) {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    const Vec3 shift = start + i / 50.0 * (deep - start) - x[at(made, tip)];
    for (Index n = tip; n < tip + 3; ++n) x[at(made, n)] += shift;
    test::move_to(touching, made, x, 1e-4);
  }
  const Vec3 force = made.contact_force[at(made, tip)];
  // Two equal forces along the walls' normals: their sum is along the bisector, out of the fold.
  const double depth = 0.3 - 0.8 * std::sin(half);
  ASSERT_GT(depth, 0.05);
  EXPECT_GT(dot(force, along), 0.0);
  test::verified("node in a fold: force off the bisector over the force", "two equal forces")
      .below(norm(force - dot(force, along) * along) / norm(force), 1e-12);
  int pairs_of_tip = 0;
  for (const contact::Penetration& pair : touching.penetrations())
    if (pair.node == strip.bodies.model.nodes.id[tip]) {
      ++pairs_of_tip;
      EXPECT_NEAR(pair.depth, depth, 1e-12);
    }
  EXPECT_EQ(pairs_of_tip, 2);
}

// Three sheets meet at one edge. Above the through plate a node crosses from one half to the other without a
// jump; in the corner beside the stem it touches both.
TEST(Folds, TJunction) {
  Bodies bodies(0.1);
  const Index first = bodies.sheet(4, 2, [](double u, double v) { return Vec3{4 * u - 2, 2 * v, 0}; });
  const Index foot0 = bodies.node({0, 0, -1});
  const Index foot1 = bodies.node({0, 1, -1});
  const Index foot2 = bodies.node({0, 2, -1});
  bodies.shell(first + 6, first + 7, foot1, foot0);
  bodies.shell(first + 7, first + 8, foot2, foot1);
  const Index tip = bodies.node({-0.8, 0.6, 0.3});
  const Index b = bodies.node({-0.8, 0.9, 0.9});
  const Index c = bodies.node({-0.8, 0.3, 0.9});
  bodies.shell(tip, b, c, c);
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  const auto go = [&](const Vec3& to) {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    const Vec3 shift = to - x[at(made, tip)];
    for (Index n = tip; n < tip + 3; ++n) x[at(made, n)] += shift;
    test::move_to(touching, made, x, 1e-4);
    return made.contact_force[at(made, tip)];
  };
  go({-0.8, 0.6, 0.09});
  test::settle(touching, made);
  const double size = made.contact_force[at(made, tip)].z;
  EXPECT_GT(size, 0.0);
  test::Largest off("node slides over the edge where three sheets meet: force, relative change", "flat plate",
                    1e-11);
  for (double s = -0.8; s < 0.8; s += 0.01) {
    const Vec3 force = go({s, 0.6, 0.09});
    off.compare(force.z, size, size, std::to_string(s));
    off.compare(force.x, 0.0, size, std::to_string(s));
  }
  // Round the outer edge of the plate into the corner below.
  go({3, 0.6, 0.5});
  go({3, 0.6, -0.5});
  go({0.5, 0.6, -0.5});
  go({0.09, 0.6, -0.2});
  const Vec3 corner = go({0.09, 0.6, -0.09});
  EXPECT_GT(corner.x, 0.0);
  EXPECT_LT(corner.z, 0.0);
}

// A contact thickness of twice the element size: no node of a flat or gently bent sheet may feel its
// neighbours, at the start or while the sheet moves, but a strange node must feel the sheet.
TEST(Folds, ThicknessOfNeighboursIsIgnored) {
  Bodies bodies(0.1);
  bodies.contact.side[0].contact_thickness = 0.5;
  bodies.sheet(16, 8, [](double u, double v) { return Vec3{4 * u, 2 * v, 0.2 * std::sin(4 * u)}; });
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  EXPECT_EQ(touching.statistics().initial_penetrations, 0);
  for (int i = 1; i <= 40; ++i) {
    std::vector<Vec3> x;
    for (const Vec3& r : made.nodes.reference)
      x.push_back({r.x, r.y, r.z + 0.01 * i * std::sin(2 * r.x + r.y)});
    test::move_to(touching, made, x, 1e-4);
    ASSERT_EQ(made.contacts[0].active_pairs, 0) << "step " << i;
  }
}

}  // namespace
}  // namespace crumple::folds_test
