// SPDX-License-Identifier: BSD-3-Clause
//
// Damping in proportion to mass (*DAMPING_GLOBAL), against the solutions of one degree of freedom.

#include <gtest/gtest.h>

#include <cmath>

#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::mass_damping_test {
namespace {

using math::Vec3;

constexpr double omega = 4;
constexpr double mass = 0.25;
constexpr double speed = 2;

/// A mass at the origin on a spring to the ground along x.
model::Model oscillator(double damping) {
  model::Model model = test::one_spring_part(model::LinearSpring{omega * omega * mass});
  const Index node = test::add_mass(model, {0, 0, 0}, mass);
  model.discretes.push_back({.id = 1, .part = 0, .node = {node, node}, .grounded = true, .axis = {-1, 0, 0}});
  model.initial_velocities.push_back({.node = node, .velocity = {speed, 0, 0}});
  model.mass_damping = model::MassDamping{.constant = damping};
  return model;
}

/// Largest error of the displacement over the first amplitude, and largest imbalance of the energy over the
/// energy of the start.
struct Errors {
  double displacement = 0;
  double energy = 0;
};

Errors swing(double damping, double step_scale) {
  model::Model model = oscillator(damping);
  model.control.step_scale = step_scale;
  model.control.end_time = 5;
  timeloop::Simulation simulation(model, test::execution());
  const double damped = std::sqrt(omega * omega - 0.25 * damping * damping);
  Errors found;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double t = domain.clock.time;
    const double exact = speed / damped * std::exp(-0.5 * damping * t) * std::sin(damped * t);
    const double error = std::fabs(test::displacement(domain, 0).x - exact);
    found.displacement = test::larger_of(found.displacement, error / (speed / omega));
    found.energy =
        test::larger_of(found.energy, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  });
  EXPECT_GT(simulation.domain().energy.damping, 0.9 * simulation.domain().energy.initial_total);
  return found;
}

TEST(MassDamping, OscillatorDecaysAsTheExactOne) {
  const Errors coarse = swing(0.8, 0.02);
  const Errors fine = swing(0.8, 0.01);
  test::verified("damped oscillator: displacement, error over the amplitude", "exact")
      .below(fine.displacement, 3e-3);
  // The velocity is half a step late: an error of the first order.
  EXPECT_LT(fine.displacement, 0.6 * coarse.displacement);
  test::verified("damped oscillator: imbalance over the energy of the start", "conservation")
      .below(fine.energy, 2e-4);
}

// With the undamped step times 0.9 the oscillator would grow: 0.9^2 4 > 4 - 2 D dt from D dt = 0.38 on.
TEST(MassDamping, StepIsStableHoweverStrongTheDamping) {
  double largest = 0;
  for (const double damping : {0.1, 4.0, 40.0, 4000.0}) {
    model::Model model = oscillator(damping);
    model.control.step_scale = 0.9;
    timeloop::Simulation simulation(model, test::execution());
    simulation.start();
    for (int cycle = 0; cycle < 20000; ++cycle) simulation.step();
    const domain::Domain& domain = simulation.domain();
    EXPECT_LT(std::fabs(domain.energy.imbalance()), domain.energy.initial_total) << damping;
    largest = test::larger_of(largest, std::fabs(test::displacement(domain, 0).x) / (speed / omega));
  }
  test::verified("oscillators of all dampings after 20000 cycles: displacement over the amplitude", "none")
      .below(largest, 1.0);
}

TEST(MassDamping, DampsTheDirectionsThatHaveAFactor) {
  model::Model model = oscillator(0);
  model.discretes.clear();
  test::add_mass(model, {1, 0, 0}, mass);
  model.discretes.push_back({.id = 1, .part = 0, .node = {0, 1}});
  for (const Index node : {0, 1})
    model.initial_velocities.push_back({.node = node, .velocity = {speed, speed, speed}});
  model.mass_damping = model::MassDamping{.constant = 3, .translation = {0, 1, 0.5}};
  model.control.step_scale = 0.001;
  model.control.end_time = 1;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double dt = domain.clock.step;
  // The velocities are half a step ahead of the time.
  const double time = domain.clock.time + 0.5 * dt;
  const Vec3 v = domain.nodes.velocity[0];
  EXPECT_NEAR(v.x, speed, 1e-12);
  EXPECT_NEAR(v.y, speed * std::exp(-3 * time), 3 * dt * speed);
  EXPECT_NEAR(v.z, speed * std::exp(-1.5 * time), 3 * dt * speed);
}

TEST(MassDamping, RigidBodySlowsDownAndStopsTurning) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 4, 2, 2, [](double u, double v, double w) {
    return test::Point{20 * u - 10, 10 * v - 5, 10 * w - 5};
  });
  test::make_rigid(model, 0);
  const Vec3 velocity{3, -1, 2};
  const double turning = 0.4;
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const auto& x = model.nodes.position[node];
    model.initial_velocities.push_back(
        {.node = node, .velocity = {velocity.x - turning * x[1], velocity.y + turning * x[0], velocity.z}});
  }
  const double damping = 0.7;
  model.mass_damping = model::MassDamping{.constant = damping};
  model.control.end_time = 2;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const domain::RigidBody& body = domain.rigid_bodies[0];
  const double left = std::exp(-damping * (domain.clock.time + 0.5 * domain.clock.step));
  test::verified("damped rigid body: velocity, error", "exact")
      .below(norm(body.velocity - left * velocity), 1e-3);
  test::verified("damped rigid body: angular velocity, error", "exact")
      .below(norm(body.angular_velocity - left * Vec3{0, 0, turning}), 1e-3 * turning);
  test::verified("damped rigid body: imbalance over the energy of the start", "conservation")
      .below(std::fabs(domain.energy.imbalance()) / domain.energy.initial_total, 1e-3);
}

}  // namespace
}  // namespace crumple::mass_damping_test
