// SPDX-License-Identifier: BSD-3-Clause
//
// A long elastic bar (nu = 0) runs with velocity v onto a rigid wall. Exact solution of the one-dimensional
// wave equation (e.g. K.F. Graff, Wave Motion in Elastic Solids, 1975, section 2.4): a front of stress rho c
// v runs from the wall with c = sqrt(E / rho), is reflected at the free end, and the bar leaves the wall with
// velocity -v at time 2 L / c.

#include <gtest/gtest.h>

#include <cmath>

#include "support/drawn.hpp"
#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::bar_wave_test {
namespace {

constexpr double length = 100.0;
constexpr double width = 2.0;
constexpr double thickness = 1.0;
constexpr double young = 210.0;
constexpr double density = 7.85e-6;
constexpr double velocity = 0.01;

model::Model bar(Index elements, model::ShellFormulation formulation) {
  model::Model model =
      test::one_part({.id = 1, .title = "bar", .density = density, .law = model::Elastic{young, 0.0}},
                     test::shell_section(thickness, 2, formulation));
  test::add_grid(model, 0, elements, 1, [](double u, double v) {
    return test::Point{u * length, v * width, 0};
  });
  model::RigidWall wall;
  wall.normal = {1, 0, 0};
  for (Index i = 0; i < model.nodes.count(); ++i) {
    model.initial_velocities.push_back({.node = i, .velocity = {-velocity, 0, 0}, .angular_velocity = {}});
    wall.nodes.push_back(i);
  }
  model.rigid_walls.push_back(wall);
  return model;
}

constexpr const char* wave = "wave equation, exact";

double wave_speed() {
  return std::sqrt(young / density);
}

/// The displacement along the bar when the front is half-way.
struct Profile {
  double error = 0;  ///< greatest, over the displacement of the free end
  test::Points exact;
  test::Points found;
};

Profile profile_of(Index elements, model::ShellFormulation formulation) {
  model::Model model = bar(elements, formulation);
  const double c = wave_speed();
  model.control.end_time = 0.5 * length / c;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double time = domain.clock.time;
  Profile profile;
  for (Index i = 0; i <= elements; ++i) {
    const double x = length * i / elements;
    const double exact = x < c * time ? -velocity * x / c : -velocity * time;
    const double found = test::displacement(domain, i).x;
    profile.error = test::larger_of(profile.error, std::fabs(found - exact) / (velocity * time));
    profile.exact.push_back({x, 1e3 * exact});
    profile.found.push_back({x, 1e3 * found});
  }
  return profile;
}

class BarWave : public ::testing::TestWithParam<model::ShellFormulation> {};

TEST_P(BarWave, FrontConvergesToTheExactKink) {
  const Profile few = profile_of(50, GetParam());
  const double coarse = few.error;
  const double fine = profile_of(400, GetParam()).error;
  // The dispersion of a second-order scheme (third derivative) spreads a kink over a width that shrinks with
  // the power 2/3 of the mesh size (R.C.Y. Chin, J. Comput. Phys. 18, 1975), and with it the error of
  // displacement.
  const double rate = std::log(coarse / fine) / std::log(8.0);
  RecordProperty("rate", std::to_string(rate));
  test::verified("bar onto a wall, front with 50 elements: error over the free end's way", wave)
      .below(coarse, 0.01);
  EXPECT_GT(rate, 0.62);
  if (GetParam() != model::ShellFormulation::BelytschkoTsay) return;
  test::drawn("Bar onto a wall, the front half-way", "place along the bar [mm]", "displacement [micrometre]")
      .accepted("wave equation", few.exact)
      .found("50 elements", few.found)
      .note();
}

TEST_P(BarWave, BarReboundsWithItsVelocityAfterTwoTransits) {
  model::Model model = bar(200, GetParam());
  const double c = wave_speed();
  model.control.end_time = 3 * length / c;
  timeloop::Simulation simulation(model, test::execution());
  double last_touch = 0;
  double force_sum = 0;
  double samples = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.walls[0].normal_force > 0.1 * density * c * velocity * width * thickness)
      last_touch = domain.clock.time;
    if (domain.clock.time > 0.3 * length / c && domain.clock.time < 1.7 * length / c) {
      force_sum += domain.walls[0].normal_force;
      samples += 1;
    }
  });
  test::verified("bar onto a wall: time of contact", wave).within(last_touch, 2 * length / c, 0.02);
  test::verified("bar onto a wall: force", wave)
      .within(force_sum / samples, density * c * velocity * width * thickness, 0.01);
  const double mass = density * length * width * thickness;
  test::verified("bar onto a wall: momentum after the rebound", wave)
      .within(test::momentum(simulation.domain()).x, mass * velocity, 0.01);
}

TEST_P(BarWave, WallImpulseIsTheChangeOfMomentumToRoundOff) {
  model::Model model = bar(50, GetParam());
  model.control.end_time = 3 * length / wave_speed();
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const double mass = density * length * width * thickness;
  const double change = test::momentum(simulation.domain()).x + mass * velocity;
  test::verified("bar onto a wall: impulse of the wall less change of momentum, over m v", "conservation")
      .near((-simulation.domain().walls[0].impulse.x - change) / (mass * velocity), 0, 1e-12);
}

TEST_P(BarWave, EnergyBalances) {
  model::Model model = bar(100, GetParam());
  model.control.end_time = 3 * length / wave_speed();
  timeloop::Simulation simulation(model, test::execution());
  double worst = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    worst = test::larger_of(worst, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  });
  EXPECT_LT(worst, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(BothShells, BarWave,
                         ::testing::Values(model::ShellFormulation::BelytschkoTsay,
                                           model::ShellFormulation::HughesLiu),
                         [](const auto& which) {
                           return which.param == model::ShellFormulation::HughesLiu ? "HughesLiu"
                                                                                    : "BelytschkoTsay";
                         });

}  // namespace
}  // namespace crumple::bar_wave_test
