// SPDX-License-Identifier: BSD-3-Clause
//
// Nodes that move with the mean of others (*CONSTRAINED_INTERPOLATION).

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/conservation.hpp"
#include "support/imbalance.hpp"
#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/rigid.hpp"
#include "support/verified.hpp"

namespace crumple::interpolation_test {
namespace {

using math::Vec3;
using test::Point;

/// A cube of side 10 about the origin, and a node above it that follows the corners of its upper face.
model::Model cube_with_node(double mass, double inertia, const Point& at) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  // Viscous hourglass control would let the corners creep under their forces.
  model.solid_sections[0].formulation = model::SolidFormulation::SelectiveHexahedron;
  test::add_box(model, 0, 2, 2, 2, [](double u, double v, double w) {
    return Point{10 * u - 5, 10 * v - 5, 10 * w - 5};
  });
  model::Interpolation interpolation;
  interpolation.id = 1;
  for (const Index corner : {18, 20, 24, 26}) interpolation.independent.push_back({corner, 1, 0});
  interpolation.dependent = model.nodes.count();
  model.nodes.id.push_back(model.nodes.count() + 1);
  model.nodes.position.push_back(at);
  if (mass > 0)
    model.lumped_masses.push_back(
        {.id = 1, .node = interpolation.dependent, .mass = mass, .inertia = inertia});
  model.interpolations.push_back(interpolation);
  return model;
}

void set_rigid_motion(model::Model& model, const Vec3& velocity, const Vec3& spin) {
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const Point& x = model.nodes.position[node];
    const Vec3 v = velocity + cross(spin, Vec3{x[0], x[1], x[2]});
    model.initial_velocities.push_back(
        {.node = node, .velocity = {v.x, v.y, v.z}, .angular_velocity = {spin.x, spin.y, spin.z}});
  }
}

TEST(Interpolation, NodeFollowsARigidTurnAndKeepsWhatIsConserved) {
  for (const bool has_mass : {false, true}) {
    const Point at{3, 1, 12};
    model::Model model = cube_with_node(has_mass ? 1e-3 : 0, has_mass ? 0.01 : 0, at);
    const double spin = 0.8;
    set_rigid_motion(model, {0.1, 0.2, -0.1}, {0.8 * spin, 0, 0.6 * spin});
    model.control.end_time = 2 * std::numbers::pi / spin;
    timeloop::Simulation simulation(model, test::execution());
    test::Conservation kept;
    double distance = 0;
    const Index node = simulation.domain().nodes.domain_node[model.interpolations[0].dependent];
    test::run(simulation, [&](const domain::Domain& domain) {
      kept.watch(domain);
      // From the corners of the face its distances stay, but for what the cube swings and stretches by.
      for (const model::Interpolation::Independent& each : model.interpolations[0].independent) {
        const Index corner = domain.nodes.domain_node[each.node];
        const double now = norm(domain.nodes.position[node] - domain.nodes.position[corner]);
        const double first = norm(domain.nodes.reference[node] - domain.nodes.reference[corner]);
        distance = test::larger_of(distance, std::fabs(now / first - 1));
      }
    });
    test::verified(std::string("interpolated node ") + (has_mass ? "with" : "without") +
                       " mass, one turn: change of its distances",
                   "exact")
        .below(distance, 1e-5);
    test::verified("interpolated node: momentum, drift", "conservation").below(kept.momentum_drift, 1e-11);
    test::verified("interpolated node: moment of momentum, drift", "conservation")
        .below(kept.turning_drift, 1e-10);
    test::verified("interpolated node: imbalance over the energy of the start", "conservation")
        .below(kept.worst_imbalance, 1e-6);
  }
}

// The motion of the node is the weighted mean with the rotation of least squares: of a shear that is half of
// it.
TEST(Interpolation, OfAShearHasHalfOfItAsRotation) {
  model::Model model = cube_with_node(0, 0, {0, 0, 5});
  model.interpolations[0].independent.clear();
  // Corners of a square of side 10 in the plane z = 5; a weight of three on one side moves the centre to x
  // = 2.5.
  for (const Index corner : {18, 20, 24, 26})
    model.interpolations[0].independent.push_back({corner, corner % 6 == 2 ? 3.0 : 1.0, 0});
  const double rate = 1e-3;
  for (Index node = 0; node < 27; ++node)
    model.initial_velocities.push_back(
        {.node = node, .velocity = {rate * model.nodes.position[node][1], 0, 0}});
  const timeloop::Simulation simulation(model, test::execution());
  const domain::NodeFields& nodes = simulation.domain().nodes;
  const Index node = nodes.domain_node[model.interpolations[0].dependent];
  // w about the centre (2.5, 0): sum of w (r x v)_z over sum of w r^2 = -rate y^2 / (x^2 + y^2), with the
  // mean squares y^2 = 25 and x^2 = 18.75.
  const double turning = -rate * 25 / (25 + 18.75);
  test::verified("interpolated node on a face that shears: rotation, error over the rate", "exact")
      .below(std::fabs(nodes.angular_velocity[node].z - turning) / rate, 1e-12);
  EXPECT_NEAR(nodes.velocity[node].y, -2.5 * turning, 1e-12 * rate);
  EXPECT_NEAR(nodes.velocity[node].x, 0, 1e-12 * rate);
}

TEST(Interpolation, ForceOnTheNodeActsOnTheBodyWithItsMoment) {
  const Point at{3, 1, 12};
  for (const bool has_mass : {false, true}) {
    model::Model model = cube_with_node(has_mass ? 1e-3 : 0, has_mass ? 0.01 : 0, at);
    const Index curve = test::add_constant_curve(model, 1);
    const Vec3 force{1e-4, -2e-4, 5e-5};
    model.nodal_loads.push_back(
        {.node = model.interpolations[0].dependent, .force = {force.x, force.y, force.z}, .curve = curve});
    model.control.end_time = 1;
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    const domain::Domain& domain = simulation.domain();
    const double time = domain.clock.time + 0.5 * domain.clock.step;
    const Vec3 arm{at[0], at[1], at[2]};
    const Vec3 moment = time * cross(arm, force);
    test::verified("force on an interpolated node: momentum, error", "exact")
        .below(norm(test::momentum(domain) - time * force) / (time * norm(force)), 1e-10);
    test::verified("force on an interpolated node: moment of momentum, error", "exact")
        .below(norm(test::moment_of_momentum(domain) - moment) / norm(moment), 1e-3);
  }
}

TEST(Interpolation, SharedIndependentNodesFitAllAtOnce) {
  model::Model model = cube_with_node(1e-3, 0.01, {3, 1, 12});
  model::Interpolation second = model.interpolations[0];
  second.id = 2;
  second.dependent = model.nodes.count();
  model.nodes.id.push_back(model.nodes.count() + 1);
  model.nodes.position.push_back({-4, 2, 8});
  model.lumped_masses.push_back({.id = 2, .node = second.dependent, .mass = 3e-3, .inertia = 0.02});
  model.interpolations.push_back(second);
  model.interpolations[0].follows = {true, true, true, false, false, false};
  for (Index node = 0; node < model.nodes.count(); ++node)
    model.initial_velocities.push_back({.node = node,
                                        .velocity = {0.01 * std::sin(7.0 * node), 0.01 * std::cos(5.0 * node),
                                                     0.01 * std::sin(3.0 * node)}});
  model.control.end_time = 0.2;
  timeloop::Simulation simulation(model, test::execution());
  test::Conservation kept;
  test::ImbalanceAfterStart imbalance;
  test::run(simulation, [&](const domain::Domain& now) {
    kept.watch(now);
    imbalance.observe(now);
  });
  EXPECT_LT(kept.momentum_drift, 1e-10);
  EXPECT_LT(kept.turning_drift, 1e-8);
  // One rigid motion moves both: of the middle of the coming step, where the fit is.
  const domain::NodeFields& nodes = simulation.domain().nodes;
  const Index a = nodes.domain_node[model.interpolations[0].dependent];
  const Index b = nodes.domain_node[model.interpolations[1].dependent];
  const auto middle = [&](Index i) {
    return nodes.position[i] + 0.5 * simulation.next_step() * nodes.velocity[i];
  };
  const Vec3 turned = cross(nodes.angular_velocity[b], middle(b) - middle(a));
  EXPECT_LT(norm(nodes.velocity[b] - nodes.velocity[a] - turned), 1e-8);
  test::verified("two interpolated nodes of one face, shaken: imbalance over the energy of the start",
                 "conservation")
      .below(imbalance.largest() / simulation.domain().energy.initial_total, 1e-5);
}

}  // namespace
}  // namespace crumple::interpolation_test
