// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlapping_boxes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace crumple::contact::overlapping_boxes_test {
namespace {

using math::Vec3;
using Pairs = std::vector<std::array<Index, 2>>;

Pairs by_brute_force(const std::vector<Box>& boxes) {
  Pairs pairs;
  for (Index i = 0; i < static_cast<Index>(boxes.size()); ++i)
    for (Index j = i + 1; j < static_cast<Index>(boxes.size()); ++j)
      if (boxes[i].overlaps(boxes[j])) pairs.push_back({i, j});
  return pairs;
}

Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Boxes in a cube of edge 20 whose extents are 1, but for every `rare`th, which is up to `largest` long.
std::vector<Box> random_boxes(int count, int rare, double largest) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-10, 10);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    const double extent = i % rare == 0 ? largest : 1;
    const Vec3 low{place(random), place(random), place(random)};
    boxes.push_back({low, low + extent * Vec3{share(random), share(random), share(random)}});
  }
  return boxes;
}

TEST(OverlappingBoxes, AreThoseOfBruteForceForAnyMixtureOfSizes) {
  for (const int rare : {2, 30, 500})
    for (const double largest : {1.0, 8.0, 300.0}) {
      const std::vector<Box> boxes = random_boxes(1000, rare, largest);
      const Pairs expected = by_brute_force(boxes);
      EXPECT_GT(expected.size(), 20U);
      const Pairs found = overlapping_boxes(boxes, 1);
      EXPECT_EQ(sorted(found), expected) << rare << " " << largest;
      EXPECT_EQ(found, overlapping_boxes(boxes, 3)) << rare << " " << largest;
    }
}

/// Faces belong to their boxes, and a box that has run far away does not take others with it.
TEST(OverlappingBoxes, TouchAndLieAnywhere) {
  const std::vector<Box> boxes{{{0, 0, 0}, {1, 1, 1}},
                               {{1, 0, 0}, {2, 1, 0}},
                               {{3e15, 0, 0}, {3e15, 1, 0}},
                               {{3e15, 1, 0}, {4e15, 2, 0}},
                               {{-0.5, -0.5, -0.5}, {-0.25, -0.25, -0.25}}};
  EXPECT_EQ(sorted(overlapping_boxes(boxes, 1)), (Pairs{{0, 1}, {2, 3}}));
  EXPECT_TRUE(overlapping_boxes({}, 1).empty());
  const std::vector<Box> points(3, Box{{1, 2, 3}, {1, 2, 3}});
  EXPECT_EQ(overlapping_boxes(points, 1).size(), 3U);
}

}  // namespace
}  // namespace crumple::contact::overlapping_boxes_test
