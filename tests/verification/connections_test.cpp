// SPDX-License-Identifier: BSD-3-Clause
//
// Spot welds, rivets and constrained sets of nodes in whole runs, against equilibrium and closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::connections_test {
namespace {

using math::Vec3;

constexpr double thickness = 1.0;
constexpr double width = 5.0;
constexpr double gap = 1.0;  // between the ends that are welded

struct Strips {
  model::Model model;
  Index left = 0;   ///< first node of the left strip
  Index right = 0;  ///< first node of the right strip
  Index left_end(Index row) const { return left + row * 5 + 4; }
  Index right_begin(Index row) const { return right + row * 5; }
  Index right_end(Index row) const { return right + row * 5 + 4; }
};

/// Two strips of 4 shells in line, the left one held at its left end.
Strips two_strips(const model::Material& material) {
  Strips strips{test::one_part(material, test::shell_section(thickness, 3))};
  strips.left = test::add_grid(strips.model, 0, 4, 1, [](double u, double v) {
    return test::Point{20 * u, width * v, 0};
  });
  strips.right = test::add_grid(strips.model, 0, 4, 1, [](double u, double v) {
    return test::Point{20 + gap + 20 * u, width * v, 0};
  });
  for (Index row = 0; row < 2; ++row)
    strips.model.fixed_nodes.push_back(
        {.node = strips.left + row * 5, .translation = {true, true, true}, .rotation = {true, true, true}});
  return strips;
}

/// Pulls the right end with a force that grows steadily.
void pull(Strips& strips, double force_per_time) {
  strips.model.curves.push_back({.id = 1, .abscissa = {0, 100}, .ordinate = {0, 100 * force_per_time}});
  for (Index row = 0; row < 2; ++row)
    strips.model.nodal_loads.push_back(
        {.node = strips.right_end(row), .force = {0.5, 0, 0}, .moment = {}, .curve = 0});
}

TEST(SpotWeld, BreaksWhenItsPullReachesTheStrength) {
  Strips strips = two_strips(test::elastic_steel());
  constexpr double rate = 2.0;  // kN/ms, over 200 wave passages
  constexpr double strength = 1.0;
  pull(strips, rate);
  for (Index row = 0; row < 2; ++row)
    strips.model.spot_welds.push_back({.id = row + 1,
                                       .nodes = {strips.left_end(row), strips.right_begin(row)},
                                       .normal_strength = strength});
  strips.model.control.end_time = 1.05;
  timeloop::Simulation simulation(strips.model, test::execution());
  double imbalance = 0;
  double slip = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    imbalance = test::larger_of(imbalance, std::fabs(domain.energy.imbalance()));
    for (Index row = 0; row < 2; ++row) {
      if (domain.welds[static_cast<std::size_t>(row)].broken) continue;
      const Vec3 line = Vec3{gap, 0, 0} + test::displacement(domain, strips.right_begin(row)) -
                        test::displacement(domain, strips.left_end(row));
      slip = test::larger_of(slip, std::fabs(norm(line) - gap));
    }
  });
  const domain::Domain& domain = simulation.domain();
  EXPECT_LT(slip, 1e-12) << "as one until it breaks";
  for (const domain::WeldReport& weld : domain.welds) {
    EXPECT_TRUE(weld.broken);
    // Each carries half; the strip rings a little.
    test::verified("strips pulled apart at two spot welds: force at failure over strength", "equilibrium")
        .near(weld.failure_time * rate / 2 / strength, 1, 0.01);
  }
  EXPECT_GT(test::displacement(domain, strips.right_end(0)).x, 0.5) << "the right strip flies away";
  EXPECT_LT(imbalance, 1e-3 * domain.energy.external_work);
}

TEST(SpotWeld, BreaksWhenThePlasticStrainAroundItReachesTheLimit) {
  model::Material steel = test::elastic_steel();
  model::PlasticKinematic law;
  law.youngs_modulus = 210;
  law.poissons_ratio = 0.3;
  law.yield_stress = 0.25;
  law.tangent_modulus = 2.1;
  law.isotropic_fraction = 1;
  steel.law = law;
  Strips strips = two_strips(steel);
  pull(strips, 2.0);
  constexpr double limit = 0.01;
  for (Index row = 0; row < 2; ++row)
    strips.model.spot_welds.push_back(
        {.id = row + 1, .nodes = {strips.left_end(row), strips.right_begin(row)}, .failure_strain = limit});
  strips.model.control.end_time = 1.2;
  timeloop::Simulation simulation(strips.model, test::execution());
  double before = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.welds[0].broken) return;
    const domain::ShellBlock& block = domain.shells[0];
    const domain::StateItem& strain = *block.find("plastic_strain");
    before = 0;
    for (Index place = 0; place < block.elements; ++place) {
      // The shells beside the weld, one of each strip: a node has no other.
      if (block.element[place] != 3 && block.element[place] != 4) continue;
      double mean = 0;
      for (Index point = 0; point < 3; ++point) mean += block.state(place, strain.first + point) / 3;
      before = test::larger_of(before, mean);
    }
  });
  EXPECT_TRUE(simulation.domain().welds[0].broken);
  EXPECT_NEAR(before, limit, 0.02 * limit) << "one step earlier";
}

/// Two masses on a massless link, beside a shell that sets the step.
model::Model dumbbell(double length) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(thickness, 1));
  test::add_grid(model, 0, 1, 1, [](double u, double v) { return test::Point{5 * u, 5 * v, 100}; });
  for (const double x : {0.0, length}) {
    model.nodes.id.push_back(model.nodes.count() + 1);
    model.nodes.position.push_back({x, 0, 0});
  }
  model.lumped_masses.push_back({.id = 1, .node = 4, .mass = 2});
  model.lumped_masses.push_back({.id = 2, .node = 5, .mass = 3});
  model.rivets.push_back({.id = 1, .node = {4, 5}});
  return model;
}

TEST(Rivet, ASpinningPairKeepsItsEnergyMomentaAndLength) {
  constexpr double length = 5;
  model::Model model = dumbbell(length);
  constexpr double spin = 5;
  model.initial_velocities.push_back({.node = 4, .velocity = {1, -3 * spin, 0}, .angular_velocity = {}});
  model.initial_velocities.push_back({.node = 5, .velocity = {1, 2 * spin, 0}, .angular_velocity = {}});
  constexpr double turns = 100;
  model.control.end_time = turns * 2 * std::numbers::pi / spin;
  timeloop::Simulation simulation(model, test::execution());
  double first = 0;
  double energy = 0;
  double stretch = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    // The product of two velocities half a step apart has a share of the turning in it, the same in all
    // steps.
    if (domain.clock.cycle == 1) first = domain.energy.ratio();
    if (domain.clock.cycle > 0) energy = test::larger_of(energy, std::fabs(domain.energy.ratio() - first));
    const domain::NodeFields& nodes = domain.nodes;
    stretch = test::larger_of(
        stretch, std::fabs(norm(nodes.position[nodes.domain_node[5]] - nodes.position[nodes.domain_node[4]]) -
                           length));
  });
  const domain::NodeFields& nodes = simulation.domain().nodes;
  EXPECT_NEAR(first, 1, 1e-5);
  test::verified("riveted pair spins a hundred turns: change of the energy ratio", "conservation")
      .below(energy, 1e-10);
  test::verified("riveted pair spins a hundred turns: length", "exact").below(stretch, 1e-11);
  EXPECT_NEAR(test::momentum(simulation.domain()).x, 5, 1e-10);
  // The centre has moved on, the pair lies as at the start but for the end of the last step. The angle is off
  // by the square of the turn in a step.
  const Vec3 line = nodes.position[nodes.domain_node[5]] - nodes.position[nodes.domain_node[4]];
  const double beyond = spin * (simulation.domain().clock.time - model.control.end_time);
  EXPECT_NEAR(std::atan2(line.y, line.x), beyond, 4e-3);
}

TEST(Rivet, APendulumHasThePeriodOfTheEllipticIntegral) {
  constexpr double length = 5;
  model::Model model = dumbbell(length);
  model.fixed_nodes.push_back({.node = 4, .translation = {true, true, true}, .rotation = {}});
  // Hangs along -y and starts horizontally: its weight is a nodal load.
  constexpr double gravity = 50;
  model.nodal_loads.push_back({.node = 5, .force = {0, -3 * gravity, 0}, .moment = {}, .curve = no_index});
  model.control.end_time = 10;
  timeloop::Simulation simulation(model, test::execution());
  double half_period = 0;
  double previous = -1;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double velocity = domain.nodes.velocity[domain.nodes.domain_node[5]].x;
    if (domain.clock.time > 0.5 && previous < 0 && velocity >= 0 && half_period == 0)
      half_period = domain.clock.time;
    previous = velocity;
  });
  // 2 K(sin 45 degrees) sqrt(L / g), K by the arithmetic-geometric mean.
  double a = 1;
  double g = std::sqrt(0.5);
  for (int i = 0; i < 6; ++i) {
    const double mean = 0.5 * (a + g);
    g = std::sqrt(a * g);
    a = mean;
  }
  const double exact = 2 * std::numbers::pi / (2 * a) * std::sqrt(length / gravity);
  test::verified("pendulum on a rivet, 90 degrees: half a period over exact", "elliptic integral")
      .near(half_period / exact, 1, 2e-3);
  EXPECT_LT(std::fabs(simulation.domain().energy.imbalance()), 1e-4 * 3 * gravity * length);
}

TEST(NodeSet, JoinsTwoStripsLikeAHinge) {
  Strips strips = two_strips(test::elastic_steel());
  pull(strips, 2.0);
  for (Index row = 0; row < 2; ++row)
    strips.model.constrained_node_sets.push_back(
        {.nodes = {strips.left_end(row), strips.right_begin(row)}, .direction = {true, true, true}});
  strips.model.control.end_time = 0.5;
  timeloop::Simulation simulation(strips.model, test::execution());
  double slip = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    for (Index row = 0; row < 2; ++row)
      slip = test::larger_of(slip, norm(test::displacement(domain, strips.right_begin(row)) -
                                        test::displacement(domain, strips.left_end(row))));
  });
  const domain::Domain& domain = simulation.domain();
  EXPECT_LT(slip, 1e-12);
  // Elongation of 40 mm by 1 kN on 5 mm^2, the end held across too: between plane stress and plane strain.
  const double free = 1.0 / (width * thickness) / 210 * 40;
  EXPECT_NEAR(test::displacement(domain, strips.right_end(0)).x, free, 0.03 * free);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-3 * domain.energy.external_work);
}

}  // namespace
}  // namespace crumple::connections_test
