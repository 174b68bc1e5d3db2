// SPDX-License-Identifier: BSD-3-Clause
//
// A rigid body that nothing acts on. Its energy and angular momentum stay what they are (J.C. Simo, K.K.
// Wong, Int. J. Numer. Meth. Engng 31, 1991, 19-52); a symmetric one precesses at a rate known in closed form
// (L.D. Landau, E.M. Lifshitz, Mechanics, section 33).

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "constraints/rigid_motion.hpp"
#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::rigid_rotation_test {
namespace {

using math::Vec3;

/// A brick of unit density with these sides; nodes at its corners are all its mass. The step is about `step`.
model::Model brick(const Vec3& sides, double step, const Vec3& spin) {
  const double shortest = std::min({sides.x, sides.y, sides.z});
  const double speed = 0.9 * shortest / step;
  model::Model model =
      test::one_solid_part({.id = 1, .title = "", .density = 1, .law = model::Elastic{speed * speed, 0.0}});
  test::add_box(model, 0, 1, 1, 1, [&](double u, double v, double w) {
    return test::Point{sides.x * (u - 0.5), sides.y * (v - 0.5), sides.z * (w - 0.5)};
  });
  test::make_rigid(model, 0);
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    const Vec3 v = cross(spin, Vec3{x[0], x[1], x[2]});
    model.initial_velocities.push_back({.node = i, .velocity = {v.x, v.y, v.z}});
  }
  return model;
}

/// Angular momentum of the masses at the nodes, between two steps: velocities are half a step ahead.
Vec3 nodal_momentum(const domain::Domain& domain, double step) {
  const domain::NodeFields& nodes = domain.nodes;
  Vec3 sum;
  for (Index i = 0; i < nodes.count(); ++i)
    sum += nodes.mass[i] * cross(nodes.position[i] + 0.5 * step * nodes.velocity[i], nodes.velocity[i]);
  return sum;
}

TEST(RigidRotation, AsymmetricBodyKeepsEnergyAndMomentumOverAHundredTurns) {
  // About the axis of the middle moment of inertia, which is unstable: the body tumbles over again and again.
  const double step = 0.02;
  const Vec3 spin{0.02, 1.0, 0.01};
  model::Model model = brick({1, 2, 3}, step, spin);
  model.control.end_time = 100 * 2 * std::numbers::pi;
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  const domain::RigidBody& body = domain.rigid_bodies[0];
  const Vec3 momentum = body.angular_momentum;
  const double energy = body.kinetic_energy;
  double worst_momentum = 0;
  double worst_energy = 0;
  double worst_nodal = 0;
  double smallest = 1;
  test::run(simulation, [&](const domain::Domain&) {
    const math::Matrix3 inertia = constraints::inertia_tensor(body, body.turn);
    worst_momentum =
        test::larger_of(worst_momentum, norm(inertia * body.previous_spin - momentum) / norm(momentum));
    worst_energy = test::larger_of(worst_energy, std::fabs(body.kinetic_energy / energy - 1));
    worst_nodal = test::larger_of(
        worst_nodal, norm(nodal_momentum(domain, simulation.next_step()) - momentum) / norm(momentum));
    const auto& x = domain.nodes.position;
    const Vec3 edge = x[domain.nodes.domain_node[2]] - x[domain.nodes.domain_node[0]];
    smallest = std::min(smallest, edge.y / 2);
  });
  test::verified("rigid body tumbles a hundred turns: angular momentum", "conservation")
      .below(worst_momentum, 1e-11);
  test::verified("rigid body tumbles a hundred turns: energy", "conservation").below(worst_energy, 1e-11);
  EXPECT_LT(smallest, -0.5) << "it has turned over";
  // The middle of a step lies inside of the arc that a node goes along, by the square of half the turn.
  const double turn = domain.clock.step * 1.2;
  EXPECT_LT(worst_nodal, turn * turn);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-11 * energy);
  const auto& x = domain.nodes.position;
  const Index a = domain.nodes.domain_node[0];
  const Index b = domain.nodes.domain_node[7];
  EXPECT_NEAR(norm(x[a] - x[b]), std::sqrt(14.0), 1e-13) << "no drift of the shape";
  RecordProperty("of_the_nodes", test::figure(worst_nodal));
}

/// Largest error of the direction of the axis of a symmetric body over ten turns of its precession.
double precession_error(double step) {
  const Vec3 spin{0.3, 0, 1.0};
  model::Model model = brick({1, 1, 2}, step, spin);
  const double mass = 2;
  const double transverse = mass * (0.25 + 1);  // of eight corners: m (b^2 + c^2) / 4
  const double axial = mass * 0.5;
  const Vec3 momentum{transverse * spin.x, 0, axial * spin.z};
  const double rate = norm(momentum) / transverse;
  model.control.end_time = 10 * 2 * std::numbers::pi / rate;
  timeloop::Simulation simulation(model, test::execution());
  const Vec3 along = normalised(momentum);
  const Vec3 start{0, 0, 1};
  const Vec3 fixed = dot(start, along) * along;
  double worst = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double angle = rate * domain.clock.time;
    const Vec3 exact =
        fixed + std::cos(angle) * (start - fixed) + std::sin(angle) * cross(along, start - fixed);
    const auto& x = domain.nodes.position;
    const auto at = [&](Index node) { return x[domain.nodes.domain_node[node]]; };
    worst = test::larger_of(worst, norm(0.5 * (at(4) - at(0)) - exact));
  });
  return worst;
}

TEST(RigidRotation, SymmetricBodyPrecessesAsInClosedForm) {
  const double coarse = precession_error(0.04);
  const double fine = precession_error(0.02);
  RecordProperty("error_coarse", test::figure(coarse));
  RecordProperty("error_fine", test::figure(fine));
  const char* const source = "Landau and Lifshitz, Mechanics, section 33";
  test::verified("symmetric body precesses ten turns: error of its axis", source).below(fine, 3e-3);
  test::verified("symmetric body precesses: error with twice the step over error (4: second order)", source)
      .near(coarse / fine, 4, 0.05);
}

}  // namespace
}  // namespace crumple::rigid_rotation_test
