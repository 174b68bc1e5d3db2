// SPDX-License-Identifier: BSD-3-Clause
//
// Bars inside solids (*CONSTRAINED_BEAM_IN_SOLID): the strain of the block, stiffness and density of the
// composite, bending by the transformed section, what is conserved, the stable step, erosion.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "support/conservation.hpp"
#include "support/imbalance.hpp"
#include "support/reinforced.hpp"
#include "support/verified.hpp"

namespace crumple::embedded_beams_test {
namespace {

using math::Vec3;
using test::Point;
using test::ReinforcedBlock;

constexpr double steel_modulus = 210;
constexpr double steel_density = 7.85e-6;
constexpr double concrete_modulus = 30;
constexpr double concrete_density = 2.4e-6;

/// Moves the inner nodes of the block about, so that no solid is a box.
void distort(ReinforcedBlock& block, double amount) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-amount, amount);
  for (Point& x : block.model.nodes.position)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double move = shift(random);
      bool inside = true;
      for (std::size_t other = 0; other < 3; ++other)
        inside = inside && x[other] > 1e-9 && x[other] < block.size[other] - 1e-9;
      if (inside) x[axis] += move;
    }
}

/// Stretches, turns and shears the block as a whole, by prescribed motion of all its nodes.
Vec3 homogeneous(const Point& x) {
  return {0.02 * x[0] + 0.03 * x[1] - 0.01 * x[2], -0.01 * x[0] + 0.015 * x[1] + 0.02 * x[2],
          0.025 * x[0] - 0.02 * x[1] - 0.03 * x[2]};
}

TEST(EmbeddedBeams, HaveTheStrainOfTheBlock) {
  for (const bool tetrahedra : {false, true}) {
    ReinforcedBlock block({3, 3, 3}, {30, 30, 30}, 10);
    distort(block, 2);
    if (tetrahedra) {
      test::split_into_tetrahedra(block.model);
      block.model.solid_sections[0].formulation = model::SolidFormulation::Tetrahedron;
      block.model.embedded_beams[0].solids.clear();
      for (Index i = 0; i < static_cast<Index>(block.model.solids.size()); ++i)
        block.model.embedded_beams[0].solids.push_back(i);
    }
    const Index solid_nodes = block.model.nodes.count();
    block.add_bar(7, {1, 2, 3}, {28, 25, 29});
    block.add_bar(5, {0, 15, 15}, {30, 15, 15});
    model::Model& model = block.model;
    model.curves.push_back({.id = 1, .abscissa = {0, 10}, .ordinate = {1, 1}});
    for (Index node = 0; node < solid_nodes; ++node) {
      const Vec3 v = homogeneous(model.nodes.position[node]);
      for (int axis = 0; axis < 3; ++axis)
        model.prescribed_motions.push_back({.node = node, .axis = axis, .curve = 0, .scale = v[axis]});
    }
    block.set_velocities(homogeneous);
    model.control.end_time = 0.02;
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    const domain::Domain& domain = simulation.domain();
    EXPECT_EQ(domain.embeddings[0].nodes.size(), 14U);
    double error = 0;
    double moved = 0;
    for (Index node = solid_nodes; node < model.nodes.count(); ++node) {
      const Vec3 wanted = domain.clock.time * homogeneous(model.nodes.position[node]);
      error = std::max(error, norm(test::displacement(domain, node) - wanted));
      moved = std::max(moved, norm(wanted));
    }
    test::verified(std::string("bars in a distorted block of ") + (tetrahedra ? "tetrahedra" : "hexahedra") +
                       " under homogeneous strain: place of their nodes, error over the displacement",
                   "exact")
        .below(error / moved, 1e-11);
  }
}

/// What a bar of concrete with bars of steel in it has together.
struct Composite {
  double stiffness = 0;  ///< E A [force]
  double mass = 0;       ///< per length
};

Composite composite(double concrete_area, double steel_area) {
  return {concrete_modulus * concrete_area + steel_modulus * steel_area,
          concrete_density * concrete_area + steel_density * steel_area};
}

/// When the tip of the model stands still for the first time [time].
double first_rest(const model::Model& model, Index tip, int axis) {
  timeloop::Simulation simulation(model, test::execution());
  double rest = 0;
  double velocity_before = 0;
  double time_before = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double velocity = domain.nodes.velocity[domain.nodes.domain_node[tip]][axis];
    const double time = domain.clock.time + 0.5 * simulation.next_step();
    if (rest == 0 && velocity_before > 0 && velocity <= 0)
      rest = time_before + (time - time_before) * velocity_before / (velocity_before - velocity);
    velocity_before = velocity;
    time_before = time;
  });
  return rest;
}

// A rod that is held at one end and swings in its first mode stops after L/c: the speed of waves in it.
TEST(EmbeddedBeams, WavesHaveTheSpeedOfTheComposite) {
  const double length = 200;
  ReinforcedBlock block({20, 2, 2}, {length, 20, 20}, 20);
  const Index tip = 20;
  // The elements of the bars are not those of the block, and one of the bars is in no middle.
  block.add_bar(31, {0, 10, 10}, {length, 10, 10});
  block.add_bar(27, {0, 4, 7}, {length, 4, 7});
  block.add_bar(27, {0, 16, 13}, {length, 16, 13});
  model::Model& model = block.model;
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const bool root = model.nodes.position[node][0] < 1e-9;
    model.fixed_nodes.push_back({.node = node, .translation = {root, true, true}, .rotation = {}});
  }
  block.set_velocities([&](const Point& x) {
    return Vec3{1e-3 * std::sin(0.5 * std::numbers::pi * x[0] / length), 0, 0};
  });
  const Composite both = composite(400, 60);
  const double expected = length / std::sqrt(both.stiffness / both.mass);
  model.control.end_time = 1.1 * expected;
  test::verified("reinforced rod: speed of waves", "sqrt of the sums of E A over those of rho A")
      .within(length / first_rest(model, tip, 0), length / expected, 2e-3);
}

// The energy of a small strain is that of the springs of concrete and steel side by side.
TEST(EmbeddedBeams, StiffnessIsThatOfTheComposite) {
  const double length = 50;
  ReinforcedBlock block({5, 2, 2}, {length, 20, 20}, 20);
  block.add_bar(7, {0, 4, 7}, {length, 4, 7});
  block.add_bar(6, {0, 16, 13}, {length, 16, 13});
  model::Model& model = block.model;
  const double rate = 1e-4;
  model.curves.push_back({.id = 1, .abscissa = {0, 10}, .ordinate = {1, 1}});
  for (Index node = 0; node < 6 * 9; ++node)
    for (int axis = 0; axis < 3; ++axis)
      model.prescribed_motions.push_back({.node = node,
                                          .axis = axis,
                                          .curve = 0,
                                          .scale = axis == 0 ? rate * model.nodes.position[node][0] : 0});
  block.set_velocities([&](const Point& x) { return Vec3{rate * x[0], 0, 0}; });
  model.control.end_time = 0.1;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double strain = rate * domain.clock.time;
  test::verified("reinforced rod: E A by its energy", "sum of E A")
      .within(2 * domain.energy.internal / (strain * strain * length), composite(400, 40).stiffness, 2e-5);
}

// The first mode of a cantilever with bars on one side. Bending stiffness by the transformed section (J.M.
// Gere, Mechanics of Materials, section 6.3): about the axis through the centre of E A, which moves towards
// the bars. A run without bars takes out what the mesh is wrong by.
TEST(EmbeddedBeams, BendingIsThatOfTheTransformedSection) {
  const double length = 200;
  const double height = 20;
  const double offset = 6.5;  // of the bars from the middle
  const double bars = 30;     // area
  const auto quarter = [&](bool reinforced) {
    ReinforcedBlock block({40, 1, 6}, {length, 10, height}, bars / 2);
    if (!reinforced) block.model.embedded_beams.clear();
    for (const double y : {2.5, 7.5})
      if (reinforced) block.add_bar(40, {0, y, height / 2 + offset}, {length, y, height / 2 + offset});
    model::Model& model = block.model;
    for (Index node = 0; node < model.nodes.count(); ++node) {
      const bool root = model.nodes.position[node][0] < 1e-9;
      model.fixed_nodes.push_back({.node = node, .translation = {root, true, root}, .rotation = {}});
    }
    block.set_velocities([&](const Point& x) {
      // The first mode of a slender cantilever, W. Weaver, S.P. Timoshenko & D.H. Young, Vibration Problems
      // in Engineering, section 5.11.
      const double k = 1.8751041 * x[0] / length;
      const double shape = std::cosh(k) - std::cos(k) - 0.7340955 * (std::sinh(k) - std::sin(k));
      return Vec3{0, 0, 1e-3 * shape};
    });
    model.control.end_time = 1.1;
    return first_rest(model, 40, 2);
  };
  const double plain = quarter(false);
  const double reinforced = quarter(true);
  const double concrete = concrete_modulus * 10 * height;
  const double steel = steel_modulus * bars;
  const double axis = steel * offset / (concrete + steel);
  const double bending =
      concrete * (height * height / 12 + axis * axis) + steel * (offset - axis) * (offset - axis);
  const double mass = composite(10 * height, bars).mass / (concrete_density * 10 * height);
  // Stiffness over that of concrete alone, from the periods and the masses.
  test::verified("reinforced cantilever: bending stiffness over that of plain concrete",
                 "transformed section (Gere, Mechanics of Materials)")
      .within(mass * plain * plain / (reinforced * reinforced), bending / (concrete * height * height / 12),
              0.01);
}

ReinforcedBlock spinning_block() {
  ReinforcedBlock block({4, 3, 3}, {40, 30, 30}, 25, 0.2);
  distort(block, 1.5);
  block.add_bar(9, {2, 5, 6}, {38, 24, 26});
  block.add_bar(6, {0, 15, 8}, {40, 15, 8});
  block.add_bar(5, {20, 0, 15}, {20, 30, 15});
  // This one goes on outside of the block.
  block.add_bar(8, {-10, 8, 22}, {50, 8, 22});
  return block;
}

TEST(EmbeddedBeams, SpinningBlockKeepsItsMomenta) {
  ReinforcedBlock block = spinning_block();
  const double spin = 2;
  block.set_velocities([&](const Point& x) {
    const Vec3 arm{x[0] - 20, x[1] - 15, x[2] - 15};
    return Vec3{0.5, -0.2, 0.3} + cross(Vec3{0.6 * spin, 0, 0.8 * spin}, arm);
  });
  block.model.control.end_time = 1.0;
  timeloop::Simulation simulation(block.model, test::execution());
  test::Conservation kept;
  test::ImbalanceAfterStart imbalance;
  test::run(simulation, [&](const domain::Domain& domain) {
    kept.watch(domain);
    imbalance.observe(domain);
  });
  test::verified("spinning block with bars: momentum, drift", "conservation")
      .below(kept.momentum_drift, 1e-12);
  test::verified("spinning block with bars: moment of momentum, drift", "conservation")
      .below(kept.turning_drift, 1e-11);
  // That of the solids: 1e-5 without bars, and it goes with the square of the step.
  test::verified("spinning block with bars: imbalance over the energy of the start", "conservation")
      .below(imbalance.largest() / simulation.domain().energy.initial_total, 5e-6);
  EXPECT_EQ(simulation.domain().embeddings[0].released, 0);
}

// No mode is faster than the fastest of the solids alone or of the bars alone, docs/theory/connections.md:
// shaken at the whole stable step of the elements, the energy stays.
TEST(EmbeddedBeams, StableStepIsThatOfTheElements) {
  for (const Index pieces : {3, 30}) {  // the solids set the step, or the bars do
    ReinforcedBlock block({4, 2, 2}, {40, 20, 20}, 150);
    block.add_bar(pieces, {0, 10, 10}, {40, 10, 10});
    block.add_bar(pieces, {0, 3, 7}, {40, 3, 7});
    block.set_velocities([](const Point& x) {
      return Vec3{0.01 * std::sin(37 * x[0]), 0.01 * std::cos(23 * x[1] + x[0]), 0.01 * std::sin(29 * x[2])};
    });
    block.model.control.step_scale = 1;
    block.model.control.end_cycle = 3000;
    block.model.control.end_time = 1e3;
    timeloop::Simulation simulation(block.model, test::execution());
    double most = 0;
    test::run(simulation, [&](const domain::Domain& domain) {
      most = std::max(most, domain.energy.internal / domain.energy.initial_total);
    });
    EXPECT_LT(most, 2);
    EXPECT_LT(std::fabs(simulation.domain().energy.imbalance()),
              0.05 * simulation.domain().energy.initial_total);
  }
}

// The middle of the block is weak and tears: bars there are free, those on its faces stay with the rest.
TEST(EmbeddedBeams, ErosionReleasesWhatNoSolidHoldsAnyLonger) {
  ReinforcedBlock block({5, 1, 1}, {50, 10, 10}, 1);
  model::Model& model = block.model;
  model::PlasticKinematic weak;
  weak.youngs_modulus = 30;
  weak.poissons_ratio = 0.2;
  weak.yield_stress = 0.003;
  weak.tangent_modulus = 0.01;
  weak.failure_strain = 0.01;
  model.materials.push_back({.id = 3, .title = "weak", .density = concrete_density, .law = weak});
  model.parts.push_back({.id = 3, .title = "weak", .solid_section = 0, .material = 2});
  model.solids[2].part = 2;
  block.add_bar(10, {0, 4, 6}, {50, 4, 6});
  block.set_velocities([](const Point& x) { return Vec3{x[0] < 25 ? -5.0 : 5.0, 0.01 * x[0], 0}; });
  model.control.end_time = 0.1;
  timeloop::Simulation simulation(model, test::execution());
  const Vec3 before = test::momentum(simulation.domain());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const domain::Embedding& embedding = domain.embeddings[0];
  EXPECT_EQ(domain::eroded_elements(domain), 1);
  // Nodes of the bar are at 0, 5, 10, ..: in the torn solid, from 20 to 30, there is one, and two on its
  // faces.
  EXPECT_EQ(embedding.released, 1);
  EXPECT_EQ(embedding.holds[5], 0);
  EXPECT_EQ(embedding.holds[4], 1);
  EXPECT_EQ(embedding.holds[6], 1);
  // What the node and the nodes of the solid had as relative motion; without it the balance is off by 1e-3.
  EXPECT_GT(embedding.lost, 1e-3 * domain.energy.initial_total);
  test::verified("solid around a bar erodes: momentum, change over that of one half", "conservation")
      .below(norm(test::momentum(domain) - before) / (5 * concrete_density * 2500), 1e-11);
  test::verified("solid around a bar erodes: error of the energy balance", "conservation")
      .below(domain.energy.error(), 1e-4);
}

TEST(EmbeddedBeams, EndFreesTheNodes) {
  ReinforcedBlock block({2, 1, 1}, {20, 10, 10}, 5);
  const Index bar = block.add_bar(4, {0, 4, 6}, {20, 4, 6});
  block.model.embedded_beams[0].end_time = 0.05;
  for (Index node = 0; node < bar; ++node)
    block.model.fixed_nodes.push_back({.node = node, .translation = {true, true, true}, .rotation = {}});
  const Index curve = static_cast<Index>(block.model.curves.size());
  block.model.curves.push_back({.id = 1, .abscissa = {0, 10}, .ordinate = {1, 1}});
  for (Index node = bar; node < bar + 5; ++node)
    block.model.nodal_loads.push_back({.node = node, .force = {1e-6, 0, 0}, .curve = curve});
  block.model.control.end_time = 0.1;
  timeloop::Simulation simulation(block.model, test::execution());
  double moved_before = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.clock.time < 0.05) moved_before = norm(test::displacement(domain, bar));
  });
  const domain::Domain& domain = simulation.domain();
  EXPECT_EQ(moved_before, 0);
  EXPECT_EQ(domain.embeddings[0].released, 5);
  EXPECT_GT(test::displacement(domain, bar).x, 0);
  const Vec3 force = domain.embeddings[0].force;
  EXPECT_EQ(norm(force), 0);
}

TEST(EmbeddedBeams, SameBitsForAnyNumberOfThreads) {
  const auto hash = [](Precision precision, int threads) {
    ReinforcedBlock block = spinning_block();
    block.set_velocities([](const Point& x) {
      return Vec3{0.1 * std::sin(37 * x[0]), 0.1 * std::cos(23 * x[1]), 0.1 * std::sin(29 * x[2])};
    });
    block.model.control.end_time = 0.02;
    timeloop::Simulation simulation(block.model, {precision, default_isa(), threads});
    test::run(simulation);
    return simulation.state_hash();
  };
  for (const Precision precision : {Precision::Double, Precision::Mixed}) {
    const std::uint64_t one = hash(precision, 1);
    for (const int threads : {2, 3}) EXPECT_EQ(hash(precision, threads), one);
  }
}

}  // namespace
}  // namespace crumple::embedded_beams_test
