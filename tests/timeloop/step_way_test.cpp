// SPDX-License-Identifier: BSD-3-Clause
// How far nodes move relative to each other in a step, as the clock tells it from velocities, against where
// they were and are: two blocks that are tied to each other, and a block beside a rigid body that turns.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/larger.hpp"
#include "support/run.hpp"
#include "support/ties.hpp"

namespace crumple::step_way_test {
namespace {

using math::Vec3;

/// Two tied blocks that turn and swing; the second may be a rigid body that nothing is tied to.
model::Model turning_blocks(bool rigid) {
  model::Model model = test::two_blocks(2, 3, 3);
  if (rigid) {
    model.tied_contacts.clear();
    test::make_rigid(model, 1);
  }
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    const double turn = x[0] < 10 || !rigid ? 0.3 : 0.9;
    model.initial_velocities.push_back({.node = i,
                                        .velocity = {5 - turn * x[1], turn * x[0], -2 + 0.02 * x[0] * x[0]},
                                        .angular_velocity = {}});
  }
  model.control.end_time = 1;
  return model;
}

/// Size of the range of displacements, by axis.
double way_between(const AlignedArray<Vec3>& before, const AlignedArray<Vec3>& now) {
  Vec3 low = now[0] - before[0];
  Vec3 high = low;
  for (std::size_t i = 0; i < now.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const double moved = now[i][axis] - before[i][axis];
      low[axis] = std::min(low[axis], moved);
      high[axis] = test::larger_of(high[axis], moved);
    }
  return norm(high - low);
}

class StepWay : public ::testing::TestWithParam<bool> {};

TEST_P(StepWay, BoundsTheMotionOfAllNodesClosely) {
  const model::Model model = turning_blocks(GetParam());
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  constexpr double round_off = 1e-13;  // of coordinates up to 30
  double largest = 0;
  for (int step = 0; step < 200; ++step) {
    const AlignedArray<Vec3> before = simulation.domain().nodes.position;
    simulation.step();
    const double found = way_between(before, simulation.domain().nodes.position);
    EXPECT_LE(found, simulation.domain().clock.way + round_off);
    EXPECT_GE(found, simulation.domain().clock.way - round_off);
    largest = test::larger_of(largest, found);
  }
  EXPECT_GT(largest, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(All, StepWay, ::testing::Bool(),
                         [](const auto& which) { return which.param ? "rigid" : "tied"; });

}  // namespace
}  // namespace crumple::step_way_test
