// SPDX-License-Identifier: BSD-3-Clause
//
// Plates that meet through single-surface contact. Exact are the conservation laws: momentum to round-off,
// energy (nothing here dissipates), and the thickness that keeps mid-surfaces apart.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::collision_test {
namespace {

using math::Vec3;

constexpr double thickness = 1.0;
constexpr double speed = 5.0;

/// A plate of `cells` x `cells` shells of 5 mm at height z, centred, turned by `angle` about z.
Index add_plate(model::Model& model, Index part, Index cells, double z, double angle) {
  const double side = 5.0 * cells;
  return test::add_grid(model, part, cells, cells, [&](double u, double v) {
    const double x = side * (u - 0.5);
    const double y = side * (v - 0.5);
    return test::Point{x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle),
                       z};
  });
}

model::Model two_parts() {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(thickness, 3));
  model.parts.push_back({.id = 2, .title = "second", .section = 0, .material = 0});
  model.contacts.push_back(model::self_contact(1, "all", {0, 1}));
  return model;
}

Vec3 momentum_of(const domain::Domain& domain, Index first, Index last) {
  Vec3 sum;
  for (Index i = first; i < last; ++i) {
    const Index node = domain.nodes.domain_node[i];
    sum += domain.nodes.mass[node] * domain.nodes.velocity[node];
  }
  return sum;
}

/// What must be kept, followed through a run.
struct Kept {
  Vec3 before;           ///< momentum at the start
  double drift = 0;      ///< largest change of the momentum over itself
  double imbalance = 0;  ///< largest, over the initial energy

  void follow(const domain::Domain& domain) {
    const Vec3 now = test::momentum(domain);
    if (domain.clock.cycle == 0) before = now;
    drift = test::larger_of(drift, norm(now - before) / norm(before));
    imbalance =
        test::larger_of(imbalance, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  }
};

TEST(Collision, TwoPlatesExchangeMomentumAndKeepTheEnergy) {
  model::Model model = two_parts();
  add_plate(model, 0, 6, 0, 0);
  const Index upper = add_plate(model, 1, 6, 1.3, 0.3);
  for (Index i = upper; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i, .velocity = {0, 0, -speed}, .angular_velocity = {}});
  model.control.end_time = 0.3;
  timeloop::Simulation simulation(model, test::execution());
  Kept kept;
  test::run(simulation, [&](const domain::Domain& domain) { kept.follow(domain); });
  const domain::Domain& domain = simulation.domain();
  test::verified("two plates collide: change of the momentum over itself", "conservation")
      .below(kept.drift, 1e-12);
  test::verified("two plates collide: imbalance over the initial energy", "conservation")
      .below(kept.imbalance, 1e-6);
  EXPECT_GT(domain.contacts[0].worst_penetration, 0.0) << "the plates must have touched";
  EXPECT_LT(domain.contacts[0].worst_penetration, 0.9 * thickness) << "no mid-surface is reached";
  EXPECT_EQ(domain.contacts[0].active_pairs, 0) << "the plates have parted";
  // Equal bodies: the momentum goes over, apart from what stays as vibration.
  EXPECT_LT(std::fabs(momentum_of(domain, upper, model.nodes.count()).z), 0.35 * std::fabs(kept.before.z));
}

/// The nodes in the middle of the sides are corners of segments, too: each face is four.
TEST(Collision, BlocksOfTetrahedraWithTenNodesExchangeMomentum) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  model.solid_sections[0].formulation = model::SolidFormulation::QuadraticTetrahedron;
  model.parts.push_back(model.parts[0]);
  model.parts[1].id = 2;
  const auto add_block = [&](Index part, double z, double shift) {
    test::add_box(model, part, 2, 2, 2, [&](double u, double v, double w) {
      return test::Point{10 * u + shift, 10 * v + 0.7 * shift, z + 10 * w};
    });
  };
  add_block(0, 0, 0);
  add_block(1, 10.01, 1.3);
  test::split_into_tetrahedra(model);
  test::add_middle_nodes(model);
  for (Index i = 0; i < model.nodes.count(); ++i)
    if (model.nodes.position[static_cast<std::size_t>(i)][2] > 10.005)
      model.initial_velocities.push_back({.node = i, .velocity = {0, 0, -speed}, .angular_velocity = {}});
  model.contacts.push_back(model::self_contact(1, "all", {0, 1}));
  model.control.end_time = 0.02;
  timeloop::Simulation simulation(model, test::execution());
  Kept kept;
  Index pairs = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    kept.follow(domain);
    pairs = std::max(pairs, domain.contacts[0].active_pairs);
  });
  const domain::Domain& domain = simulation.domain();
  test::verified("two blocks of tetrahedra with ten nodes collide: change of the momentum over itself",
                 "conservation")
      .below(kept.drift, 1e-12);
  test::verified("two blocks of tetrahedra with ten nodes collide: imbalance over the initial energy",
                 "conservation")
      .below(kept.imbalance, 1e-4);
  // Nine corners on each side, and sixteen nodes between them.
  EXPECT_GT(pairs, 18);
  EXPECT_GT(domain.contacts[0].worst_penetration, 0.0);
  EXPECT_LT(domain.contacts[0].worst_penetration, 0.2);
  EXPECT_EQ(domain.contacts[0].active_pairs, 0) << "the blocks have parted";
  double lower = 0;
  for (Index i = 0; i < domain.nodes.count(); ++i)
    if (domain.nodes.reference[i].z < 10.005) lower += domain.nodes.mass[i] * domain.nodes.velocity[i].z;
  std::printf("ten nodes: momentum of the lower block %.4f, pairs %d, imbalance %.2e\n",
              lower / kept.before.z, pairs, kept.imbalance);
  // Equal bodies: the momentum goes over, apart from what stays as vibration and turning.
  EXPECT_GT(lower / kept.before.z, 0.7);
}

TEST(Collision, AngularMomentumIsKeptInAnOffCentreImpact) {
  model::Model model = two_parts();
  add_plate(model, 0, 6, 0, 0);
  const Index upper = add_plate(model, 1, 3, 1.3, 0.5);
  for (Index i = upper; i < model.nodes.count(); ++i) {
    model.nodes.position[i][0] += 7.0;
    model.initial_velocities.push_back({.node = i, .velocity = {1.0, 0, -speed}, .angular_velocity = {}});
  }
  model.control.end_time = 0.3;
  timeloop::Simulation simulation(model, test::execution());
  const auto angular = [](const domain::Domain& domain) {
    Vec3 sum;
    for (Index i = 0; i < domain.nodes.count(); ++i)
      sum += cross(domain.nodes.position[i], domain.nodes.mass[i] * domain.nodes.velocity[i]) +
             domain.nodes.inertia[i] * domain.nodes.angular_velocity[i];
    return sum;
  };
  simulation.start();
  const Vec3 before = angular(simulation.domain());
  while (!simulation.finished()) simulation.step();
  EXPECT_GT(simulation.domain().contacts[0].worst_penetration, 0.0);
  test::verified("two plates collide off centre: change of the angular momentum over itself", "conservation")
      .below(norm(angular(simulation.domain()) - before) / norm(before), 1e-12);
}

TEST(Sliding, APressedPlateGlidesAtTheContactThickness) {
  model::Model model = two_parts();
  const Index lower_nodes = 13 * 13;
  add_plate(model, 0, 12, 0, 0);
  const Index upper = add_plate(model, 1, 4, thickness, 0.2);
  for (Index i = 0; i < lower_nodes; ++i)
    model.fixed_nodes.push_back(
        {.node = i, .translation = {true, true, true}, .rotation = {true, true, true}});
  for (Index i = upper; i < model.nodes.count(); ++i) {
    model.nodes.position[i][0] -= 12.0;
    model.initial_velocities.push_back({.node = i, .velocity = {20.0, 0, 0}, .angular_velocity = {}});
    model.nodal_loads.push_back({.node = i, .force = {0, 0, -2e-3}});
  }
  model.control.end_time = 1.0;
  timeloop::Simulation simulation(model, test::execution());
  double lowest = 2 * thickness;
  test::run(simulation, [&](const domain::Domain& domain) {
    for (Index i = upper; i < model.nodes.count(); ++i)
      lowest = std::min(lowest, domain.nodes.position[domain.nodes.domain_node[i]].z);
  });
  const domain::Domain& domain = simulation.domain();
  const double mass = 400.0 * thickness * 7.85e-6;
  EXPECT_GT(lowest, 0.95 * thickness);
  // No friction: nothing slows it down.
  test::verified("plate glides on a plate: path", "exact")
      .within(test::displacement(domain, upper).x, 20.0, 0.02);
  EXPECT_NEAR(momentum_of(domain, upper, model.nodes.count()).x, 20.0 * mass, 0.01 * 20.0 * mass);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 0.01 * domain.energy.initial_total);
}

}  // namespace
}  // namespace crumple::collision_test
