// SPDX-License-Identifier: BSD-3-Clause
#include "output/results/shell_results.hpp"

#include <array>
#include <cmath>

#include "output/sample.hpp"

namespace crumple::output::shell_results_test {
namespace {

class ShellResultsTest : public SampleTest {
 protected:
  /// One element whose stress (xx, yy, xy, yz, zx) at each thickness point is given.
  ShellResults results(const std::vector<std::array<double, 5>>& stress) {
    block_ = domain::ShellBlock{};
    block_.elements = 1;
    block_.element = {0};
    domain::add_item(block_, "stress", "stress", static_cast<Index>(5 * stress.size()));
    domain::add_item(block_, "plastic_strain", "-", static_cast<Index>(stress.size()));
    block_.double_state.resize(static_cast<std::size_t>(block_.components) * lanes);
    for (std::size_t point = 0; point < stress.size(); ++point)
      for (std::size_t i = 0; i < 5; ++i)
        block_.set_state(0, static_cast<Index>(5 * point + i), stress[point][i]);
    return ShellResults(model_, block_);
  }
  domain::ShellBlock block_;
};

TEST_F(ShellResultsTest, VonMisesOfSimpleStates) {
  EXPECT_DOUBLE_EQ(results({{-3, 0, 0, 0, 0}}).von_mises(0), 3) << "uniaxial: the stress itself";
  EXPECT_DOUBLE_EQ(results({{2, 2, 0, 0, 0}}).von_mises(0), 2) << "equal biaxial: the stress itself";
  EXPECT_DOUBLE_EQ(results({{0, 0, 5, 0, 0}}).von_mises(0), 5 * std::sqrt(3.0)) << "shear: sqrt 3 times";
  EXPECT_DOUBLE_EQ(results({{0, 0, 0, 3, 4}}).von_mises(0), 5 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(results({{3, -3, 0, 0, 0}}).von_mises(0), 3 * std::sqrt(3.0))
      << "shear seen at 45 degrees";
}

TEST_F(ShellResultsTest, BendingShowsAtTheSurfacesAndNotInTheMiddle) {
  const auto odd = results({{-4, 0, 0, 0, 0}, {1, 0, 0, 0, 0}, {6, 0, 0, 0, 0}});
  EXPECT_DOUBLE_EQ(odd.von_mises(0), 6);
  EXPECT_DOUBLE_EQ(odd.mid_von_mises(0), 1);
  const auto even = results({{-9, 0, 0, 0, 0}, {-2, 0, 0, 0, 0}, {3, 0, 0, 0, 0}, {9, 0, 0, 0, 0}});
  EXPECT_DOUBLE_EQ(even.mid_von_mises(0), 0.5) << "the mean of the points at -2 and 3";
}

TEST_F(ShellResultsTest, PressureIsTheMeanOverTheThickness) {
  EXPECT_DOUBLE_EQ(results({{-3, 0, 7, 0, 0}}).pressure(0), 1);
  EXPECT_DOUBLE_EQ(results({{-9, 0, 0, 0, 0}, {3, -3, 0, 0, 0}, {0, -6, 0, 0, 0}}).pressure(0), 5.0 / 3);
}

/// Points in plane, each with its own points through the thickness one after the other.
TEST_F(ShellResultsTest, BendingInPlaneShowsAtThePointsAndNotInTheMiddle) {
  const auto odd = results({{90, 0, 0, 0, 0},
                            {-1, 0, 0, 0, 0},
                            {80, 0, 0, 0, 0},  //
                            {70, 0, 0, 0, 0},
                            {-1, 0, 0, 0, 0},
                            {60, 0, 0, 0, 0},  //
                            {50, 0, 0, 0, 0},
                            {5, 0, 4, 0, 0},
                            {40, 0, 0, 0, 0},  //
                            {30, 0, 0, 0, 0},
                            {5, 0, 4, 0, 0},
                            {-99, 0, 0, 0, 0}});
  block_.plane_points = 4;
  EXPECT_DOUBLE_EQ(odd.von_mises(0), 99);
  EXPECT_DOUBLE_EQ(odd.mid_von_mises(0), 4) << "of the mean (2, 2 in shear), not the mean of von Mises";
  const auto even = results({{-7, 0, 0, 0, 0},
                             {1, 0, 0, 0, 0},  //
                             {-7, 0, 0, 0, 0},
                             {1, 0, 0, 0, 0},  //
                             {9, 0, 0, 0, 0},
                             {5, 0, 0, 0, 0},  //
                             {9, 0, 0, 0, 0},
                             {-3, 0, 0, 0, 0}});
  block_.plane_points = 4;
  EXPECT_DOUBLE_EQ(even.von_mises(0), 9);
  EXPECT_DOUBLE_EQ(even.mid_von_mises(0), 1);
}

TEST_F(ShellResultsTest, PlasticStrainIsTheLargestOverTheThickness) {
  const auto shell = results({{}, {}, {}});
  const Index first = block_.find("plastic_strain")->first;
  block_.set_state(0, first, 0.1);
  block_.set_state(0, first + 1, 0.3);
  block_.set_state(0, first + 2, 0.2);
  EXPECT_DOUBLE_EQ(shell.plastic_strain(0), 0.3);
}

TEST_F(ShellResultsTest, WhatABlockDoesNotKeepIsTheModelsOrZero) {
  block_ = domain::ShellBlock{};
  block_.elements = 1;
  block_.element = {0};
  const ShellResults shell(model_, block_);
  EXPECT_EQ(shell.von_mises(0), 0);
  EXPECT_EQ(shell.plastic_strain(0), 0);
  EXPECT_TRUE(shell.alive(0));
  EXPECT_DOUBLE_EQ(shell.thickness(0), 0.5) << "of the section";
  model_.shells[0].thickness = {1, 2, 3, 4};
  EXPECT_DOUBLE_EQ(shell.thickness(0), 2.5) << "of the element";
}

}  // namespace
}  // namespace crumple::output::shell_results_test
