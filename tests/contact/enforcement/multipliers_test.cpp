// SPDX-License-Identifier: BSD-3-Clause
// Contact by Lagrange multipliers: no penetration at the end of a step, no pull, exact stick.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "contact/bodies.hpp"
#include "contact/force_transducer.hpp"
#include "support/largest.hpp"

namespace crumple::multipliers_test {
namespace {

using test::Bodies;
using test::Vec3;

constexpr double thickness = 0.1;
constexpr double step = 0.05;
constexpr double mass = 2.0;

/// Only what a matrix projects on is left to these nodes.
void leave_free(domain::Domain& made, const std::vector<Index>& which, const math::Matrix3& free, int held) {
  domain::NodeFields& nodes = made.nodes;
  nodes.local_hold.assign(static_cast<std::size_t>(nodes.count()), no_index);
  nodes.local_holds = {{.free = free, .held = held, .lasts = true}};
  for (const Index node : which) nodes.local_hold[static_cast<std::size_t>(node)] = 0;
}

/// A node of a small sheet above one large shell, integrated by central differences with the forces that a
/// test gives and those of contact.
class Press {
 public:
  explicit Press(double friction = 0, double height = 0.12) : bodies_(thickness) {
    floor_ = bodies_.sheet(1, 1, [](double u, double v) { return Vec3{4 * u - 2, 4 * v - 2, 0}; });
    small_ = bodies_.sheet(1, 1, [&](double u, double v) {
      return Vec3{0.6 * u - 0.3, 0.6 * v - 0.3, height};
    });
    bodies_.contact.enforcement = model::Enforcement::Multipliers;
    bodies_.contact.static_friction = bodies_.contact.dynamic_friction = friction;
    made_ = bodies_.build(mass);
    for (Index i = 0; i < 4; ++i) made_.nodes.fixed[test::at(made_, floor_ + i)] = 7;  // translations
    touching_.emplace(bodies_.attach(made_));
  }

  /// Supports with a time of their own instead of fixed degrees of freedom.
  void hold_floor_locally() {
    std::vector<Index> floor;
    for (Index i = 0; i < 4; ++i) {
      floor.push_back(test::at(made_, floor_ + i));
      made_.nodes.fixed[floor.back()] = 0;
    }
    leave_free(made_, floor, {}, 3);
  }
  /// Leaves the sheet the line x = z.
  void hold_sheet_on_slope() {
    const Vec3 half{0.5, 0, 0.5};
    leave_free(made_, {node(0), node(1), node(2), node(3)}, {{half, Vec3{}, half}}, 2);
  }
  /// Leaves the sheet the plane of the floor, by axes that are not the global ones: rounding leaves a rest.
  void hold_sheet_along_floor() {
    made_.nodes.local_holds.push_back(
        {.free = {{Vec3{1, 0, 1e-17}, Vec3{0, 1, 0}, Vec3{1e-17, 0, 1e-17}}}, .held = 1, .lasts = true});
    for (Index i = 0; i < 4; ++i) made_.nodes.local_hold[static_cast<std::size_t>(node(i))] = 1;
  }

  /// One step with a force on each node of the small sheet.
  void advance(const Vec3& force) {
    test::clear_forces(made_);
    for (Index i = 0; i < 4; ++i)
      for (int axis = 0; axis < 3; ++axis) made_.nodes.force[node(i)].force[axis] = force[axis];
    touching_->add_multipliers(made_, step, step);
    for (Index i = 0; i < 4; ++i) {
      const double* total = made_.nodes.force[node(i)].force;
      const Vec3 kicked = made_.nodes.velocity[node(i)] + (step / mass) * Vec3{total[0], total[1], total[2]};
      made_.nodes.velocity[node(i)] = made_.nodes.free_translation(node(i), kicked);
      made_.nodes.position[node(i)] += step * made_.nodes.velocity[node(i)];
    }
    made_.clock.step = step;
    made_.clock.time += step;
    ++made_.clock.cycle;
  }

  Index node(Index i) const { return test::at(made_, small_ + i); }
  Vec3 position() const { return made_.nodes.position[node(0)]; }
  Vec3& velocity(Index i) { return made_.nodes.velocity[node(i)]; }
  Vec3 contact_force() const { return made_.contact_force[node(0)]; }
  const domain::Domain& made() const { return made_; }
  /// What all four nodes feel.
  Vec3 transducer() const {
    model::ForceTransducer transducer;
    for (Index i = 0; i < 4; ++i) transducer.side[0].nodes.push_back(small_ + i);
    return contact::ForceTransducer(bodies_.model, made_, transducer).measure(*touching_);
  }

 private:
  Bodies bodies_;
  Index floor_ = 0;
  Index small_ = 0;
  domain::Domain made_;
  std::optional<contact::Interface> touching_;
};

// The sheet comes down under a force and rests on the other: its distance is the thickness to the last bits
// from the first touch on, and the contact force is then the load.
TEST(Multipliers, LeaveNoPenetrationAndCarryTheLoad) {
  Press press;
  bool touched = false;
  test::Largest distances("multipliers, sheet pressed onto a shell: distance off the thickness",
                          "constraint, exact", 1e-14);
  for (int i = 0; i < 200; ++i) {
    press.advance({0, 0, -0.3});
    EXPECT_GE(press.position().z, thickness - 1e-14);
    EXPECT_GE(press.contact_force().z, 0);
    touched = touched || press.contact_force().z > 0;
    if (!touched) continue;
    distances.compare(press.position().z, thickness);
  }
  test::verified("multipliers, sheet at rest: contact force of a node", "the load")
      .near(press.contact_force().z, 0.3, 1e-13);
  test::verified("multipliers, sheet at rest: force transducer of four nodes", "the load")
      .near(press.transducer().z, 4 * 0.3, 1e-12);
  EXPECT_EQ(press.made().contacts[0].penetration, 0);
}

TEST(Multipliers, NeverPull) {
  Press press;
  for (int i = 0; i < 50; ++i) press.advance({0, 0, -0.3});
  for (int i = 0; i < 50; ++i) {
    press.advance({0, 0, 0.01});
    EXPECT_EQ(norm(press.contact_force()), 0);
  }
  EXPECT_GT(press.position().z, thickness);
}

// The same as with fixed degrees of freedom, bit by bit.
TEST(Multipliers, ASupportOfATimeHoldsAsAFixedOne) {
  Press fixed;
  Press held;
  held.hold_floor_locally();
  for (int i = 0; i < 200; ++i) {
    fixed.advance({0, 0, -0.3});
    held.advance({0, 0, -0.3});
    ASSERT_EQ(norm(held.position() - fixed.position()), 0) << i;
    ASSERT_EQ(norm(held.contact_force() - fixed.contact_force()), 0) << i;
  }
  EXPECT_GT(fixed.contact_force().z, 0);
}

// Nodes on a slope of 45 degrees rest where the floor stops them; the slope takes nothing along itself.
TEST(Multipliers, NodesHeldAlongObliqueAxesReachTheFloorAndNoFurther) {
  Press press;
  press.hold_sheet_on_slope();
  const double start = press.position().x - press.position().z;
  bool touched = false;
  test::Largest distances("multipliers, sheet on a slope pressed onto a shell: distance off the thickness",
                          "constraint, exact", 1e-14);
  for (int i = 0; i < 200; ++i) {
    press.advance({0, 0, -0.3});
    EXPECT_GE(press.position().z, thickness - 1e-14);
    EXPECT_NEAR(press.position().x - press.position().z, start, 1e-14);
    touched = touched || press.contact_force().z > 0;
    if (touched) distances.compare(press.position().z, thickness);
  }
  EXPECT_TRUE(touched);
  test::verified("multipliers, sheet on a slope at rest: contact force of a node", "the load")
      .near(press.contact_force().z, 0.3, 1e-13);
}

// Both sides are held along the normal: no force can part them, and none is tried.
TEST(Multipliers, GiveNoForceWhereObliqueSupportsLeaveNothingFree) {
  Press press(0, 0.09);
  press.hold_floor_locally();
  press.hold_sheet_along_floor();
  for (int i = 0; i < 5; ++i) press.advance({0.1, 0, -0.3});
  EXPECT_EQ(norm(press.contact_force()), 0);
  EXPECT_NEAR(press.position().z, 0.09, 1e-14);
}

// Where friction holds there is no slip at all; above mu N the sheet slides, and the force is mu N.
TEST(Multipliers, StickExactlyAndSlideByCoulombsLaw) {
  const double mu = 0.4;
  Press press(mu);
  for (int i = 0; i < 100; ++i) press.advance({0, 0, -0.3});
  const Vec3 start = press.position();
  {
    test::Largest slips("multipliers, pulled by 0.99 mu N: slip", "none", 1e-13);
    for (int i = 0; i < 50; ++i) {
      press.advance({0.3 * mu * 0.99, 0, -0.3});
      slips.add(norm(press.position() - start));
    }
  }
  for (int i = 0; i < 20; ++i) press.advance({0.3 * mu * 1.5, 0, -0.3});
  test::verified("multipliers, pulled by 1.5 mu N: friction", "Coulomb")
      .near(press.contact_force().x, -mu * 0.3, 1e-13);
  EXPECT_NEAR(press.position().x - start.x, 0.5 * (0.3 * mu * 0.5 / mass) * std::pow(20 * step, 2),
              0.06 * 0.5 * (0.3 * mu * 0.5 / mass) * std::pow(20 * step, 2))
      << "the discrete path is longer by one part in twenty";
}

// Two free nodes against a free segment: momentum is that of before.
// The first step of a touch has no contact point before it. Nodes of elastic bodies begin so often that a
// third of the friction was missing.
TEST(Multipliers, RubFromTheFirstStepOn) {
  constexpr double friction = 0.3;
  Press press(friction);
  for (Index i = 0; i < 4; ++i) press.velocity(i) = {0.05, -0.02, -0.1};
  Vec3 force;
  for (int i = 0; i < 10 && force.z == 0; ++i) {
    press.advance({});
    force = press.contact_force();
  }
  ASSERT_GT(force.z, 0);
  const double size = std::hypot(force.x, force.y);
  EXPECT_NEAR(size, friction * force.z, 1e-12 * force.z);
  EXPECT_NEAR(force.x, -0.05 / std::hypot(0.05, 0.02) * size, 1e-9 * size);
  EXPECT_NEAR(force.y, 0.02 / std::hypot(0.05, 0.02) * size, 1e-9 * size);
}

TEST(Multipliers, KeepMomentum) {
  Bodies bodies(thickness);
  bodies.sheet(2, 2, [](double u, double v) { return Vec3{2 * u, 2 * v, 0}; });
  const Index small = bodies.sheet(2, 2, [](double u, double v) {
    return Vec3{0.3 + u, 0.45 + 0.8 * v, 0.11 + 0.02 * u};
  });
  bodies.contact.enforcement = model::Enforcement::Multipliers;
  bodies.contact.static_friction = bodies.contact.dynamic_friction = 0.3;
  domain::Domain made = bodies.build(mass);
  contact::Interface touching = bodies.attach(made);
  for (Index i = 0; i < 9; ++i) made.nodes.velocity[test::at(made, small + i)] = {0.1, 0.05, -0.4};
  const double initial = 9 * 0.5 * mass * (0.1 * 0.1 + 0.05 * 0.05 + 0.4 * 0.4);
  bool touched = false;
  test::Largest sums("multipliers, free sheets collide with friction: sum of all forces",
                     "conservation of momentum", 1e-13);
  for (int cycle = 0; cycle < 20; ++cycle) {
    test::clear_forces(made);
    touching.add_multipliers(made, step, step);
    touched = touched || made.contacts[0].active_pairs > 0 || norm(made.contact_force[0]) > 0;
    sums.add(norm(test::total_force(made)));
    double energy = 0;
    for (Index i = 0; i < made.nodes.count(); ++i) {
      made.nodes.velocity[i] += (step / mass) * made.contact_force[i];
      made.nodes.position[i] += step * made.nodes.velocity[i];
      energy += 0.5 * mass * dot(made.nodes.velocity[i], made.nodes.velocity[i]);
    }
    EXPECT_LE(energy, initial * (1 + 1e-12)) << "an impact of nodes takes energy and gives none";
    made.clock.step = step;
    ++made.clock.cycle;
  }
  EXPECT_TRUE(touched);
}

}  // namespace
}  // namespace crumple::multipliers_test
