// SPDX-License-Identifier: BSD-3-Clause
// Tied contact by constraint (*CONTACT_TIED without OFFSET): blocks with meshes that do not match behave like
// one, a tied edge of a shell carries a moment, and what must be kept is kept.

#include <gtest/gtest.h>

#include <cmath>

#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/tied_runs.hpp"
#include "support/verified.hpp"

namespace crumple::tied_test {
namespace {

using math::Vec3;

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
            test::larger_of(patch.stress_error,
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
  const auto error = [](const char* meshes) {
    return test::verified(
        std::string("two tied blocks stretched, meshes ") + meshes + ": error of the stress", "exact");
  };
  error("1 to 1").below(same.stress_error, 1e-10);
  error("2 to 1").below(nested.stress_error, 1e-10);
  error("3 to 1").below(thirds.stress_error, 1e-10);
  error("3 to 2").below(other.stress_error, 0.15);
  EXPECT_LT(nested.energy_error, 1e-3);
  EXPECT_LT(other.energy_error, 1e-3);
}

/// A pulse through a bar of two halves: how much of it comes back from the joint.
TEST(Tied, WavesPassTheJoint) {
  const test::Reflection same = test::reflection(test::two_bars(2, 2));
  const test::Reflection refined = test::reflection(test::two_bars(2, 4));
  const test::Reflection odd = test::reflection(test::two_bars(2, 3));
  std::printf("reflected amplitude: 2:2 %.4f, 2:4 %.4f, 2:3 %.4f; energy error %.1e\n", same.amplitude,
              refined.amplitude, odd.amplitude, odd.energy_error);
  const auto reflected = [](const char* meshes) {
    return test::verified(
        std::string("pulse through two tied bars, meshes ") + meshes + ": reflected amplitude", "none");
  };
  reflected("2 to 2").below(same.amplitude, 0.005);
  reflected("2 to 4").below(refined.amplitude, 0.005);
  reflected("2 to 3").below(odd.amplitude, 0.01);
  EXPECT_LT(odd.energy_error, 1e-3);
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
      gap = test::larger_of(gap, norm(away));
    }
  }
  std::printf("turned %.2f rad, momentum %.1e, gap %.1e, energy error %.1e, kinetic %.6g of %.6g\n", turned,
              norm(test::momentum(domain) - momentum) / norm(momentum), gap, domain.energy.error(),
              domain.energy.kinetic, domain.energy.initial_total);
  EXPECT_NEAR(domain.energy.kinetic, domain.energy.initial_total, 1e-4 * domain.energy.initial_total)
      << "it turns freely";
  EXPECT_LT(norm(test::momentum(domain) - momentum), 1e-12 * norm(momentum));
  EXPECT_LT(gap, 1e-12);
  EXPECT_NEAR(domain.energy.total(), domain.energy.initial_total, 1e-6 * domain.energy.initial_total);
}

TEST(Tied, MomentaAndEnergyAreKept) {
  test::expect_kept_when_shaken(test::two_blocks(2, 3, 4));
}

/// A strip on edge, tied to the middle of a plate, against the same in one mesh.
TEST(Tied, EdgeOfShellCarriesItsMoment) {
  const test::Deflection one = test::deflection(test::shell_joint(false, 6));
  const test::Deflection joined = test::deflection(test::shell_joint(true, 6));
  model::Model model = test::shell_joint(true, 6);
  model.tied_contacts[0].ties_rotations = false;
  const test::Deflection hinged = test::deflection(model);
  std::printf("largest deflection: one mesh %.5f, tied %.5f, without rotations %.5f; energy error %.1e\n",
              one.largest, joined.largest, hinged.largest, hinged.energy_error);
  EXPECT_NEAR(joined.largest, one.largest, 1e-6 * one.largest);
  EXPECT_GT(hinged.largest, 2 * one.largest);
  for (const test::Deflection& found : {one, joined, hinged}) EXPECT_LT(found.energy_error, 0.01);
}

}  // namespace
}  // namespace crumple::tied_test
