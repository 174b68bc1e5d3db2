// SPDX-License-Identifier: BSD-3-Clause
#include "contact/pinball/pinballs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "base/error.hpp"
#include "contact/bodies.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"
#include "support/meshes.hpp"

namespace crumple::pinballs_test {
namespace {

using contact::PinballShape;
using model::LocalSearchKind;
using test::Bodies;
using test::Vec3;

class Random {
 public:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// A warped square of about that edge, somewhere in a cube of that size.
  PinballShape shape(double edge, double room, int level) {
    PinballShape made;
    const Vec3 u = edge * direction();
    const Vec3 v = edge * direction();
    const Vec3 at{between(0, room), between(0, room), between(0, room)};
    made.segment.corner = {at, at + u, at + u + v + 0.1 * edge * direction(), at + v};
    made.level = level;
    made.radius = 0.8 * edge / (1 << level);
    contact::measure_diagonal(made);
    return made;
  }
  Vec3 direction() { return math::normalised({between(-1, 1), between(-1, 1), between(-1, 1)}); }

 private:
  std::mt19937 engine_{7};
};

/// Centre of ball (row, column) of the lattice.
Vec3 centre(const PinballShape& shape, int row, int column) {
  const double u = (column + 0.5) / (1 << shape.level);
  const double v = (row + 0.5) / (1 << shape.level);
  const auto& x = shape.segment.corner;
  return (1 - u) * (1 - v) * x[0] + u * (1 - v) * x[1] + u * v * x[2] + (1 - u) * v * x[3] + shape.sunk;
}

double deepest_of_all(const PinballShape& a, const PinballShape& b) {
  double deepest = -1e30;
  for (int i = 0; i < 1 << a.level; ++i)
    for (int j = 0; j < 1 << a.level; ++j)
      for (int k = 0; k < 1 << b.level; ++k)
        for (int l = 0; l < 1 << b.level; ++l)
          deepest = test::larger_of(deepest, a.radius + b.radius - norm(centre(a, i, j) - centre(b, k, l)));
  return deepest;
}

// The tree leads to the same pair of balls as looking at all of them.
TEST(Pinballs, TheTreeFindsTheDeepestOverlap) {
  Random random;
  int touching = 0;
  test::Largest depths("pinballs, 400 pairs of segments: deepest overlap, error",
                       "brute force over all balls", 1e-12);
  for (int trial = 0; trial < 400; ++trial) {
    PinballShape a = random.shape(1, 1.5, trial % 4);
    const PinballShape b = random.shape(0.7, 1.5, trial % 3);
    if (trial % 5 == 0) a.sunk = 0.1 * random.direction();
    const double all = deepest_of_all(a, b);
    const auto within = contact::deepest_overlap(a, b, -0.3);
    ASSERT_EQ(within.has_value(), all > -0.3);
    if (within) depths.compare(within->depth, all);
    const auto found = contact::deepest_overlap(a, b);
    ASSERT_EQ(found.has_value(), all > 0);
    EXPECT_LE(contact::distance_at_least(a, b), std::max(0.0, -all) + 1e-12);
    if (!found) continue;
    ++touching;
    depths.compare(found->depth, all);
    Vec3 away = a.sunk - b.sunk;
    for (int k = 0; k < 4; ++k)
      away += found->first[k] * a.segment.corner[k] - found->second[k] * b.segment.corner[k];
    EXPECT_NEAR(norm(away - found->away), 0, 1e-12);
  }
  EXPECT_GT(touching, 100);
}

/// Two plates whose elements are not aligned, one turned by 17 degrees, that fly at each other.
Bodies two_plates() {
  Bodies bodies(0.2);
  bodies.model.search.local = LocalSearchKind::Pinballs;
  bodies.sheet(3, 2, [](double u, double v) { return Vec3{3 * u, 2 * v, 0}; });
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  bodies.sheet(2, 2, [&](double u, double v) {
    return Vec3{0.9 + 1.9 * c * u - 1.7 * s * v, 0.1 + 1.9 * s * u + 1.7 * c * v, 0.25};
  });
  return bodies;
}

void expect_conserved(const std::string& bodies, const test::Impact& found, double least_stored) {
  const char* const conserved = "conservation";
  test::verified(bodies + "momentum, largest change", conserved).below(found.momentum, 1e-12);
  test::verified(bodies + "moment of momentum, largest change", conserved).below(found.spin, 1e-11);
  test::verified(bodies + "imbalance over the kinetic energy at first", conserved)
      .below(found.imbalance / found.start.kinetic, 1e-12);
  EXPECT_GT(found.stored, least_stored * found.start.kinetic);
}

TEST(Pinballs, CollisionKeepsMomentumAndEnergy) {
  const Bodies bodies = two_plates();
  domain::Domain made = bodies.build();
  test::throw_together(made, 0.1, {0.02, 0.01, -0.4});
  contact::Interface touching = bodies.attach(made);
  touching.verify_search_every(50);
  test::add_forces(touching, made);
  const test::Impact found = test::impact(touching, made, 1e-3, 3000);
  expect_conserved("pinballs, two plates collide: ", found, 0.2);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  test::verified("pinballs, two plates collide: energy left in the contact over the kinetic one", "none")
      .below(std::fabs(made.contacts[0].energy) / found.start.kinetic, 1e-3);
}

TEST(Pinballs, TrianglesTouchQuadrilaterals) {
  Bodies bodies(0.2);
  bodies.model.search.local = LocalSearchKind::Pinballs;
  bodies.sheet(2, 2, [](double u, double v) { return Vec3{2 * u, 2 * v, 0}; });
  const Index first = bodies.model.nodes.count();
  for (const Vec3& x :
       {Vec3{0.4, 0.3, 0.25}, Vec3{1.7, 0.5, 0.25}, Vec3{1.4, 1.6, 0.25}, Vec3{0.2, 1.5, 0.25}})
    bodies.node(x);
  bodies.shell(first, first + 1, first + 2, first + 2);
  bodies.shell(first, first + 2, first + 3, first + 3);
  domain::Domain made = bodies.build();
  test::throw_together(made, 0.1, {0.02, 0.01, -0.3});
  contact::Interface touching = bodies.attach(made);
  touching.verify_search_every(50);
  test::add_forces(touching, made);
  const test::Impact found = test::impact(touching, made, 1e-3, 2000);
  expect_conserved("pinballs, triangles on quadrilaterals: ", found, 0.2);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  test::verified("pinballs, triangles on quadrilaterals: energy left in the contact over the kinetic one",
                 "none")
      .below(std::fabs(made.contacts[0].energy) / found.start.kinetic, 1e-4);
}

TEST(Pinballs, FrictionTakesEnergyOutAndSlowsBothAlike) {
  Bodies bodies = two_plates();
  bodies.contact.static_friction = bodies.contact.dynamic_friction = 0.3;
  domain::Domain made = bodies.build();
  test::throw_together(made, 0.1, {0.1, 0.05, -0.3});
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  const test::Impact found = test::impact(touching, made, 1e-3, 3000);
  EXPECT_LT(found.momentum, 1e-12);
  EXPECT_LT(found.spin, 1e-11);
  EXPECT_GT(made.contacts[0].friction_energy, 1e-3 * found.start.kinetic);
  const double lost = made.contacts[0].friction_energy + made.contacts[0].energy;
  test::verified("pinballs, two plates with friction: kinetic and lost energy over that at first",
                 "conservation")
      .near((test::balance(made, 1e-3).kinetic + lost) / found.start.kinetic, 1, 1e-12);
}

// A contact that sticks does no work where both turn together.
TEST(Pinballs, FrictionTurnsWithTheBodies) {
  Bodies bodies = two_plates();
  bodies.contact.static_friction = bodies.contact.dynamic_friction = 10;
  domain::Domain made = bodies.build();
  test::throw_together(made, 0.1, {0.1, 0.05, -0.4});
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  for (int step = 0; step < 200; ++step) test::integrate(touching, made, 1e-3);
  ASSERT_GT(made.contacts[0].active_pairs, 0);
  test::settle(touching, made);
  const std::vector<Vec3> before(made.contact_force.begin(), made.contact_force.end());
  test::turn(touching, made, {1, 2, 3}, 1.0, 1000);
  double largest = 0;
  double change = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    largest = test::larger_of(largest, norm(before[i]));
    change = test::larger_of(change, std::fabs(norm(made.contact_force[i]) - norm(before[i])));
  }
  test::verified("pinballs, sticking plates turned by 1 rad: size of a force, change over the largest",
                 "no work")
      .below(change / largest, 1e-11);
}

// The balls of next neighbours in a thick sheet overlap; that is none of the contacts that begin later, and
// no initial overlap.
TEST(Pinballs, AFlatMeshOfAnyThicknessIsAtRest) {
  for (const double thickness : {0.05, 0.5, 1.9}) {
    Bodies bodies(0.1);
    bodies.contact.side[0].contact_thickness = thickness;
    bodies.model.search.local = LocalSearchKind::Pinballs;
    bodies.sheet(6, 5, [](double u, double v) { return Vec3{6 * u, 5 * v, 0}; });
    domain::Domain made = bodies.build();
    contact::Interface touching = bodies.attach(made);
    const std::vector<Vec3> flat(made.nodes.position.begin(), made.nodes.position.end());
    // It begins stretched, where nothing overlaps that could be allowed for.
    for (Vec3& p : made.nodes.position) p = 4.0 * p;
    test::add_forces(touching, made);
    EXPECT_EQ(made.contacts[0].initial_overlaps.size(), 0U) << thickness;
    test::move_to(touching, made, flat, 1e-3);
    for (const Vec3& force : made.contact_force) EXPECT_LT(norm(force), 1e-9) << thickness;
    domain::Domain again = bodies.build();
    contact::Interface beginning = bodies.attach(again);
    test::add_forces(beginning, again);
    EXPECT_EQ(again.contacts[0].initial_overlaps.size(), 0U) << thickness;
  }
}

/// Two cubes of 2 x 2 x 2 hexahedra with an edge of 1, one above the other, a little aside and `gap` away;
/// faces with this thickness.
Bodies two_cubes(double gap, double thickness = 0) {
  Bodies bodies;
  bodies.model.search.local = LocalSearchKind::Pinballs;
  bodies.take_two_parts_of_solids();
  bodies.contact.solid_thickness = thickness;
  for (const int part : {0, 1})
    test::add_box(bodies.model, part, 2, 2, 2, [&](double u, double v, double w) {
      return test::Point{u + 0.13 * part, v + 0.07 * part, w + (1 + gap) * part};
    });
  return bodies;
}

// The balls of solids lie below the faces, but those beside a rim stand out over it by a third of a radius,
// of both.
TEST(Pinballs, FacesOfSolidsTouchWhereTheyAre) {
  const auto force_at = [](double overlap) {
    const Bodies bodies = two_cubes(0.1);
    domain::Domain made = bodies.build();
    contact::Interface touching = bodies.attach(made);
    test::add_forces(touching, made);
    EXPECT_EQ(made.contacts[0].initial_overlaps.size(), 0U);
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    for (Vec3& p : x)
      if (p.z > 1.05) p.z -= 0.1 + overlap;
    test::move_to(touching, made, x, 0.1);
    EXPECT_LT(norm(test::total_force(made)), 1e-12);
    double up = 0;
    for (Index i = 0; i < made.nodes.count(); ++i)
      if (made.nodes.reference[i].z > 1.05) up += made.contact_force[i].z;
    return up;
  };
  constexpr double edge = 0.5;
  constexpr double radius = 0.75 * edge / 8;
  EXPECT_EQ(force_at(-0.68 * radius), 0);
  EXPECT_GT(force_at(0.3 * radius), 0);
}

// The balls of faces move with the normal, and the force turns it. What is booked is the work done, so that
// the balance alone would not show where the force is not the slope of a potential.
TEST(Pinballs, CollisionOfSolidsKeepsMomentumAndEnergy) {
  for (const double thickness : {0.0, 0.2, 1.2}) {
    const Bodies bodies = two_cubes(thickness + 0.05, thickness);
    const auto collide = [&](int steps) {
      domain::Domain made = bodies.build();
      test::throw_together(made, 1.01, Vec3{0.03, 0.02, -0.1});
      contact::Interface touching = bodies.attach(made);
      touching.verify_search_every(20);
      test::add_forces(touching, made);
      const test::Impact found = test::impact(touching, made, 2e-3, steps);
      return std::pair{found, made.contacts[0]};
    };
    const std::string cubes =
        "pinballs, cubes with faces " + std::to_string(thickness).substr(0, 3) + " thick: ";
    // Nothing holds the masses of a cube together: after the first impact they fly on and meet again.
    expect_conserved(cubes, collide(1500).first, 0.1);
    const auto& [found, parted] = collide(500);
    EXPECT_EQ(parted.active_pairs, 0) << thickness;
    test::verified(cubes + "energy lost or made in the first impact, over the kinetic one",
                   "potential of the overlaps")
        .below(std::fabs(parted.energy) / found.start.kinetic, 0.002);
  }
}

TEST(Pinballs, ThreadsDoNotChangeABit) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 3, 4}) {
    Bodies bodies(0.06);
    bodies.model.search.local = LocalSearchKind::Pinballs;
    for (int layer = 0; layer < 3; ++layer)
      bodies.sheet(12 + layer, 10, [&](double u, double v) {
        return Vec3{2 * u + 0.01 * layer, 1.5 * v, 0.1 * layer + 0.004 * std::sin(5 * u + 3 * v)};
      });
    bodies.contact.static_friction = 0.3;
    bodies.contact.viscous_damping = 0.1;
    domain::Domain made = bodies.build(1.0, threads);
    for (Index i = 0; i < made.nodes.count(); ++i)
      made.nodes.velocity[i] = {0.2 * std::sin(20.0 * i), 0.1, -3.0 * made.nodes.position[i].z};
    contact::Interface touching = bodies.attach(made);
    test::add_forces(touching, made);
    for (int cycle = 0; cycle < 20; ++cycle) test::integrate(touching, made, 0.01);
    EXPECT_GT(made.contacts[0].active_pairs, 100);
    domain::StateList list;
    made.declare(list);
    touching.declare(list);
    hashes.push_back(list.hash());
  }
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
}

TEST(Pinballs, WhatTheyCannotServeIsRefused) {
  Bodies bodies = two_plates();
  const domain::Domain made = bodies.build();
  bodies.contact.enforcement = model::Enforcement::Multipliers;
  EXPECT_THROW(bodies.attach(made), Error);
  bodies.contact.enforcement = model::Enforcement::Penalty;
  bodies.contact.oriented = true;
  EXPECT_THROW(bodies.attach(made), Error);
  bodies.contact.oriented = false;
  bodies.model.search.has_cells = true;
  bodies.model.search.cells = {4, 4, 4};
  bodies.model.search.domain_minimum = {-9, -9, -9};
  bodies.model.search.domain_maximum = {9, 9, 9};
  EXPECT_THROW(bodies.attach(made), Error);
}

}  // namespace
}  // namespace crumple::pinballs_test
