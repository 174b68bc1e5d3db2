// SPDX-License-Identifier: BSD-3-Clause
#include "reference/bucket_sort.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "finder_scene.hpp"

namespace cellsearch::bucket_sort_test {
namespace {

std::vector<Index> nodes_of(const BucketSort& sorted, Index bucket) {
  const std::span<const Index> nodes = sorted.bucket(bucket);
  return {nodes.begin(), nodes.end()};
}

// Seven nodes and a width of 1, by hand. Along x they take up 0..3: three slabs of 1, with the nodes
//   slab 0: 0 1 4 5    slab 1: none    slab 2: 2 3 6
// Slab 0 takes up y = 0..2: two strips, nodes 0 4 and 1 5. Slab 2 takes up y = 5..5.5: one strip, nodes 2
// 3 6. Strip 0 takes up z = 0..1: one bucket, 0 4. Strip 1 takes up z = 0..9: nine buckets of 1 are wanted,
// but two nodes get no more than two: 1 below z = 4.5, 5 above. Strip 2 takes up z = -1..2: three buckets of
// 1, nodes 3, 6 and 2.
struct SevenNodes : FinderScene {
  SevenNodes() {
    positions = {0.0,  0.0, 0.0, 0.1, 2.0, 0.0, 3.0, 5.0, 2.0, 2.5, 5.5,
                 -1.0, 0.9, 0.5, 1.0, 0.2, 1.5, 9.0, 2.9, 5.2, 0.5};
    connectivity = {0, 0, 0, 0, 2, 2, 2, 2};
    expansion = 1.0;
  }
};

TEST(BucketSort, NestsBucketsInStripsInSlabs) {
  const SevenNodes scene;
  BucketSort sorted;
  sorted.build(scene.input(1.0));
  EXPECT_EQ(sorted.nodes_in_domain(), 7);
  ASSERT_EQ(sorted.slabs().count, 3);
  ASSERT_EQ(sorted.strips_of(0).cells.count, 2);
  EXPECT_EQ(sorted.strips_of(1).cells.count, 0) << "a slab without nodes";
  ASSERT_EQ(sorted.strips_of(2).cells.count, 1);
  EXPECT_EQ(sorted.strips_of(0).first, 0);
  EXPECT_EQ(sorted.strips_of(2).first, 2);
  EXPECT_EQ(sorted.buckets_of(0).cells.count, 1);
  EXPECT_EQ(sorted.buckets_of(1).cells.count, 2);
  EXPECT_EQ(sorted.buckets_of(2).cells.count, 3);
  ASSERT_EQ(sorted.cells(), 6);
  const std::vector<std::vector<Index>> expected{{0, 4}, {1}, {5}, {3}, {6}, {2}};
  for (Index bucket = 0; bucket < 6; ++bucket) {
    EXPECT_EQ(nodes_of(sorted, bucket), expected[static_cast<std::size_t>(bucket)]) << "bucket " << bucket;
  }
}

// Segment 0 is the point of node 0, its territory -1..1 along all axes: it reaches slab 0 and, rounding the
// fence, x = 1 of the empty slab 1; in slab 0 strip 0 (y = 0..1) and strip 1 from y = 1 on; in strip 0 the
// one bucket and in strip 1 the lower one: two buckets, nodes 0 4 1. Segment 1 is the point of node 2, its
// territory 2..4, 4..6, 1..3: slab 2, its strip, and the last bucket of z = 1..2, which holds node 2 alone.
TEST(BucketSort, LooksIntoTheBucketsThatATerritoryReaches) {
  const SevenNodes scene;
  BucketSort sorted;
  sorted.build(scene.input(1.0));
  const FinderRows rows(sorted, scene);
  EXPECT_EQ(rows.ends, (std::vector<Offset>{1, 1}));
  EXPECT_EQ(rows.nodes, std::vector<Index>{4});
  EXPECT_EQ(rows.cell_visits, 2 + 1);
  EXPECT_EQ(rows.raw_visits, 3 + 1);
}

// However far the nodes are apart, nothing is divided into more parts than it has nodes. Four slabs of 2.5e8:
// nodes 0 1 2 in the first, node 3 in the last. The first takes up y = -2..0, two strips of 1: nodes 2 and
// 0 1. The second of these takes up z = 0..3, but two nodes get two buckets.
TEST(BucketSort, DividesNothingIntoMorePartsThanNodes) {
  FinderScene scene;
  for (const double x : {0.0, 1.0, 2.0, 1e9}) scene.positions.insert(scene.positions.end(), {x, -x, 3.0 * x});
  BucketSort sorted;
  sorted.build(scene.input(1.0));
  EXPECT_EQ(sorted.slabs().count, 4);
  ASSERT_EQ(sorted.cells(), 4);
  const std::vector<Index> expected{2, 0, 1, 3};
  for (Index bucket = 0; bucket < 4; ++bucket) {
    EXPECT_EQ(nodes_of(sorted, bucket), std::vector<Index>{expected[static_cast<std::size_t>(bucket)]});
  }
}

TEST(BucketSort, HasNoBucketWithoutNodes) {
  FinderScene scene;
  scene.positions = {5.0, 5.0, 5.0};
  scene.connectivity = {0, 0, 0, 0};
  FinderInput input = scene.input(1.0);
  input.limit = Box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
  BucketSort sorted;
  sorted.build(input);
  EXPECT_EQ(sorted.nodes_in_domain(), 0);
  EXPECT_EQ(sorted.cells(), 0);
  EXPECT_EQ(FinderRows(sorted, scene).ends, std::vector<Offset>{0});
}

}  // namespace
}  // namespace cellsearch::bucket_sort_test
