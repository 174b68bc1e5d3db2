// SPDX-License-Identifier: BSD-3-Clause
//
// Two rings of shells, one through the other, are pulled apart: they must not go through each other. That
// they are linked is checked for itself: the line around the middle of one pierces a surface that the other
// spans an odd number of times, whatever their shapes.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "support/conservation.hpp"
#include "support/shapes.hpp"
#include "support/verified.hpp"

namespace crumple::linked_rings_test {
namespace {

using math::Vec3;

constexpr double radius = 40;
constexpr double width = 10;
constexpr double thickness = 1.5;
constexpr Index around = 48;
constexpr Index across = 4;
constexpr Index nodes_of_ring = around * (across + 1);

/// mm, ms, kg. The first ring lies in the plane of x and y, the second in that of x and z.
model::Model rings(double speed, bool plastic) {
  const model::Material steel = plastic
                                    ? model::Material{.id = 1,
                                                      .title = "steel",
                                                      .density = 7.85e-6,
                                                      .law = model::PlasticKinematic{.youngs_modulus = 210,
                                                                                     .poissons_ratio = 0.3,
                                                                                     .yield_stress = 0.3,
                                                                                     .tangent_modulus = 1,
                                                                                     .isotropic_fraction = 1}}
                                    : test::elastic_steel();
  model::Model model =
      test::one_part(steel, test::shell_section(thickness, 3, model::ShellFormulation::FullyIntegrated));
  test::add_tube(model, 0, around, across, [](double u, double v) {
    const auto [c, s] = test::on_circle(u);
    return test::Point{radius * c, radius * s, width * (v - 0.5)};
  });
  test::add_tube(model, test::add_shell_part(model), around, across, [](double u, double v) {
    const auto [c, s] = test::on_circle(u);
    return test::Point{1.3 * radius + radius * c, width * (v - 0.5), radius * s};
  });
  for (Index i = 0; i < 2 * nodes_of_ring; ++i)
    model.initial_velocities.push_back(
        {.node = i, .velocity = {i < nodes_of_ring ? -speed : speed, 0, 0}, .angular_velocity = {}});
  test::touch_all(model);
  return model;
}

/// Place of a point of the middle line of a ring.
Vec3 middle(const domain::Domain& domain, Index ring, Index i) {
  return domain.nodes
      .position[domain.nodes.domain_node[ring * nodes_of_ring + across / 2 * around + i % around]];
}

/// How often the middle line of the second ring pierces the triangles from the middle of the first one to its
/// line.
int piercings(const domain::Domain& domain) {
  const auto volume = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return dot(b - a, cross(c - a, d - a));
  };
  Vec3 centre;
  for (Index i = 0; i < around; ++i) centre += (1.0 / around) * middle(domain, 0, i);
  int count = 0;
  for (Index i = 0; i < around; ++i)
    for (Index j = 0; j < around; ++j) {
      const Vec3 a = middle(domain, 0, i);
      const Vec3 b = middle(domain, 0, i + 1);
      const Vec3 p = middle(domain, 1, j);
      const Vec3 q = middle(domain, 1, j + 1);
      if ((volume(centre, a, b, p) > 0) == (volume(centre, a, b, q) > 0)) continue;
      const double first = volume(p, q, centre, a);
      const double second = volume(p, q, a, b);
      const double third = volume(p, q, b, centre);
      if ((first > 0) == (second > 0) && (second > 0) == (third > 0)) ++count;
    }
  return count;
}

void expect_linked(bool plastic, double friction) {
  constexpr double speed = 30;
  model::Model model = rings(speed, plastic);
  model.contacts[0].static_friction = model.contacts[0].dynamic_friction = friction;
  model.control.end_time = 2.2;
  timeloop::Simulation simulation(model, test::execution());
  simulation.verify_search_every(10);
  test::Conservation kept;
  Index cuts = 0;
  int parted = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    kept.watch(now);
    if (now.clock.cycle % 100 != 0) return;
    parted += 1 - piercings(now) % 2;
    simulation.inspect_contacts();
    cuts += now.contacts[0].inspection.intersections + now.contacts[0].inspection.nodes_beyond;
  });
  const domain::Domain& domain = simulation.domain();
  const domain::EnergyLedger& energy = domain.energy;
  std::printf(
      "deepest / thickness %.3f; over the energy at first: kinetic %.3f, internal %.3f, contact %.4f, "
      "friction %.4f, "
      "hourglass %.4f; energy error %.1e, momentum %.1e, moment of momentum %.1e\n",
      domain.contacts[0].worst_penetration / thickness, energy.kinetic / energy.initial_total,
      energy.internal / energy.initial_total, energy.contact / energy.initial_total,
      energy.friction / energy.initial_total, energy.hourglass / energy.initial_total, energy.error(),
      kept.momentum_drift, kept.turning_drift);
  EXPECT_EQ(parted, 0);
  EXPECT_EQ(cuts, 0);
  EXPECT_GT(domain.contacts[0].worst_penetration, 0) << "they must have met";
  test::verified(
      std::string("linked rings pulled apart, ") + (plastic ? "plastic" : "elastic") + ": energy error",
      "conservation")
      .below(energy.error(), 3e-4);
  EXPECT_GE(energy.contact, 0);
  EXPECT_LT(kept.momentum_drift, 1e-13);
  EXPECT_LT(kept.turning_drift, 1e-13);
}

TEST(LinkedRings, OfElasticSteelStayLinked) {
  expect_linked(false, 0);
}

/// They become long and thin, and come to rest.
TEST(LinkedRings, OfPlasticSteelWithFrictionStayLinked) {
  expect_linked(true, 0.1);
}

}  // namespace
}  // namespace crumple::linked_rings_test
