// SPDX-License-Identifier: BSD-3-Clause
// Stiffness damping of a point of a solid that turns while it is strained.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "elements/common/stiffness_damping.hpp"
#include "materials/common/solid_material.hpp"

namespace crumple::elements::damping_turn_test {
namespace {

/// The increment belongs to the middle of the step, half of a quarter turn is still to come: 0.1 along x is
/// 0.05 along x and y and 0.1 in engineering shear at its end. With 2 G = 2 and lambda = 1.
TEST(StiffnessDamping, IncrementsTurnByHalfOfTheStep) {
  StiffnessDamping damping;
  damping.given.beta = 0.5;
  damping.step = 0.5;  // beta over it: 1
  damping.first = 6;   // behind the stress
  damping.direct = 3;
  damping.cross = 1;
  damping.shear = 1;
  constexpr std::size_t row = materials::tile_lanes;
  std::vector<double> state((6 + damping_item::stress + 6) * lanes, 0.0);
  std::vector<double> strain(6 * row, 0.0);
  std::vector<double> turn(9 * row, 0.0);
  std::vector<double> work(row, 0.0);
  std::vector<double> limit(row, 1.0);
  state[0] = 5;  // the law leaves a stress
  strain[0] = 0.1;
  const double quarter[9] = {-1, -1, 0, 1, -1, 0, 0, 0, 0};  // about z, less the unit matrix
  for (std::size_t k = 0; k < 9; ++k) turn[k * row] = quarter[k];
  add_damping(damping, DampingTile<double>{.state = state.data(),
                                           .groups = 1,
                                           .strain = strain.data(),
                                           .turn = turn.data(),
                                           .work = work.data(),
                                           .limit = limit.data()});
  const double expected[6] = {0.2, 0.2, 0.1, 0.1, 0, 0};
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_NEAR(state[(6 + damping_item::stress + c) * lanes], expected[c], 1e-12) << c;
  EXPECT_NEAR(work[0], 0.5 * (0.2 * 0.05 + 0.2 * 0.05 + 0.1 * 0.1), 1e-12);
}

}  // namespace
}  // namespace crumple::elements::damping_turn_test
