// SPDX-License-Identifier: BSD-3-Clause
// Forces of inertia on some of the masses, loads that follow nodes, damping and mass by part, against closed
// forms.
#include <gtest/gtest.h>

#include <cmath>

#include "support/imbalance.hpp"
#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/rigid.hpp"
#include "support/verified.hpp"

namespace crumple::inertia_fields_test {
namespace {

using math::Vec3;

/// Two blocks of a part each, side by side: apart by a gap, or with common nodes if that is zero.
model::Model two_parts(double gap) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  model.parts.push_back({.id = 2, .title = "second", .solid_section = 0, .material = 0});
  if (gap > 0) {
    for (const Index part : {0, 1})
      test::add_box(model, part, 2, 2, 2, [&](double u, double v, double w) {
        return test::Point{10 * u + part * (10 + gap), 10 * v, 10 * w};
      });
  } else {
    test::add_box(model, 0, 4, 2, 2, [](double u, double v, double w) {
      return test::Point{20 * u, 10 * v, 10 * w};
    });
    for (model::SolidElement& solid : model.solids)
      if (model.nodes.position[solid.node[0]][0] >= 10) solid.part = 1;
  }
  return model;
}

/// The mass of a block of 10 x 10 x 10.
constexpr double block_mass = 7.85e-3;
constexpr double gravity = 9.81e-3;

model::InertiaField gravity_on(model::Model& model, std::vector<Index> parts) {
  model::InertiaField field;
  field.curve = test::add_constant_curve(model, 1);
  field.acceleration = {0, 0, gravity};
  field.of_all = parts.empty();
  field.parts = std::move(parts);
  return field;
}

TEST(InertiaFields, GravityOnAPartLetsItAloneFall) {
  model::Model model = two_parts(5);
  model.inertia_fields.push_back(gravity_on(model, {1}));
  timeloop::Simulation simulation(model, test::execution());
  test::ImbalanceAfterStart imbalance;
  test::run(simulation, [&](const domain::Domain& domain) { imbalance.observe(domain); });
  const domain::Domain& domain = simulation.domain();
  const double way = 0.5 * gravity * domain.clock.time * domain.clock.time;
  double error = 0;
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const bool falls = node >= 27;
    error = test::larger_of(error, norm(test::displacement(domain, node) + Vec3{0, 0, falls ? way : 0}));
  }
  test::verified("free fall of one of two parts: way, error over the way", "exact").below(error / way, 1e-10);
  test::verified("free fall of one of two parts: imbalance over the work", "conservation")
      .below(imbalance.largest() / domain.energy.external_work, 1e-10);
  const double speed = gravity * domain.clock.time;
  EXPECT_NEAR(domain.energy.external_work, 0.5 * block_mass * speed * speed, 1e-3 * domain.energy.kinetic);
}

TEST(InertiaFields, CommonNodesFeelTheShareOfThePart) {
  model::Model model = two_parts(0);
  model.inertia_fields.push_back(gravity_on(model, {1}));
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double time = domain.clock.time + 0.5 * simulation.next_step();
  test::verified("gravity on one of two parts with common nodes: momentum over that of its mass", "Newton")
      .within(test::momentum(domain).z, -block_mass * gravity * time, 1e-10);
}

TEST(InertiaFields, AllPartsTogetherFallAsTheWholeModel) {
  model::Model model = two_parts(0);
  model.inertia_fields.push_back(gravity_on(model, {0, 1}));
  model::Model other = two_parts(0);
  other.body_loads.push_back({2, test::add_constant_curve(other, gravity), 1});
  timeloop::Simulation by_parts(model, test::execution());
  timeloop::Simulation of_all(other, test::execution());
  test::run(by_parts);
  test::run(of_all);
  for (Index node = 0; node < model.nodes.count(); ++node)
    EXPECT_LT(norm(test::displacement(by_parts.domain(), node) - test::displacement(of_all.domain(), node)),
              1e-12);
}

/// A mass without forces in a frame that turns with angular velocity 2 about an axis through (1, 0, 0) along
/// z: r grows as cosh(2 t), to (omega dt)^2 / 24 in omega.
TEST(InertiaFields, AMassInATurningFrameFliesOut) {
  model::Model model = test::one_spring_part(model::LinearSpring{1e-12});
  const Index node = test::add_mass(model, {1.5, 0, 0.3}, 2.0);
  model.discretes.push_back({.id = 1, .part = 0, .node = {node, node}, .grounded = true, .axis = {1, 0, 0}});
  const double step = 0.01;
  model.curves.push_back({1, {0, 1e6}, {step, step}});
  model.control.step_curve = 0;
  model::InertiaField field;
  field.curve = test::add_constant_curve(model, 4);
  field.spin = {0, 0, 0.5};
  field.centre = {1, 0, 0};
  model.inertia_fields.push_back(field);
  model.control.end_time = 1.5;
  timeloop::Simulation simulation(model, test::execution());
  test::ImbalanceAfterStart imbalance;
  test::run(simulation, [&](const domain::Domain& domain) {
    imbalance.observe(domain);
    EXPECT_LE(domain.clock.step, step * (1 + 1e-12));
  });
  const domain::Domain& domain = simulation.domain();
  const double turned = 2 * domain.clock.time;
  const Vec3 x = domain.nodes.position[0];
  const double allowed = turned * 4 * step * step / 24;
  test::verified("mass in a turning frame: distance from the axis", "exact")
      .within(x.x - 1, 0.5 * std::cosh(turned), 1.1 * allowed);
  EXPECT_EQ(x.z, 0.3);
  test::verified("mass in a turning frame: imbalance over the external work", "conservation")
      .below(imbalance.largest() / domain.energy.external_work, 1e-11);
}

/// The inertia that a body's nodes make, as given one.
TEST(InertiaFields, ABodyWithGivenInertiaMovesAsItsNodes) {
  std::vector<domain::RigidBody> bodies;
  double imbalance = 0;
  for (const bool given : {false, true}) {
    model::Model model = test::one_solid_part(test::elastic_steel());
    test::add_box(model, 0, 2, 1, 1, [](double u, double v, double w) {
      return test::Point{20 * u + 4, 10 * v + 2, 5 * w - 1};
    });
    model::RigidBody& body = test::make_rigid(model, 0);
    if (given) {
      // Of the masses at the nodes: 1, 2, 1 eighths along x, halves along y and z.
      const double m = 7.85e-6 * 20 * 10 * 5;
      const double xx = 0.5 * m * 100;
      const double yy = 0.25 * m * 100;
      const double zz = 0.25 * m * 25;
      body.inertia = model::RigidInertia{
          .mass = m, .centre = {14, 7, 1.5}, .tensor = {yy + zz, 0, 0, xx + zz, 0, xx + yy}};
    }
    model::InertiaField field;
    field.curve = test::add_constant_curve(model, 1);
    field.acceleration = {0.01, 0, -0.02};
    field.spin = {0.1, 0.2, -0.15};
    field.centre = {1, 2, 3};
    model.inertia_fields.push_back(field);
    model.control.end_time = 1;
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    bodies.push_back(simulation.domain().rigid_bodies[0]);
    const domain::EnergyLedger& energy = simulation.domain().energy;
    imbalance = test::larger_of(imbalance, std::fabs(energy.imbalance() / energy.external_work));
  }
  EXPECT_GT(norm(bodies[0].angular_velocity), 1e-3);
  test::verified("rigid body in a turning frame: velocity, error", "sum over its nodes")
      .below(norm(bodies[0].velocity - bodies[1].velocity) / norm(bodies[0].velocity), 1e-10);
  test::verified("rigid body in a turning frame: angular velocity, error", "sum over its nodes")
      .below(norm(bodies[0].angular_velocity - bodies[1].angular_velocity) / norm(bodies[0].angular_velocity),
             1e-10);
  EXPECT_LT(imbalance, 1e-6);
}

/// A body that spins about z with a force along its own x: the centre has F / (m w) (sin w t, 1 - cos w t).
TEST(FollowerLoads, TurnWithASpinningBody) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 1, 1, 1, [](double u, double v, double w) {
    return test::Point{10 * u - 5, 10 * v - 5, 10 * w - 5};
  });
  test::make_rigid(model, 0);
  const double spin = 0.8;
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const auto& x = model.nodes.position[node];
    model.initial_velocities.push_back(
        {.node = node, .velocity = {-spin * x[1], spin * x[0], 0}, .angular_velocity = {0, 0, spin}});
  }
  // Nodes 0, 2, 4 span the face across x: (0, 10, 0) x (0, 0, 10).
  const double force = 1e-3;
  model.rigid_body_loads.push_back({.body = 0,
                                    .force = {force, 0, 0},
                                    .moment = {},
                                    .curve = test::add_constant_curve(model, 1),
                                    .plane = {{0, 2, 4}}});
  const double step = 0.002;
  model.curves.push_back({9, {0, 1e6}, {step, step}});
  model.control.step_curve = static_cast<Index>(model.curves.size()) - 1;
  model.control.end_time = 3;
  timeloop::Simulation simulation(model, test::execution());
  test::ImbalanceAfterStart imbalance;
  test::run(simulation, [&](const domain::Domain& domain) { imbalance.observe(domain); });
  const domain::Domain& domain = simulation.domain();
  const double phase = spin * (domain.clock.time + 0.5 * simulation.next_step());
  const double unit = force / (block_mass * spin);
  const Vec3 exact{unit * std::sin(phase), unit * (1 - std::cos(phase)), 0};
  const double turned_in_step = spin * domain.clock.step;
  // The first half kick and the sums over a turn are of second order.
  test::verified("follower force on a spinning body: velocity, error over F / (m w)", "exact")
      .below(norm(domain.rigid_bodies[0].velocity - exact) / unit, turned_in_step * turned_in_step);
  test::verified("follower force on a spinning body: imbalance over the energy of the start", "conservation")
      .below(imbalance.largest() / domain.energy.initial_total, 1e-10);
}

TEST(PartDamping, SlowsItsPartAlone) {
  model::Model model = two_parts(5);
  for (Index node = 0; node < model.nodes.count(); ++node)
    model.initial_velocities.push_back({.node = node, .velocity = {1, -2, 0.5}});
  const double damping = 2;
  model::MassDamping given;
  given.curve = test::add_constant_curve(model, 1);
  given.scale = damping;
  given.parts = {1};
  model.part_dampings.push_back(given);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double time = domain.clock.time + 0.5 * simulation.next_step();
  const double left = std::exp(-damping * time);
  // Each step leaves 1 - D dt of the velocity, of exp(-D dt): D^2 dt^2 / 2 in a step.
  const double allowed = 0.6 * damping * damping * domain.clock.step * time;
  const Vec3 start{1, -2, 0.5};
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const Vec3 velocity = domain.nodes.velocity[domain.nodes.domain_node[node]];
    const double share = node < 27 ? 1 : left;
    EXPECT_LT(norm(velocity - share * start), (node < 27 ? 1e-10 : allowed) * norm(start)) << node;
  }
  EXPECT_LT(std::fabs(domain.energy.imbalance()) / domain.energy.initial_total, allowed);
  test::verified("damping of a part: damping energy over the kinetic energy it has lost", "conservation")
      .within(domain.energy.damping, 0.5 * block_mass * dot(start, start) * (1 - left * left), 3 * allowed);
}

TEST(PartDamping, OfARigidPartDampsItsBody) {
  model::Model model = two_parts(5);
  test::make_rigid(model, 1);
  for (Index node = 0; node < model.nodes.count(); ++node)
    model.initial_velocities.push_back({.node = node, .velocity = {1, 0, 0}});
  model::MassDamping given;
  given.curve = test::add_constant_curve(model, 1);
  given.parts = {1};
  given.translation = {0.5, 1, 1};
  model.part_dampings.push_back(given);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double time = domain.clock.time + 0.5 * simulation.next_step();
  EXPECT_NEAR(domain.rigid_bodies[0].velocity.x, std::exp(-0.5 * time), 0.5 * domain.clock.step);
  EXPECT_NEAR(domain.nodes.velocity[domain.nodes.domain_node[0]].x, 1, 1e-10);
}

TEST(PartMasses, AreSpreadInProportionToTheMassesOfThePart) {
  model::Model model = two_parts(0);
  model.part_masses.push_back({.parts = {1}, .added = 0, .final_mass = 2 * block_mass});
  model.part_masses.push_back({.parts = {0}, .added = 0.5 * block_mass});
  const timeloop::Simulation simulation(model, test::execution());
  const model::Model plain = two_parts(0);
  const timeloop::Simulation before(plain, test::execution());
  double total = 0;
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const double x = model.nodes.position[node][0];
    const double mass = simulation.domain().nodes.mass[simulation.domain().nodes.domain_node[node]];
    const double first = before.domain().nodes.mass[before.domain().nodes.domain_node[node]];
    const double factor = x < 10 ? 1.5 : x > 10 ? 2 : 1.75;
    EXPECT_NEAR(mass, factor * first, 1e-12 * mass) << node;
    total += mass;
  }
  EXPECT_NEAR(total, 3.5 * block_mass, 1e-12);
}

}  // namespace
}  // namespace crumple::inertia_fields_test
