// SPDX-License-Identifier: BSD-3-Clause
// A solid that is pushed through itself ends the run by its name.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"

namespace crumple {
namespace {

TEST(NegativeVolume, EndsTheRunWithTheElement) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 1, 1, 2, [](double u, double v, double w) { return test::Point{u, v, 2 * w}; });
  model.solids[1].id = 77;
  // A hundred times as fast as sound, and no viscosity against it: inside out within a step.
  model.control.bulk_quadratic = model.control.bulk_linear = 0;
  for (const Index node : {8, 9, 10, 11})
    model.initial_velocities.push_back({.node = node, .velocity = {0, 0, -6e5}});
  timeloop::Simulation simulation(model, test::execution());
  try {
    test::run(simulation);
    FAIL() << "the run went on";
  } catch (const NumericalError& error) {
    EXPECT_NE(std::string(error.what()).find("negative volume in brick element 77, part 1"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace crumple
