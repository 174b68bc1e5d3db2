// SPDX-License-Identifier: BSD-3-Clause
// Tied contact by constraint (*CONTACT_TIED without OFFSET): blocks with meshes that do not match behave like
// one, a tied edge of a shell carries a moment, and what must be kept is kept.

#include <gtest/gtest.h>

#include <cmath>

#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/ties.hpp"

namespace crumple {
namespace {

using math::Vec3;

/// Angular momentum about the origin of what moves: the nodes of segments carry the masses of the tied ones.
Vec3 angular_momentum(const domain::Domain& domain) {
  const domain::NodeFields& nodes = domain.nodes;
  Vec3 sum;
  for (Index i = 0; i < nodes.count(); ++i) {
    if (nodes.is_tied(i)) continue;
    sum += nodes.moving_mass(i) * cross(nodes.position[i], nodes.velocity[i]) +
           nodes.moving_inertia(i) * nodes.angular_velocity[i];
  }
  return sum;
}

struct Patch {
  double stress_error = 0;  ///< largest over all elements and components, over the mean stress [-]
  double energy_error = 0;
};

/// Two tied blocks are stretched with the velocities of the exact solution from the start on, v = rate * x,
/// so that there are no waves.
Patch run_patch(Index coarse, Index fine) {
  model::Model model = test::two_blocks(coarse, fine, 4);
  const double rate = 1e-2;  // 1/ms
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    model.initial_velocities.push_back({.node = i, .velocity = {rate * x[0], 0, 0}, .angular_velocity = {}});
    const bool end = x[0] < 1e-9 || x[0] > 20 - 1e-9;
    model::FixedNode fixed{.node = i, .translation = {false, true, true}};
    if (x[0] < 1e-9) fixed.translation[0] = true;
    model.fixed_nodes.push_back(fixed);
    if (end && x[0] > 1) {
      if (model.curves.empty()) test::add_constant_curve(model, 1.0);
      model.prescribed_motions.push_back({.node = i, .axis = 0, .curve = 0, .scale = rate * x[0]});
    }
  }
  model.control.end_time = 0.05;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  // Young's modulus without lateral strain: stress = E * strain, true strain by the rate form.
  const double strain = std::log1p(rate * domain.clock.time);
  Patch patch;
  for (const domain::SolidBlock& block : domain.solids) {
    const domain::StateItem& stress = *block.find("stress");
    for (Index e = 0; e < block.elements; ++e)
      for (Index c = 0; c < stress.count; ++c) {
        const double exact = c % 6 == 0 ? test::modulus * strain : 0;
        patch.stress_error =
            std::max(patch.stress_error,
                     std::fabs(block.state(e, stress.first + c) - exact) / (test::modulus * strain));
      }
  }
  patch.energy_error = domain.energy.error();
  return patch;
}

TEST(Tied, StressIsConstantAcrossMeshesThatDoNotMatch) {
  const Patch nested = run_patch(2, 4);
  const Patch thirds = run_patch(2, 6);
  const Patch same = run_patch(3, 3);
  const Patch other = run_patch(2, 3);
  std::printf("stress error: 1:1 %.1e, 2:1 %.1e, 3:1 %.1e, 3:2 %.3f; energy %.1e %.1e\n", same.stress_error,
              nested.stress_error, thirds.stress_error, other.stress_error, nested.energy_error,
              other.energy_error);
  RecordProperty("nested", test::figure(nested.stress_error));
  RecordProperty("three_to_two", test::figure(other.stress_error));
  EXPECT_LT(same.stress_error, 1e-10);
  EXPECT_LT(nested.stress_error, 1e-10);
  EXPECT_LT(thirds.stress_error, 1e-10);
  EXPECT_LT(other.stress_error, 0.15);
  EXPECT_LT(nested.energy_error, 1e-3);
  EXPECT_LT(other.energy_error, 1e-3);
}

/// A pulse through a bar of two halves: how much of its energy comes back from the joint.
TEST(Tied, WavesPassTheJoint) {
  const auto run = [](Index first, Index second) {
    model::Model model = test::two_bars(first, second);
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    const domain::Domain& domain = simulation.domain();
    // By now the pulse is in the second half; what is left in the first one came back.
    double behind = 0;
    double ahead = 0;
    for (Index i = 0; i < domain.nodes.count(); ++i) {
      const double energy = domain.nodes.mass[i] * dot(domain.nodes.velocity[i], domain.nodes.velocity[i]);
      (domain.nodes.reference[i].x < 100 ? behind : ahead) += energy;
    }
    return std::array<double, 2>{std::sqrt(behind / (ahead + behind)), domain.energy.error()};
  };
  const auto same = run(2, 2);
  const auto refined = run(2, 4);
  const auto odd = run(2, 3);
  std::printf("reflected amplitude: 2:2 %.4f, 2:4 %.4f, 2:3 %.4f; energy error %.1e\n", same[0], refined[0],
              odd[0], odd[1]);
  EXPECT_LT(same[0], 0.005);
  EXPECT_LT(refined[0], 0.005);
  EXPECT_LT(odd[0], 0.01);
  EXPECT_LT(odd[1], 1e-3);
}

TEST(Tied, TurningMakesNoForceAndKeepsMomenta) {
  model::Model model = test::two_blocks(2, 3, 4);
  const double spin = 2.0;  // rad/ms
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    model.initial_velocities.push_back(
        {.node = i, .velocity = {-spin * (x[1] - 2), spin * (x[0] - 10), 0.3}, .angular_velocity = {}});
  }
  model.control.end_time = 2.0;  // 4 rad
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  const domain::Domain& domain = simulation.domain();
  const Vec3 momentum = test::momentum(domain);
  double turned = 0;
  double gap = 0;
  while (!simulation.finished()) {
    simulation.step();
    turned = domain.clock.time * spin;
    for (const domain::TiedNode& tied : domain.ties[0].nodes) {
      Vec3 away = domain.nodes.position[tied.node];
      for (std::size_t k = 0; k < 4; ++k) away -= tied.weight[k] * domain.nodes.position[tied.corner[k]];
      gap = std::max(gap, norm(away));
    }
  }
  std::printf("turned %.2f rad, momentum %.1e, gap %.1e, energy error %.1e, kinetic %.6g of %.6g\n", turned,
              norm(test::momentum(domain) - momentum) / norm(momentum), gap, domain.energy.error(),
              domain.energy.kinetic, domain.energy.initial_total);
  EXPECT_LT(norm(test::momentum(domain) - momentum), 1e-12 * norm(momentum));
  EXPECT_LT(gap, 1e-12);
  EXPECT_NEAR(domain.energy.total(), domain.energy.initial_total, 1e-6 * domain.energy.initial_total);
}

TEST(Tied, MomentOfMomentumIsKept) {
  model::Model model = test::two_blocks(2, 3, 4);
  // Any velocities: the blocks shake and tumble.
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i,
                                        .velocity = {std::sin(1.0 * i), std::sin(2.0 * i), std::sin(3.0 * i)},
                                        .angular_velocity = {}});
  model.control.end_time = 0.1;
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  const domain::Domain& domain = simulation.domain();
  simulation.step();
  // x(n) x v(n+1/2) and x(n+1) x v(n+1/2) are the same: it matters not to which time the places belong.
  const Vec3 before = angular_momentum(domain);
  const Vec3 momentum = test::momentum(domain);
  double energy_error = 0;
  while (!simulation.finished()) {
    simulation.step();
    energy_error = std::max(energy_error, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  }
  const double size = norm(before);
  std::printf("angular momentum %.2e, momentum %.2e, energy %.2e\n",
              norm(angular_momentum(domain) - before) / size,
              norm(test::momentum(domain) - momentum) / norm(momentum), energy_error);
  EXPECT_LT(norm(angular_momentum(domain) - before), 1e-11 * size);
  EXPECT_LT(norm(test::momentum(domain) - momentum), 1e-11 * norm(momentum));
  EXPECT_LT(energy_error, 1e-3);
}

/// A strip on edge, tied to the middle of a plate, against the same in one mesh.
TEST(Tied, EdgeOfShellCarriesItsMoment) {
  const auto deflection = [](bool tied, bool rotations) {
    model::Model model = test::shell_joint(tied, 6);
    if (tied) model.tied_contacts[0].ties_rotations = rotations;
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
  const double one = deflection(false, false);
  const double joined = deflection(true, true);
  const double hinged = deflection(true, false);
  std::printf("largest deflection: one mesh %.5f, tied %.5f, without rotations %.5f\n", one, joined, hinged);
  EXPECT_NEAR(joined, one, 1e-6 * one);
  EXPECT_GT(hinged, 2 * one);
}

}  // namespace
}  // namespace crumple
