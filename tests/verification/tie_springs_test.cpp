// SPDX-License-Identifier: BSD-3-Clause
// Tied contact by penalty (*CONTACT_TIED_..._OFFSET) and its failure (TIEBREAK): gaps stay, no rigid motion
// makes a force, momenta are kept, and a tie breaks at its strength.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/run.hpp"
#include "support/ties.hpp"

namespace crumple {
namespace {

using math::Vec3;

Vec3 angular_momentum(const domain::Domain& domain) {
  const domain::NodeFields& nodes = domain.nodes;
  Vec3 sum;
  for (Index i = 0; i < nodes.count(); ++i)
    sum += nodes.mass[i] * cross(nodes.position[i], nodes.velocity[i]) +
           nodes.inertia[i] * nodes.angular_velocity[i];
  return sum;
}

model::Model offset_blocks(Index coarse, Index fine, double gap) {
  model::Model model = test::two_blocks(coarse, fine, 4, model::TieMethod::Penalty, gap);
  model.tied_contacts[0].tolerance = 2 * gap;
  return model;
}

/// Two rigid blocks that turn as one: the springs pull what the turning needs.
TEST(TieSprings, RigidBodiesTurnAsOne) {
  model::Model model = offset_blocks(2, 3, 0.5);
  const double spin = 2.0;  // rad/ms
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    model.initial_velocities.push_back(
        {.node = i, .velocity = {-spin * (x[1] - 2), spin * (x[0] - 10), 0.3}, .angular_velocity = {}});
  }
  model.control.end_time = 1.0;
  test::make_rigid(model, 0);
  test::make_rigid(model, 1);
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  const domain::Domain& domain = simulation.domain();
  const Vec3 momentum = test::momentum(domain);
  double opening = 0;
  while (!simulation.finished()) {
    simulation.step();
    opening = std::max(opening, domain.ties[0].opening);
  }
  std::printf("opening %.2e, momentum %.1e, energy %.1e\n", opening,
              norm(test::momentum(domain) - momentum) / norm(momentum),
              domain.energy.imbalance() / domain.energy.initial_total);
  EXPECT_LT(opening, 2e-3);
  EXPECT_LT(norm(test::momentum(domain) - momentum), 1e-12 * norm(momentum));
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-6 * domain.energy.initial_total);
}

TEST(TieSprings, RigidPlacementIsFreeOfForce) {
  model::Model model = offset_blocks(2, 3, 0.5);
  model.control.end_time = 1e-6;
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  domain::Domain domain = simulation.domain();
  contact::TieSprings springs(model, domain, 0);
  const double angle = 2.1;
  for (Vec3& x : domain.nodes.position)
    x = {std::cos(angle) * x.x - std::sin(angle) * x.y + 3, std::sin(angle) * x.x + std::cos(angle) * x.y - 8,
         x.z + 5};
  springs.add_forces(domain);
  EXPECT_LT(domain.ties[0].opening, 1e-13);
  EXPECT_EQ(domain.ties[0].broken, 0);
}

TEST(TieSprings, MomentaAndEnergyAreKept) {
  model::Model model = offset_blocks(2, 3, 0.5);
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i,
                                        .velocity = {std::sin(1.0 * i), std::sin(2.0 * i), std::sin(3.0 * i)},
                                        .angular_velocity = {}});
  model.control.end_time = 0.1;
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  const domain::Domain& domain = simulation.domain();
  simulation.step();
  const Vec3 before = angular_momentum(domain);
  const Vec3 momentum = test::momentum(domain);
  double energy_error = 0;
  while (!simulation.finished()) {
    simulation.step();
    energy_error = std::max(energy_error, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  }
  std::printf("angular momentum %.2e, momentum %.2e, energy %.2e, in the springs %.2e\n",
              norm(angular_momentum(domain) - before) / norm(before),
              norm(test::momentum(domain) - momentum) / norm(momentum), energy_error,
              domain.ties[0].energy / domain.energy.initial_total);
  EXPECT_LT(norm(angular_momentum(domain) - before), 1e-11 * norm(before));
  EXPECT_LT(norm(test::momentum(domain) - momentum), 1e-11 * norm(momentum));
  EXPECT_LT(energy_error, 1e-3);
}

TEST(TieSprings, WavesPassTheJoint) {
  model::Model model = test::two_bars(2, 3, model::TieMethod::Penalty);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  double behind = 0;
  double ahead = 0;
  for (Index i = 0; i < domain.nodes.count(); ++i) {
    const double energy = domain.nodes.mass[i] * dot(domain.nodes.velocity[i], domain.nodes.velocity[i]);
    (domain.nodes.reference[i].x < 100 ? behind : ahead) += energy;
  }
  const double reflected = std::sqrt(behind / (ahead + behind));
  std::printf("reflected amplitude %.3f, energy error %.1e\n", reflected, domain.energy.error());
  EXPECT_LT(reflected, 0.45);
  EXPECT_LT(domain.energy.error(), 1e-3);
}

/// The shell joint of the constraint.
TEST(TieSprings, RotationsAreTiedWhereAsked) {
  const auto deflection = [](model::TieMethod method, bool rotations) {
    model::Model model = test::shell_joint(true, 6);
    model.tied_contacts[0].method = method;
    model.tied_contacts[0].ties_rotations = rotations;
    timeloop::Simulation simulation(model, test::execution());
    simulation.start();
    const domain::Domain& domain = simulation.domain();
    double largest = 0;
    while (!simulation.finished()) {
      simulation.step();
      for (const model::NodalLoad& load : model.nodal_loads)
        largest = std::max(largest, std::fabs(test::displacement(domain, load.node).y));
    }
    EXPECT_LT(domain.energy.error(), 0.01);
    return largest;
  };
  const double exact = deflection(model::TieMethod::Constraint, true);
  const double springs = deflection(model::TieMethod::Penalty, true);
  const double hinged = deflection(model::TieMethod::Penalty, false);
  std::printf("largest deflection: constraint %.5f, springs %.5f, without rotations %.5f\n", exact, springs,
              hinged);
  EXPECT_NEAR(springs, exact, 0.25 * exact);
  EXPECT_GT(hinged, 2 * exact);
}

/// Pulls two blocks apart or along each other by rigid bodies; returns the largest force of the tie.
struct Break {
  double largest_force = 0;
  Index broken = 0;
  double energy_error = 0;
};

Break run_break(int axis, const model::TieFailure& failure) {
  model::Model model = test::two_blocks(2, 3, 2, model::TieMethod::Penalty);
  model.tied_contacts[0].failure = failure;
  model.rigid_bodies.reserve(2);
  test::make_rigid(model, 0).fixed_translation = {true, true, true};
  test::make_rigid(model, 1);
  for (model::RigidBody& body : model.rigid_bodies) body.fixed_rotation = {true, true, true};
  test::add_constant_curve(model, 1.0);
  model.prescribed_motions.push_back({.body = 1, .axis = axis, .curve = 0, .scale = 0.2});
  model.control.end_time = 2.0;
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  const domain::Domain& domain = simulation.domain();
  Break found;
  while (!simulation.finished()) {
    simulation.step();
    found.largest_force = std::max(found.largest_force, norm(domain.ties[0].force));
  }
  found.broken = domain.ties[0].broken;
  found.energy_error = domain.energy.error();
  return found;
}

TEST(Tiebreak, BreaksAtItsStrength) {
  const double area = 16;
  const double normal = 0.3;
  const double shear = 0.2;
  const model::TieFailure failure{.normal_strength = normal, .shear_strength = shear};
  const Break tension = run_break(0, failure);
  const Break sliding = run_break(1, failure);
  std::printf("force / (strength area): tension %.4f, shear %.4f; broken %d %d; energy %.1e %.1e\n",
              tension.largest_force / (normal * area), sliding.largest_force / (shear * area), tension.broken,
              sliding.broken, tension.energy_error, sliding.energy_error);
  EXPECT_NEAR(tension.largest_force, normal * area, 0.01 * normal * area);
  EXPECT_NEAR(sliding.largest_force, shear * area, 0.01 * shear * area);
  EXPECT_EQ(tension.broken, 16);
  EXPECT_EQ(sliding.broken, 16);
}

/// Forces: every node breaks by itself, the corners of the surface carry the least.
TEST(Tiebreak, ForcesOnNodes) {
  const double strength = 0.05;
  const Break tension = run_break(
      0, {.normal_strength = strength, .normal_exponent = 1, .shear_exponent = 1, .by_stress = false});
  std::printf("force over strength %.3f\n", tension.largest_force / strength);
  EXPECT_EQ(tension.broken, 16);
  EXPECT_LT(tension.largest_force, 16 * strength);
}

}  // namespace
}  // namespace crumple
