// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "contact/bodies.hpp"
#include "contact/enforcement/penalty.hpp"
#include "support/largest.hpp"

namespace crumple::energy_test {
namespace {

using test::balance;
using test::Balance;
using test::Bodies;
using test::Vec3;

// Law: linear to half of the reach, potential by construction: the work over a path is that of the slope.
TEST(Penalty, ForceIsContinuousAndItsSlopeIsLimited) {
  contact::PenaltyLaw law{100.0, 600.0, 0.2};
  EXPECT_DOUBLE_EQ(law.force(0.05), 5.0);
  EXPECT_DOUBLE_EQ(law.force(-0.05), 0.0);
  const double h = 1e-6;
  double last_slope = 100;
  for (double d = 0; d < 0.4; d += 1e-3) {
    const double slope = (law.force(d + 1.5 * h) - law.force(d + 0.5 * h)) / h;
    EXPECT_LE(slope, 600 * (1 + 1e-6));
    EXPECT_GE(slope, last_slope - 1e-3);
    last_slope = slope;
  }
  test::verified("penalty: slope deep inside", "the limit").near(last_slope, 600, 1e-5);
  EXPECT_TRUE(law.is_limited_at(0.16));
  law.limit = 1e9;  // unlimited: ten times the stiffness at the mid-surface, and on
  EXPECT_FALSE(law.is_limited_at(0.3));
  EXPECT_NEAR((law.force(0.2 + h) - law.force(0.2 - h)) / (2 * h), 1000, 1e-3);
  EXPECT_NEAR((law.force(0.3 + h) - law.force(0.3 - h)) / (2 * h), 1900, 1e-3);
  // 100 * 0.2 and the integral of the growing slope, 900 over 0.1: 1/2 * 900 * 0.1.
  test::verified("penalty: force at the mid-surface", "integral of the slope")
      .near(law.force(0.2), 20 + 45, 1e-10);
  law.limit = 30;
  EXPECT_DOUBLE_EQ(law.force(0.15), 4.5);
  EXPECT_TRUE(law.is_limited_at(0.01));
}

// The energy is the integral of the force, whatever limits it, and its inverse gives the penetration back.
TEST(Penalty, EnergyIsTheIntegralOfTheForce) {
  for (const double limit : {30.0, 600.0, 1e9}) {
    const contact::PenaltyLaw law{100.0, limit, 0.2};
    double work = 0;
    constexpr int parts = 4000;
    constexpr double width = 0.4 / parts;
    for (int i = 0; i < parts; ++i) {
      work += width * law.force((i + 0.5) * width);
      if (i % 1000 != 999) continue;
      const double depth = (i + 1) * width;
      EXPECT_NEAR(law.energy(depth), work, 1e-6 * work) << limit << ' ' << depth;
      EXPECT_NEAR(law.penetration_of(law.energy(depth), 1), depth, 1e-9);
    }
    EXPECT_EQ(law.penetration_of(law.energy(0.4), 0.3), 0.3);
  }
}

TEST(Penalty, DecayIsTheExponentialFunction) {
  for (double x = 0; x < 690; x += 0.37) EXPECT_NEAR(contact::decay(x) / std::exp(-x), 1.0, 5e-13);
  EXPECT_EQ(contact::decay(1e6), 0.0);
}

/// Two plates of loose masses, elements not aligned, that fly at each other at an angle.
Bodies two_plates() {
  Bodies bodies(0.1);
  bodies.sheet(5, 4, [](double u, double v) { return Vec3{5 * u, 4 * v, 0}; });
  bodies.sheet(4, 4, [](double u, double v) { return Vec3{3.7 * u + 0.33, 3.5 * v + 0.21, 0.13}; });
  return bodies;
}

TEST(Energy, CollisionKeepsMomentumAndEnergy) {
  const Bodies bodies = two_plates();
  domain::Domain made = bodies.build(1.0);
  test::throw_together(made, 0.05, {0.0, 0.0, -0.4});
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  const test::Impact found = test::impact(touching, made, 1e-3, 3000);
  const std::string plates = "two plates of loose masses, meshes not aligned, collide: ";
  const char* const conserved = "conservation";
  test::verified(plates + "momentum, largest change", conserved).below(found.momentum, 1e-12);
  test::verified(plates + "moment of momentum, largest change", conserved).below(found.spin, 1e-11);
  EXPECT_GT(found.stored, 0.3 * found.start.kinetic);
  test::verified(plates + "imbalance over the kinetic energy at first", conserved)
      .below(found.imbalance / found.start.kinetic, 1e-12);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  // All that was stored has come back.
  test::verified(plates + "energy left in the contact over the kinetic one", "none")
      .below(std::fabs(made.contacts[0].energy) / found.start.kinetic, 1e-5);
  EXPECT_EQ(made.contacts[0].friction_energy, 0);
}

TEST(Energy, FrictionAndDampingTakeEnergyOut) {
  Bodies bodies = two_plates();
  bodies.contact.static_friction = 0.4;
  bodies.contact.dynamic_friction = 0.3;
  bodies.contact.viscous_damping = 0.2;
  domain::Domain made = bodies.build(1.0);
  test::throw_together(made, 0.05, {0.2, 0.1, -0.4});
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  const double step = 1e-3;
  const Balance start = balance(made, step);
  const std::string plates = "two plates with friction and damping collide: ";
  test::Largest energies(plates + "imbalance over the kinetic energy at first", "conservation", 1e-12);
  test::Largest momenta(plates + "momentum, largest change", "conservation", 1e-12);
  for (int i = 0; i < 3000; ++i) {
    test::integrate(touching, made, step);
    const Balance now = balance(made, step);
    const double taken = made.contacts[0].energy + made.contacts[0].friction_energy;
    energies.compare(now.kinetic + taken, start.kinetic, start.kinetic);
    momenta.add(norm(now.momentum - start.momentum));
  }
  EXPECT_GT(made.contacts[0].friction_energy, 0.01 * start.kinetic);
  EXPECT_GT(made.contacts[0].energy, 0.01 * start.kinetic);
}

// Twelve nodes on one segment, each against all: the stiffness that stability leaves keeps the run bounded.
TEST(Energy, ManyNodesOnOneSegmentStayStable) {
  Bodies bodies(0.1);
  bodies.model.control.contact_stiffness_scale = 1e6;
  bodies.sheet(1, 1, [](double u, double v) { return Vec3{4 * u, 4 * v, 0}; });
  bodies.sheet(6, 6, [](double u, double v) { return Vec3{3.5 * u + 0.2, 3.5 * v + 0.2, 0.12}; });
  domain::Domain made = bodies.build(1.0);
  for (Vec3& v : made.nodes.velocity) v = {};
  for (Index i = 0; i < made.nodes.count(); ++i)
    if (made.nodes.reference[i].z > 0.05) made.nodes.velocity[i].z = -1.0;
  contact::Interface touching = bodies.attach(made);
  const double step = 1e-3;
  made.clock.element_limit = step / 0.9;
  test::add_forces(touching, made);
  const double start = balance(made, step).kinetic;
  Index limited = 0;
  for (int i = 0; i < 400; ++i) {
    test::integrate(touching, made, step);
    limited = std::max(limited, touching.statistics().limited_pairs);
    ASSERT_LT(balance(made, step).kinetic, 1.3 * start);
  }
  EXPECT_GT(limited, 10);
  EXPECT_EQ(touching.statistics().most_limited_pairs, limited);
}

}  // namespace
}  // namespace crumple::energy_test
