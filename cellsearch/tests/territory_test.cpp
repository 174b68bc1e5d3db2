// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/territory.hpp"

#include <gtest/gtest.h>

#include <array>

namespace cellsearch::territory_test {
namespace {

// Eq. (7)-(9), with numbers that are exact in binary.
TEST(Territory, IsTheBoundingBoxExpandedByC) {
  const std::array<double, 12> positions{0.0, 0.0, 0.5, 2.0, -1.0, 0.0, 3.0, 1.0, 0.25, 1.0, 2.0, -0.75};
  const std::array<Index, 8> connectivity{0, 1, 2, 3, 1, 2, 3, 3};
  Scene scene;
  scene.positions = Positions(positions);
  scene.segments = Segments(connectivity);
  scene.expansion = 0.5;
  const Box quadrilateral = territory(scene, 0);
  EXPECT_EQ(quadrilateral.lo, (Point{-0.5, -1.5, -1.25}));
  EXPECT_EQ(quadrilateral.hi, (Point{3.5, 2.5, 1.0}));
  const Box triangle = territory(scene, 1);
  EXPECT_EQ(triangle.lo, (Point{0.5, -1.5, -1.25}));
  EXPECT_EQ(triangle.hi, (Point{3.5, 2.5, 0.75}));

  const std::array<double, 2> more{0.0, 0.25};
  scene.segment_expansion = more;
  EXPECT_EQ(territory(scene, 0).lo, quadrilateral.lo);
  EXPECT_EQ(territory(scene, 1).lo, (Point{0.25, -1.75, -1.5}));
  EXPECT_EQ(territory(scene, 1).hi, (Point{3.75, 2.75, 1.0}));
}

TEST(Box, IsClosed) {
  const Box box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
  const Point corner{1.0, 0.0, 1.0};
  const Point beside{1.0, 0.0, 1.0000001};
  EXPECT_TRUE(box.contains(corner.data()));
  EXPECT_FALSE(box.contains(beside.data()));
  EXPECT_TRUE(box.intersects(Box{{1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}}));
  EXPECT_FALSE(box.intersects(Box{{1.5, 0.0, 0.0}, {2.0, 2.0, 2.0}}));
  EXPECT_TRUE(Box{}.empty());
  EXPECT_FALSE(box.empty());
  EXPECT_FALSE(Box{}.intersects(box));
}

TEST(Positions, CountsRecordsOfAnyStride) {
  const std::array<double, 24> values{};
  const std::span<const double> all(values);
  EXPECT_EQ(Positions(all).count(), 8u);
  EXPECT_EQ(Positions(all, 8).count(), 3u);
  EXPECT_EQ(Positions(all.first(19), 8).count(), 3u);  // the last record may end after z
  EXPECT_EQ(Positions(all.first(16), 8).count(), 2u);
  EXPECT_EQ(Positions(all.first(0), 8).count(), 0u);
  EXPECT_EQ(Positions(all, 8)[2], values.data() + 16);
}

}  // namespace
}  // namespace cellsearch::territory_test
