// SPDX-License-Identifier: BSD-3-Clause
//
// Small blocks of cubes, held nowhere, one of whose corners is struck: the fastest motion that a mesh of
// solids knows. In blocks of one layer it is faster than a wave across an element, with whose step they blow
// up. With the default step no block ever has more energy than it was given.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "support/meshes.hpp"
#include "support/run.hpp"

namespace crumple::free_blocks_test {
namespace {

struct Block {
  std::array<Index, 3> cells;
};

constexpr std::array<Block, 7> blocks{
    {{{1, 1, 1}}, {{2, 1, 1}}, {{2, 2, 1}}, {{3, 3, 1}}, {{4, 4, 1}}, {{2, 2, 2}}, {{3, 3, 3}}}};

struct Control {
  const char* name;
  model::SolidFormulation formulation;
  model::SolidHourglassForm form;
  double coefficient = 0.1;
};

constexpr std::array<Control, 5> controls{
    {{"ELFORM 1, IHQ 2", model::SolidFormulation::OnePointHexahedron,
      model::SolidHourglassForm::FlanaganBelytschkoViscous},
     {"ELFORM 1, IHQ 5", model::SolidFormulation::OnePointHexahedron,
      model::SolidHourglassForm::ExactVolumeStiffness},
     {"ELFORM 1, IHQ 6", model::SolidFormulation::OnePointHexahedron,
      model::SolidHourglassForm::AssumedStrain},
     {"ELFORM 1, IHQ 6, QM 1", model::SolidFormulation::OnePointHexahedron,
      model::SolidHourglassForm::AssumedStrain, 1},
     {"ELFORM 2", model::SolidFormulation::SelectiveHexahedron,
      model::SolidHourglassForm::FlanaganBelytschkoViscous}}};

/// mm, ms, kg; cubes of 20 mm of steel.
model::Model struck_block(const Block& block, const Control& control) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  model.solid_sections[0].formulation = control.formulation;
  model.control.hourglass.solid_form = control.form;
  model.control.hourglass.coefficient = control.coefficient;
  const auto& n = block.cells;
  test::add_box(model, 0, n[0], n[1], n[2], [&](double u, double v, double w) {
    return test::Point{20.0 * n[0] * u, 20.0 * n[1] * v, 20.0 * n[2] * w};
  });
  model.initial_velocities.push_back({.node = 0, .velocity = {1e-3, 7e-4, 4e-4}, .angular_velocity = {}});
  return model;
}

/// The largest energy in the run over that of the blow.
double largest_energy(const model::Model& model, long cycles) {
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  const domain::EnergyLedger& energy = simulation.domain().energy;
  double largest = 0;
  for (long cycle = 0; cycle < cycles; ++cycle) {
    simulation.step();
    largest = std::max(largest, energy.kinetic + energy.internal);
  }
  return largest / energy.initial_total;
}

void expect_bounded(long cycles) {
  for (const Control& control : controls)
    for (const Block& block : blocks) {
      model::Model model = struck_block(block, control);
      model.control.end_time = 1e6;
      const auto& n = block.cells;
      const std::string name =
          std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " + std::to_string(n[2]);
      EXPECT_LT(largest_energy(model, cycles), 1 + 1e-6) << name << ", " << control.name;
    }
}

TEST(FreeBlocksSlow, KeepWhatTheyWereGivenInAHundredThousandCycles) {
  expect_bounded(100'000);
}

}  // namespace
}  // namespace crumple::free_blocks_test
