// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/verify.hpp"

#include <gtest/gtest.h>

#include "scenes.hpp"

namespace cellsearch::verify_test {
namespace {

const Candidates three_rows{{0, 2, 2, 5}, {4, 7, 1, 3, 8}};

TEST(FirstDifference, IsNothingForEqualResults) {
  EXPECT_FALSE(first_difference(three_rows, three_rows));
  EXPECT_FALSE(first_difference(Candidates{}, Candidates{{0}, {}}));
}

TEST(FirstDifference, NamesAMissingNode) {
  for (const Candidates& found :
       {Candidates{{0, 2, 2, 4}, {4, 7, 1, 8}}, Candidates{{0, 2, 2, 3}, {4, 7, 1}}}) {
    const std::optional<Difference> difference = first_difference(found, three_rows);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->segment, 2);
    EXPECT_EQ(difference->node, 3);
    EXPECT_TRUE(difference->missing);
    EXPECT_EQ(difference->describe(), "Segment 2: node 3 is a candidate but was not found.");
  }
}

TEST(FirstDifference, NamesANodeTooMany) {
  const Candidates more{{0, 2, 3, 6}, {4, 7, 9, 1, 3, 8}};
  const Candidates twice{{0, 3, 3, 6}, {4, 4, 7, 1, 3, 8}};
  std::optional<Difference> difference = first_difference(more, three_rows);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->segment, 1);
  EXPECT_EQ(difference->node, 9);
  EXPECT_FALSE(difference->missing);
  difference = first_difference(twice, three_rows);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->segment, 0);
  EXPECT_EQ(difference->node, 4);
  EXPECT_FALSE(difference->missing);
}

TEST(FirstDifference, NoticesRowsThatAreNotThere) {
  const std::optional<Difference> difference = first_difference({{0, 2, 2}, {4, 7}}, three_rows);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->segment, 2);
  EXPECT_EQ(difference->node, -1);
}

TEST(Verify, ComparesWithBruteForceInTheSameDomain) {
  const scenes::Mesh mesh = scenes::crushed_tube(1000, 3);
  const Settings all;
  const Settings part{.domain = CellDomain{Box{{0.0, -5.0, -50.0}, {5.0, 5.0, 50.0}}, {5, 10, 100}}};
  Candidates in_all = Search(all).find(mesh.scene());
  const Candidates in_part = Search(part).find(mesh.scene());
  ASSERT_LT(in_part.pairs(), in_all.pairs());
  ASSERT_GT(in_part.pairs(), 0);
  EXPECT_FALSE(verify(in_all, mesh.scene(), all));
  EXPECT_FALSE(verify(in_part, mesh.scene(), part));
  EXPECT_TRUE(verify(in_part, mesh.scene(), all));
  in_all.node.back() -= 1;
  EXPECT_TRUE(verify(in_all, mesh.scene(), all));
}

}  // namespace
}  // namespace cellsearch::verify_test
