// SPDX-License-Identifier: BSD-3-Clause
//
// Models that do not fit into the caches: their arrays lie in huge pages, and kernels prefetch what they
// need.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "golden/cases.hpp"
#include "support/meshes.hpp"
#include "timeloop/simulation.hpp"

namespace crumple::golden::large_model_test {
namespace {

/// A square sheet in waves that is thrown into others.
model::Model sheet(Index columns) {
  model::Model model = test::one_part(
      {.id = 1, .title = "steel", .density = 7.85e-6, .law = kinematic_steel()}, test::shell_section(1.0, 3));
  test::add_grid(model, 0, columns, columns, [&](double u, double v) {
    return test::Point{4.0 * columns * u, 4.0 * columns * v, 0.5 * std::sin(60 * u) * std::sin(50 * v)};
  });
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const double speed = 20 * std::sin(0.1 * model.nodes.position[i][0]);
    model.initial_velocities.push_back({.node = i, .velocity = {0, 0, speed}, .angular_velocity = {}});
  }
  return model;
}

TEST(LargeModel, HasTheSameBitsForAllThreadsAndAFamilyOfInstructionSets) {
  const model::Model model = sheet(260);
  for (const Precision precision : {Precision::Mixed, Precision::Double}) {
    std::map<bool, std::uint64_t> by_family;
    for (const Isa isa : available_isas())
      for (const int threads : {1, 3}) {
        if (threads > 1 && isa != default_isa()) continue;
        timeloop::Simulation simulation(model, {precision, isa, threads});
        simulation.start();
        for (int cycle = 0; cycle < 6; ++cycle) simulation.step();
        EXPECT_GT(simulation.domain().energy.internal, 0);
        EXPECT_LT(simulation.domain().energy.error(), 1e-3);
        const bool fused = isa == Isa::Avx2 || isa == Isa::Avx512;
        const auto [entry, first] = by_family.emplace(fused, simulation.state_hash());
        EXPECT_EQ(entry->second, simulation.state_hash()) << isa_name(isa) << ", " << threads;
      }
  }
}

}  // namespace
}  // namespace crumple::golden::large_model_test
