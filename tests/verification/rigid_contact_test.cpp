// SPDX-License-Identifier: BSD-3-Clause
//
// Rigid plates in single-surface contact. Contact is elastic: of two equal bodies that meet centrally the
// second takes over all of the first's motion; off the centre momenta and energy are kept.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::rigid_contact_test {
namespace {

using math::Vec3;

constexpr double speed = 5.0;

/// Two square plates of 5 mm shells above each other, the upper one smaller by `less` cells and shifted.
model::Model two_plates(Index less, double shift) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1.0, 3));
  model.parts.push_back({.id = 2, .title = "second", .section = 0, .material = 0});
  const auto add = [&](Index part, Index cells, double z, double x) {
    return test::add_grid(model, part, cells, cells, [=](double u, double v) {
      return test::Point{5.0 * cells * (u - 0.5) + x, 5.0 * cells * (v - 0.5), z};
    });
  };
  add(0, 6, 0, 0);
  const Index upper = add(1, 6 - less, 1.3, shift);
  for (Index i = upper; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i, .velocity = {0, 0, -speed}, .angular_velocity = {}});
  model.contacts.push_back(model::self_contact(1, "all", {0, 1}));
  model.control.end_time = 0.3;
  return model;
}

Vec3 momentum(const domain::Domain& domain) {
  Vec3 sum;
  for (const domain::RigidBody& body : domain.rigid_bodies) sum += body.mass * body.velocity;
  return sum;
}

Vec3 angular_momentum(const domain::Domain& domain) {
  Vec3 sum;
  for (const domain::RigidBody& body : domain.rigid_bodies)
    sum += body.angular_momentum + body.mass * cross(body.centre, body.velocity);
  return sum;
}

TEST(RigidContact, EqualPlatesExchangeTheirMotion) {
  model::Model model = two_plates(0, 0);
  test::make_rigid(model, 0);
  test::make_rigid(model, 1);
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  const Vec3 start = momentum(domain);
  test::run(simulation);
  EXPECT_GT(domain.contacts[0].worst_penetration, 0.0) << "the plates must have touched";
  EXPECT_LT(norm(momentum(domain) - start), 1e-12 * norm(start));
  test::verified("rigid plate strikes an equal one: velocity taken over", "elastic impact")
      .near(-domain.rigid_bodies[0].velocity.z / speed, 1, 2e-3);
  EXPECT_NEAR(domain.rigid_bodies[1].velocity.z, 0, 2e-3 * speed);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-6 * domain.energy.initial_total);
}

/// A plate with a thousandth of its moments of inertia that comes down off the centre of a deformable one:
/// what contact may do to its nodes goes by how the body moves, not by their masses.
TEST(RigidContact, SmallGivenInertiaIsStable) {
  model::Model model = two_plates(3, 7);
  model::RigidBody& body = test::make_rigid(model, 1);
  constexpr double mass = 7.85e-6 * 15 * 15;
  constexpr double moment = 1e-3 * mass * 15 * 15 / 12;
  body.inertia = {.mass = mass, .centre = {7, 0, 1.3}, .tensor = {moment, 0, 0, moment, 0, 2 * moment}};
  body.inertia->velocity = {0, 0, -speed};
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  double most = 0;
  test::run(simulation, [&](const domain::Domain& now) { most = std::max(most, now.energy.kinetic); });
  EXPECT_GT(domain.contacts[0].worst_penetration, 0.0) << "the plates must have touched";
  EXPECT_LT(most, 1.01 * domain.energy.initial_total);
  test::verified("rigid plate with a thousandth of its inertia on a sheet: energy error over the energy",
                 "conservation")
      .below(std::fabs(domain.energy.imbalance()) / domain.energy.initial_total, 1e-2);
}

TEST(RigidContact, OffCentreImpactKeepsMomentaAndEnergy) {
  model::Model model = two_plates(3, 7);
  test::make_rigid(model, 0);
  test::make_rigid(model, 1);
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  const Vec3 start = momentum(domain);
  const Vec3 turning = angular_momentum(domain);
  test::run(simulation);
  EXPECT_GT(domain.contacts[0].worst_penetration, 0.0);
  EXPECT_LT(norm(momentum(domain) - start), 1e-12 * norm(start));
  test::verified("rigid plate strikes another off its centre: angular momentum", "conservation")
      .below(norm(angular_momentum(domain) - turning) / norm(turning), 1e-12);
  RecordProperty("imbalance", test::figure(domain.energy.imbalance() / domain.energy.initial_total));
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-3 * domain.energy.initial_total);
  EXPECT_GT(norm(domain.rigid_bodies[0].spin), 0.01) << "it turns";
}

TEST(RigidContact, RigidPlateStrikesADeformableOne) {
  model::Model model = two_plates(3, 3);
  test::make_rigid(model, 1);
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  const Vec3 start = test::momentum(domain);
  test::run(simulation);
  EXPECT_GT(domain.contacts[0].worst_penetration, 0.0);
  Vec3 end = momentum(domain);
  for (Index i = 0; i < domain.nodes.count(); ++i)
    if (domain.nodes.is_free(i)) end += domain.nodes.mass[i] * domain.nodes.velocity[i];
  EXPECT_LT(norm(end - start), 1e-12 * norm(start));
  RecordProperty("imbalance", test::figure(domain.energy.imbalance() / domain.energy.initial_total));
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-3 * domain.energy.initial_total);
}

}  // namespace
}  // namespace crumple::rigid_contact_test
