// SPDX-License-Identifier: BSD-3-Clause
//
// Residuals of the energy balance by part: their sum is the imbalance of the whole model, and energy that is
// put in by force shows in the part and among the elements where that was done.

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::energy_trace_test {
namespace {

/// Two free plates apart from each other, each of 3 chunks of elements and bent by its velocities. A third,
/// of one small element that rests, keeps the step the same: steps that change would add to the imbalance.
model::Model two_plates() {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1.0, 3));
  model.parts.push_back(model.parts[0]);
  model.parts[1].id = 7;
  constexpr Index sides = 36;
  for (Index part = 0; part < 2; ++part)
    test::add_grid(model, part, sides, sides, [&](double u, double v) {
      return test::Point{100 * u, 100 * v, 50.0 * part};
    });
  const Index moving = model.nodes.count();
  model.parts.push_back(model.parts[0]);
  model.parts[2].id = 8;
  test::add_grid(model, 2, 1, 1, [](double u, double v) { return test::Point{u, v, 100}; });
  for (Index i = 0; i < moving; ++i) {
    const auto& x = model.nodes.position[i];
    const double wave = std::sin(0.1 * x[0]) * std::cos(0.07 * x[1]);
    model.initial_velocities.push_back({.node = i, .velocity = {0, 0, 5 * wave}, .angular_velocity = {}});
  }
  model.control.end_time = 1;
  model.control.end_cycle = 400;
  return model;
}

double sum_of(const domain::EnergyTraceReport& report) {
  double sum = 0;
  for (const domain::EnergyResidual& part : report.parts) sum += part.residual;
  return sum;
}

/// Makes the stresses of an element what they would be without half of its strain.
void relax(domain::ShellBlock& block, Index place) {
  const domain::StateItem* const stress = block.find("stress");
  for (Index k = 0; k < stress->count; ++k)
    block.set_state(place, stress->first + k, 0.5 * block.state(place, stress->first + k));
}

TEST(EnergyTrace, SumsUpToTheImbalance) {
  const model::Model model = two_plates();
  timeloop::Simulation simulation(model, test::execution());
  simulation.trace_energy();
  simulation.start();
  while (!simulation.finished()) simulation.step();
  const domain::EnergyLedger& energy = simulation.domain().energy;
  const domain::EnergyTraceReport report = simulation.energy_trace();
  ASSERT_EQ(report.parts.size(), 3U);
  EXPECT_EQ(report.parts[1].id, 7);
  EXPECT_NEAR(report.parts[0].energy + report.parts[1].energy, energy.internal + energy.hourglass,
              1e-12 * energy.internal);
  EXPECT_NE(sum_of(report), 0);
  EXPECT_EQ(report.parts[2].residual, 0);
  test::verified("energy residuals by part: their sum over the imbalance", "whole model")
      .near(sum_of(report) / energy.imbalance(), 1, 0.01);
}

TEST(EnergyTrace, NamesThePartAndTheElementsWhereEnergyComesFrom) {
  const model::Model model = two_plates();
  timeloop::Simulation simulation(model, test::execution());
  simulation.trace_energy();
  simulation.start();
  for (int cycle = 0; cycle < 200; ++cycle) simulation.step();
  domain::Domain& domain = simulation.domain();
  const auto before = simulation.energy_trace();
  domain::ShellBlock& block = domain.shells[1];
  const Index place = block.elements - 20;
  relax(block, place);
  for (int cycle = 0; cycle < 20; ++cycle) simulation.step();
  const auto after = simulation.energy_trace();
  const double made = after.parts[1].residual - before.parts[1].residual;
  const double elsewhere = after.parts[0].residual - before.parts[0].residual;
  EXPECT_GT(std::fabs(made), 100 * std::fabs(elsewhere));
  test::verified("energy residuals by part with an element at fault: their sum over the imbalance",
                 "whole model")
      .near(sum_of(after) / domain.energy.imbalance(), 1, 0.01);
  const domain::ElementResidual& worst = after.worst.front();
  EXPECT_EQ(worst.part, 7);
  EXPECT_STREQ(worst.kind, "shell");
  // The last chunk of the part, by places: it ends with the part's last element.
  EXPECT_EQ(worst.last, model.shells[block.element[block.elements - 1]].id);
}

TEST(EnergyTrace, FewerElementsAtATimeFindTheFaultMoreClosely) {
  const model::Model model = two_plates();
  domain::Execution execution = test::execution();
  execution.groups_per_chunk = 1;
  timeloop::Simulation simulation(model, execution);
  simulation.trace_energy();
  simulation.start();
  for (int cycle = 0; cycle < 200; ++cycle) simulation.step();
  domain::ShellBlock& block = simulation.domain().shells[1];
  constexpr Index broken = 500;
  relax(block, broken);
  for (int cycle = 0; cycle < 20; ++cycle) simulation.step();
  const domain::ElementResidual worst = simulation.energy_trace().worst.front();
  EXPECT_EQ(worst.part, 7);
  EXPECT_EQ(worst.elements, lanes);
  EXPECT_EQ(worst.first, model.shells[block.element[broken / lanes * lanes]].id);
}

}  // namespace
}  // namespace crumple::energy_trace_test
