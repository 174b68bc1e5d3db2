// SPDX-License-Identifier: BSD-3-Clause
#include "reference/axis_cells.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace cellsearch::axis_cells_test {
namespace {

TEST(AxisCells, AreAsWideAsAskedOrALittleWider) {
  const AxisCells cells = AxisCells::of_width(2.0, 9.5, 2.0, 100);  // 7.5 long: 3 cells of 2.5
  EXPECT_EQ(cells.count, 3);
  EXPECT_EQ(cells.of(2.0), 0);
  EXPECT_EQ(cells.of(4.4), 0);
  EXPECT_EQ(cells.of(4.6), 1);
  EXPECT_EQ(cells.of(7.1), 2);
  EXPECT_EQ(cells.of(9.5), 2) << "the upper end belongs to the last cell";
}

TEST(AxisCells, ClampWhatIsOutside) {
  const AxisCells cells = AxisCells::of_width(0.0, 4.0, 1.0, 100);
  EXPECT_EQ(cells.of(-1e300), 0);
  EXPECT_EQ(cells.of(1e300), 3);
  EXPECT_TRUE(cells.meets(4.0, 5.0));
  EXPECT_FALSE(cells.meets(4.1, 5.0));
  EXPECT_TRUE(cells.meets(-1.0, 0.0));
  EXPECT_FALSE(cells.meets(-1.0, -0.1));
}

TEST(AxisCells, AreNoMoreThanAllowed) {
  EXPECT_EQ(AxisCells::of_width(0.0, 1e9, 1.0, 7).count, 7);
  EXPECT_EQ(AxisCells::of_width(0.0, 1.0, 0.0, 7).count, 7) << "no width";
}

TEST(AxisCells, AreOneWhereNothingCanBeDivided) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(AxisCells::of_width(3.0, 3.0, 1.0, 9).count, 1) << "no extent";
  EXPECT_EQ(AxisCells::of_width(3.0, 3.0, 0.0, 9).count, 1) << "neither extent nor width";
  EXPECT_EQ(AxisCells::of_width(0.0, 1.0, infinity, 9).count, 1);
  EXPECT_EQ(AxisCells::of_width(-1.7e308, 1.7e308, 1.0, 9).count, 1) << "the extent is no number";
  EXPECT_EQ(AxisCells::of_width(0.0, 1e-310, 1e-312, 9).count, 1) << "cells per length is no number";
}

// The domain of the user gives the width, and so does the grid where the edge is 0 because all segments are
// points.
TEST(CellWidths, ComeFromTheDomainTheSettingsOrTheGrid) {
  FinderInput input;
  input.grid = CellGrid(CellDomain{Box{{0.0, 0.0, 0.0}, {10.0, 8.0, 6.0}}, {2, 2, 3}});
  EXPECT_EQ(cell_widths(input), (Point{5.0, 4.0, 2.0}));
  input.cell_edge = 0.5;
  EXPECT_EQ(cell_widths(input), (Point{0.5, 0.5, 0.5}));
  input.limit = input.grid.domain().box;
  EXPECT_EQ(cell_widths(input), (Point{5.0, 4.0, 2.0}));
}

}  // namespace
}  // namespace cellsearch::axis_cells_test
