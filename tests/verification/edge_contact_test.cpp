// SPDX-License-Identifier: BSD-3-Clause
//
// Thin strips thrown at each other edge on edge, and wires: what no node sees. Exact are momentum (to
// round-off) and energy; candidates are compared with brute force in every cycle, and in the end no
// mid-surface may cut through another.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::edge_contact_test {
namespace {

using math::Vec3;

constexpr double thickness = 1.0;

/// Two gratings of upright strips, one along x and one along y, whose sharp edges meet: 16 crossings,
/// seven of them at nodes.
model::Model gratings(model::ContactEdges edges, double speed, bool plastic) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(thickness, 3));
  if (plastic) {
    model::PlasticKinematic law;
    law.youngs_modulus = 210.0;
    law.poissons_ratio = 0.3;
    law.yield_stress = 0.25;
    law.tangent_modulus = 1.0;
    model.materials[0].law = law;
  }
  model.parts.push_back({.id = 2, .title = "second", .section = 0, .material = 0});
  for (int k = 0; k < 4; ++k)
    test::add_grid(model, 0, 10, 2, [&](double u, double v) {
      return test::Point{50 * u - 25, 10.7 * k - 15, -0.6 - 10 * v};
    });
  const Index upper = model.nodes.count();
  for (int k = 0; k < 4; ++k)
    test::add_grid(model, 1, 10, 2, [&](double u, double v) {
      return test::Point{11.3 * k - 16.3, 50 * u - 25, 0.6 + 10 * v};
    });
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back(
        {.node = i, .velocity = {0, 0, i < upper ? speed : -speed}, .angular_velocity = {}});
  model.contacts.push_back(model::self_contact(1, "all", {0, 1}));
  model.contacts[0].edges = edges;
  model.control.end_time = 0.3;
  return model;
}

TEST(EdgeContact, WithoutItGratingsCutThroughEachOther) {
  const model::Model model = gratings(model::ContactEdges::None, 5.0, false);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  simulation.inspect_contacts();
  EXPECT_GT(simulation.domain().contacts[0].inspection.intersections, 5);
}

TEST(EdgeContact, GratingsBounceEdgeOnEdge) {
  for (const bool plastic : {false, true}) {
    const double speed = plastic ? 10.0 : 5.0;
    const model::Model model = gratings(model::ContactEdges::Free, speed, plastic);
    timeloop::Simulation simulation(model, test::execution());
    simulation.verify_search_every(1);
    double drift = 0;
    double error = 0;
    double stored = 0;
    double least = 0;
    Vec3 before;
    ASSERT_NO_THROW(test::run(simulation, [&](const domain::Domain& domain) {
      const Vec3 now = test::momentum(domain);
      if (domain.clock.cycle == 0) before = now;
      double mass = 0;
      for (const double m : domain.nodes.mass) mass += m;
      drift = test::larger_of(drift, norm(now - before) / (mass * speed));
      error = test::larger_of(error, std::fabs(domain.energy.imbalance()));
      stored = test::larger_of(stored, domain.energy.contact);
      least = std::min(least, domain.energy.contact);
    }));
    simulation.inspect_contacts();
    const domain::Domain& domain = simulation.domain();
    const std::string bounce = std::string(plastic ? "plastic" : "elastic") + " gratings, edge on edge: ";
    test::verified(bounce + "drift of the momentum", "conservation").below(drift, 1e-12);
    test::verified(bounce + "imbalance over the internal energy", "conservation")
        .below(error / domain.energy.internal, 0.01);
    test::verified(bounce + "deepest penetration over the thickness", "mid-surfaces do not meet")
        .below(domain.contacts[0].worst_penetration / thickness, 0.5);
    EXPECT_GT(stored, 0.02 * domain.energy.initial_total);
    // An impact of a few steps gives back a little more or less than it took: -0.7 and -1.7 %.
    EXPECT_GT(least, -0.025 * stored);
    // More often less: 2.6 % is missing after the elastic bounce.
    test::verified(bounce + "energy left in the contact over the largest", "none")
        .below(std::fabs(domain.energy.contact) / stored, 0.03);
    EXPECT_EQ(domain.contacts[0].inspection.intersections, 0);
    EXPECT_GT(domain.contacts[0].worst_penetration, 0.02);
    EXPECT_EQ(domain.contacts[0].active_pairs, 0);
  }
}

}  // namespace
}  // namespace crumple::edge_contact_test
