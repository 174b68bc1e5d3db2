// SPDX-License-Identifier: BSD-3-Clause
#include "loads/mass_damping.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "domain/build.hpp"
#include "support/meshes.hpp"
#include "support/verified.hpp"

namespace crumple::mass_damping_test {
namespace {

using math::Vec3;

/// More nodes than one piece of a parallel loop has, damped by a curve, each direction by a factor of its
/// own.
model::Model plate() {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.1, 2));
  test::add_grid(model, 0, 40, 40, [](double u, double v) { return test::Point{u, v, 0}; });
  model.curves.push_back({.id = 1, .abscissa = {0, 10}, .ordinate = {2, 12}});
  model.mass_damping =
      model::MassDamping{.curve = 0, .translation = {1, 0.5, 2}, .rotation = {0.25, 3, 0.75}};
  return model;
}

domain::Domain moving(const model::Model& model, int threads) {
  domain::Domain domain = domain::build(model, {});
  domain.execution.threads = threads;
  for (Index i = 0; i < domain.nodes.count(); ++i) {
    domain.nodes.mass[i] = 1 + 0.001 * i;
    domain.nodes.inertia[i] = 0.1 + 0.0001 * i;
    domain.nodes.velocity[i] = {std::sin(i), std::cos(i), 1};
    domain.nodes.angular_velocity[i] = {-1, std::sin(2 * i), std::cos(3 * i)};
  }
  return domain;
}

TEST(MassDamping, ForcesAndMomentsFollowTheCurveAndTheFactors) {
  const model::Model model = plate();
  domain::Domain domain = moving(model, 1);
  loads::MassDamping damping(model, domain);
  domain.clock.time = 3;  // D = 5
  damping.add_forces(domain);
  double worst = 0;
  for (Index i = 0; i < domain.nodes.count(); ++i) {
    const domain::NodeForce& f = domain.nodes.force[i];
    const Vec3& v = domain.nodes.velocity[i];
    const Vec3& w = domain.nodes.angular_velocity[i];
    const double m = -5 * domain.nodes.mass[i];
    const double j = -5 * domain.nodes.inertia[i];
    worst =
        std::fmax(worst, norm(Vec3{f.force[0], f.force[1], f.force[2]} - m * Vec3{v.x, 0.5 * v.y, 2 * v.z}));
    worst = std::fmax(
        worst, norm(Vec3{f.moment[0], f.moment[1], f.moment[2]} - j * Vec3{0.25 * w.x, 3 * w.y, 0.75 * w.z}));
  }
  test::verified("damping of nodes: forces and moments, error", "definition").below(worst, 1e-13);
}

// At constant velocities the work between two times is the mean of D times the power of unit damping.
TEST(MassDamping, TakesTheWorkOfItsForcesTheSameForAnyThreads) {
  const model::Model model = plate();
  double energy[2] = {};
  for (const int threads : {1, 2}) {
    domain::Domain domain = moving(model, threads);
    loads::MassDamping damping(model, domain);
    damping.add_forces(domain);  // at time 0, D = 2
    domain.clock.step = 0.5;
    domain.clock.time = 0.5;  // D = 2.5
    damping.add_forces(domain);
    energy[threads - 1] = domain.energy.damping;
    double power = 0;
    for (Index i = 0; i < domain.nodes.count(); ++i) {
      const Vec3& v = domain.nodes.velocity[i];
      const Vec3& w = domain.nodes.angular_velocity[i];
      power += domain.nodes.mass[i] * (v.x * v.x + 0.5 * v.y * v.y + 2 * v.z * v.z) +
               domain.nodes.inertia[i] * (0.25 * w.x * w.x + 3 * w.y * w.y + 0.75 * w.z * w.z);
    }
    test::verified("damping of nodes: energy taken in a step, relative error", "exact")
        .below(std::fabs(domain.energy.damping / (0.5 * 2.25 * power) - 1), 1e-13);
  }
  EXPECT_EQ(energy[0], energy[1]);
}

}  // namespace
}  // namespace crumple::mass_damping_test
