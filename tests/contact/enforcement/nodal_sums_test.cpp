// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/nodal_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "contact/bodies.hpp"
#include "contact/tolerances.hpp"

namespace crumple::nodal_sums_test {
namespace {

using contact::NodalSums;
using contact::Touch;
using test::Bodies;
using test::Vec3;

/// A sheet of 21 x 21 nodes that have velocities.
struct Sheet {
  Sheet() : bodies(0.1) {
    bodies.sheet(20, 20, [](double u, double v) { return Vec3{20 * u, 20 * v, 0}; });
  }
  domain::Domain build(int threads) const {
    domain::Domain made = bodies.build(1.0, threads);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> draw(-1, 1);
    for (Vec3& v : made.nodes.velocity) v = {draw(random), draw(random), draw(random)};
    made.clock.step = 1e-3;
    return made;
  }
  Bodies bodies;
};

Vec3 draw_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> draw(-1, 1);
  return {draw(random), draw(random), draw(random)};
}

/// A node and a segment anywhere, most of them near the beginning, with forces of random size; some touch
/// nothing.
std::vector<Touch> draw_touches(std::mt19937& random, Index places, int count) {
  std::uniform_real_distribution<double> draw(0, 1);
  std::vector<Touch> touches(static_cast<std::size_t>(count));
  for (Touch& touch : touches) {
    const auto first = static_cast<Index>(std::pow(draw(random), 3) * (places - 5));
    touch.add(first, 1);
    for (Index k = 1; k <= 4; ++k) touch.add(first + k, -0.25);
    if (draw(random) < 0.2) continue;
    touch.penetration = draw(random);
    touch.normal = draw_vector(random);
    touch.damping = draw(random);
    // Damping may take the whole force of the spring.
    if (draw(random) < 0.2) continue;
    touch.normal_force = draw_vector(random);
    if (draw(random) < 0.5) touch.friction = draw_vector(random);
    for (Vec3& force : touch.couple) force = draw_vector(random);
  }
  return touches;
}

/// What two steps with drawn touches leave.
struct Outcome {
  std::vector<double> force;
  std::vector<double> contact_force;
  std::vector<double> weight;    ///< that was counted, in the last step
  std::vector<double> energies;  ///< of the normal forces, of friction and of damping
};

Outcome two_steps(int threads, bool is_counted) {
  const Sheet sheet;
  domain::Domain made = sheet.build(threads);
  const contact::Surface surface = contact::build_surface(sheet.bodies.model, made, sheet.bodies.contact);
  NodalSums sums(surface, true);
  std::mt19937 random(7);
  Outcome out;
  for (int step = 0; step < 2; ++step) {
    const std::vector<Touch> touches = draw_touches(random, surface.node_count(), 2000);
    sums.clear(made);
    if (is_counted) sums.count(made, touches);
    out.weight.assign(made.contact_weight.begin(), made.contact_weight.end());
    sums.add(made, touches, made.contacts[0]);
    for (const double left : made.contact_weight) EXPECT_EQ(left, 0);
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (Index node = 0; node < made.nodes.count(); ++node)
      out.force.push_back(made.nodes.force[node].force[axis]);
    for (const Vec3& force : made.contact_force) out.contact_force.push_back(force[axis]);
  }
  const domain::ContactReport& report = made.contacts[0];
  out.energies = {report.energy, report.friction_energy, report.damping_energy};
  return out;
}

TEST(NodalSums, HaveTheSameBitsForAnyNumberOfThreads) {
  for (const bool is_counted : {true, false}) {
    const Outcome alone = two_steps(1, is_counted);
    for (const double energy : alone.energies) EXPECT_NE(energy, 0);
    for (const int threads : {2, 3, 7, 64}) {
      const Outcome dealt = two_steps(threads, is_counted);
      EXPECT_EQ(dealt.force, alone.force) << threads << " threads";
      EXPECT_EQ(dealt.contact_force, alone.contact_force) << threads << " threads";
      EXPECT_EQ(dealt.weight, alone.weight) << threads << " threads";
      EXPECT_EQ(dealt.energies, alone.energies) << threads << " threads";
    }
  }
}

TEST(NodalSums, AreThoseOfTheTouches) {
  const Sheet sheet;
  domain::Domain made = sheet.build(3);
  const contact::Surface surface = contact::build_surface(sheet.bodies.model, made, sheet.bodies.contact);
  NodalSums sums(surface, true);
  std::mt19937 random(7);
  std::vector<Touch> touches = draw_touches(random, surface.node_count(), 2000);
  std::vector<Vec3> expected(made.contact_force.size());
  std::vector<double> weight(made.contact_weight.size());
  Vec3 couples;
  for (const Touch& touch : touches) {
    if (touch.penetration <= 0) continue;
    for (int k = 0; k < touch.nodes; ++k) {
      const Index node = surface.nodes[touch.place[k]];
      expected[node] += touch.weight[k] * touch.force();
      if (k > 0) expected[node] += touch.couple[k - 1];
      if (k > 0) couples += touch.couple[k - 1];
      weight[node] += std::fabs(touch.weight[k]) + contact::tolerances::borrowed_mass;
    }
  }
  sums.count(made, touches);
  for (Index i = 0; i < made.nodes.count(); ++i) EXPECT_NEAR(made.contact_weight[i], weight[i], 1e-10);
  sums.add(made, touches, made.contacts[0]);
  double damping = 0;
  for (const Touch& touch : touches)
    for (int k = 0; k < touch.nodes; ++k)
      damping += touch.weight[k] * touch.damping *
                 dot(touch.normal, made.nodes.velocity[surface.nodes[touch.place[k]]]);
  EXPECT_NEAR(made.contacts[0].damping_energy, -0.5 * made.clock.step * damping, 1e-12 * 2000);
  Vec3 total;
  double power = 0;
  for (Index i = 0; i < made.nodes.count(); ++i) {
    EXPECT_NEAR(norm(made.contact_force[i] - expected[i]), 0, 1e-10);
    total += made.contact_force[i];
    power += dot(expected[i], made.nodes.velocity[i]);
  }
  // Weights sum up to nothing, couples here do not.
  EXPECT_NEAR(norm(total - couples), 0, 1e-9);
  EXPECT_NEAR(made.contacts[0].energy + made.contacts[0].friction_energy, -0.5 * made.clock.step * power,
              1e-12 * 2000);
}

TEST(NodalSums, ClearTakesOutWhatOtherContactsMayThenSet) {
  const Sheet sheet;
  domain::Domain made = sheet.build(2);
  const contact::Surface surface = contact::build_surface(sheet.bodies.model, made, sheet.bodies.contact);
  NodalSums first(surface, false);
  NodalSums second(surface, false);
  std::mt19937 random(7);
  const std::vector<Touch> touches = draw_touches(random, surface.node_count(), 300);
  first.add(made, touches, made.contacts[0]);
  second.add(made, touches, made.contacts[0]);
  EXPECT_FALSE(first.places().empty());
  first.clear(made);
  second.clear(made);
  for (const Vec3& force : made.contact_force) EXPECT_EQ(norm(force), 0);
}

}  // namespace
}  // namespace crumple::nodal_sums_test
