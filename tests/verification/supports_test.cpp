// SPDX-License-Identifier: BSD-3-Clause
// Forces of what holds nodes, against the balance of momentum.
#include <gtest/gtest.h>

#include <cmath>

#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/ties.hpp"
#include "support/verified.hpp"

namespace crumple::supports_test {
namespace {

using math::Vec3;

void hold(model::Model& model, Index node, const std::array<bool, 3>& translation,
          const std::array<bool, 3>& rotation = {}) {
  model.fixed_nodes.push_back({.node = node, .translation = translation, .rotation = rotation});
}

void ask(model::Model& model) {
  model.output.of(model::HistoryFile::Spcforc).asked = true;
}

Vec3 force_of_supports(const domain::Domain& domain) {
  Vec3 sum;
  for (const domain::SupportReport& support : domain.supports) sum += support.force;
  return sum;
}

/// A plate of 8 x 4 shells, clamped at its left side but for one node that is free along y; the other side
/// has a force at each node. It bends and swings.
model::Model plate() {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.8, 3));
  test::add_grid(model, 0, 8, 4, [](double u, double v) { return test::Point{20 * u, 10 * v, u * v}; });
  for (Index row = 0; row <= 4; ++row) {
    hold(model, 9 * row, {true, row != 2, true}, {true, true, true});
    model.nodal_loads.push_back({.node = 9 * row + 8, .force = {0.5, -0.01, 0.02}});
  }
  model.control.end_time = 0.05;
  ask(model);
  return model;
}

/// Largest deviation from sum of forces = change of momentum over the interval, over the largest reaction.
double worst_balance(const model::Model& model, const Vec3& applied) {
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  double worst = 0;
  double largest = 0;
  while (!simulation.finished()) {
    const Vec3 before = test::momentum(simulation.domain());
    const double step = simulation.next_step();
    simulation.step();
    const double interval = 0.5 * (step + simulation.next_step());
    const Vec3 rate = (1 / interval) * (test::momentum(simulation.domain()) - before);
    const Vec3 reaction = force_of_supports(simulation.domain());
    worst = test::larger_of(worst, norm(rate - applied - reaction));
    largest = test::larger_of(largest, norm(reaction));
  }
  EXPECT_GT(largest, norm(applied)) << "it swings";
  return worst / largest;
}

TEST(Supports, BalanceLoadsAndMomentumInEveryStep) {
  test::verified("supports of a plate: forces less rate of momentum, over the largest", "Newton")
      .below(worst_balance(plate(), {2.5, -0.05, 0.1}), 1e-14);
}

TEST(Supports, BearWhatIsHeldThroughASetOfNodes) {
  model::Model model = plate();
  // The free node of the clamped side and one beside it go with two that are held along y.
  model.constrained_node_sets.push_back({.nodes = {0, 9, 18, 19}, .direction = {false, true, false}});
  EXPECT_LT(worst_balance(model, {2.5, -0.05, 0.1}), 2e-14);
}

TEST(Supports, BearWhatIsTiedToTheirNodes) {
  // The second block hangs with its nodes at x = 10 on the face of the first one, half of which is held.
  model::Model model = test::two_blocks(1, 2, 2);
  const Index nodes_of_first = 3 * 2 * 2;
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const auto& x = model.nodes.position[node];
    if (node < nodes_of_first && x[0] == 10 && x[1] == 0) hold(model, node, {true, true, true});
    if (x[0] == 20) model.nodal_loads.push_back({.node = node, .force = {0.1, 0.02, 0}});
  }
  model.control.end_time = 0.05;
  ask(model);
  ASSERT_EQ(model.fixed_nodes.size(), 2U);
  EXPECT_LT(worst_balance(model, {0.9, 0.18, 0}), 2e-14);
}

TEST(Supports, AreMeasuredAtTimeZero) {
  model::Model model = plate();
  for (Index row = 0; row <= 4; ++row)
    model.nodal_loads.push_back({.node = 9 * row, .force = {0, 0, 3}, .moment = {0, 7, 0}});
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  ASSERT_EQ(simulation.domain().supports.size(), 5U);
  for (const domain::SupportReport& support : simulation.domain().supports) {
    EXPECT_EQ(support.force.z, -3);
    EXPECT_EQ(support.moment.y, -7);
  }
}

TEST(Supports, AreNotMeasuredUnlessAskedFor) {
  model::Model model = plate();
  model.output.of(model::HistoryFile::Spcforc).asked = false;
  const timeloop::Simulation simulation(model, test::execution());
  EXPECT_TRUE(simulation.domain().supports.empty());
}

TEST(Supports, OfACantileverBearForceAndMomentOfItsLoad) {
  // A beam of 100 along x with 0.01 across at its end, brought to rest.
  const double load = 0.01;
  model::Model model = test::one_beam_part(test::elastic_steel(), test::rectangle(5, 8, 500));
  test::add_line(model, 10, {0, 1, 0}, [](double u) { return test::Point{100 * u, 0, 0}; });
  hold(model, 0, {true, true, true}, {true, true, true});
  model.nodal_loads.push_back({.node = 10, .force = {0, 0, load}});
  model.control.end_time = 20;
  ask(model);
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 0.01);
  ASSERT_EQ(simulation.domain().supports.size(), 1U);
  const domain::SupportReport& support = simulation.domain().supports[0];
  EXPECT_NEAR(support.force.z, -load, 5e-12 * load);
  EXPECT_NEAR(support.force.x, 0, 1e-8 * load);
  // The arm is the length less what the beam shortens by bending.
  const double arm = 100 + test::displacement(simulation.domain(), 10).x;
  EXPECT_NEAR(support.moment.y, load * arm, 3e-13 * load * arm);
}

}  // namespace
}  // namespace crumple::supports_test
