// SPDX-License-Identifier: BSD-3-Clause
// A solid that is pushed through itself ends the run by its name.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"

namespace crumple::negative_volume_test {
namespace {

/// Two cubes, or twelve tetrahedra, of which the second cube's are pushed through themselves.
model::Model pushed_through(model::SolidFormulation formulation) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  model.solid_sections[0].formulation = formulation;
  test::add_box(model, 0, 1, 1, 2, [](double u, double v, double w) { return test::Point{u, v, 2 * w}; });
  if (model::is_tetrahedral(formulation)) test::split_into_tetrahedra(model);
  model.solids[model.solids.size() / 2].id = 77;
  // A hundred times as fast as sound, and no viscosity against it: inside out within a step.
  model.control.bulk_quadratic = model.control.bulk_linear = 0;
  for (const Index node : {8, 9, 10, 11})
    model.initial_velocities.push_back({.node = node, .velocity = {0, 0, -6e5}});
  return model;
}

TEST(NegativeVolume, EndsTheRunWithTheElement) {
  using enum model::SolidFormulation;
  for (const auto formulation : {OnePointHexahedron, SelectiveHexahedron, AssumedStrainHexahedron,
                                 Tetrahedron, NodalPressureTetrahedron}) {
    const model::Model model = pushed_through(formulation);
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
}

}  // namespace
}  // namespace crumple::negative_volume_test
