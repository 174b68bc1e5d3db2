// SPDX-License-Identifier: BSD-3-Clause
//
// A free plate spinning fast, in the plane and out of it: nothing acts on it, so momentum and angular
// momentum stay what they are, and so does the sum of kinetic and strain energy.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::spinning_plate_test {
namespace {

using math::Vec3;

constexpr double spin = 20.0;  // [1/ms]; the rim strains by about 1e-5 of centrifugal stress

math::Vec3 angular_momentum(const domain::Domain& domain) {
  Vec3 sum;
  for (Index i = 0; i < domain.nodes.count(); ++i)
    sum += cross(domain.nodes.position[i], domain.nodes.mass[i] * domain.nodes.velocity[i]) +
           domain.nodes.inertia[i] * domain.nodes.angular_velocity[i];
  return sum;
}

struct Case {
  const char* name;
  model::ShellFormulation formulation;
  std::array<double, 3> axis;
};

model::Model plate(const Case& which) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1.0, 3, which.formulation));
  test::add_grid(model, 0, 4, 4, [](double u, double v) { return test::Point{10 * u - 5, 10 * v - 5, 0}; });
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    const Vec3 omega{spin * which.axis[0], spin * which.axis[1], spin * which.axis[2]};
    const Vec3 v = cross(omega, Vec3{x[0], x[1], x[2]});
    model.initial_velocities.push_back(
        {.node = i, .velocity = {v.x, v.y, v.z}, .angular_velocity = {omega.x, omega.y, omega.z}});
  }
  model.control.end_time = 10 * 2 * std::numbers::pi / spin;  // ten turns
  return model;
}

class SpinningPlate : public ::testing::TestWithParam<Case> {};

TEST_P(SpinningPlate, KeepsEnergyAndAngularMomentum) {
  const model::Model model = plate(GetParam());
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  const Vec3 start = angular_momentum(simulation.domain());
  while (!simulation.finished()) simulation.step();
  const domain::Domain& domain = simulation.domain();
  test::verified("spinning plate, ten turns: change of the angular momentum over itself", "conservation")
      .below(norm(angular_momentum(domain) - start) / norm(start), 1e-12);
  EXPECT_LT(norm(test::momentum(domain)), 1e-10 * norm(start));
  // Forces act on the geometry at the ends of a step, strains are those of its middle: the two works differ
  // by 1/4 dt^2 (change of stress) : L^T L, which is bounded by the square of the turn in one step and does
  // not add up.
  const double turn = spin * domain.clock.step;
  EXPECT_LT(std::fabs(domain.energy.imbalance()), turn * turn * domain.energy.initial_total);
  // Strain energy of the centrifugal stress only: of the order (rho spin^2 r^2)^2 / 2E, far below kinetic.
  EXPECT_LT(domain.energy.internal + domain.energy.hourglass, 1e-3 * domain.energy.kinetic);
}

INSTANTIATE_TEST_SUITE_P(
    All, SpinningPlate,
    ::testing::Values(Case{"BelytschkoTsayInPlane", model::ShellFormulation::BelytschkoTsay, {0, 0, 1}},
                      Case{"BelytschkoTsayTumbling", model::ShellFormulation::BelytschkoTsay, {1, 0, 0}},
                      Case{"HughesLiuInPlane", model::ShellFormulation::HughesLiu, {0, 0, 1}},
                      Case{"HughesLiuTumbling", model::ShellFormulation::HughesLiu, {1, 0, 0}}),
    [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace crumple::spinning_plate_test
