// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/linked_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace cellsearch::linked_list_test {
namespace {

LinkedList make_list(Index cells, const std::vector<Index>& cell_of_node) {
  LinkedList list;
  const std::span<Index> places = list.prepare(cells, static_cast<Index>(cell_of_node.size()));
  std::copy(cell_of_node.begin(), cell_of_node.end(), places.begin());
  list.link();
  return list;
}

std::vector<Index> nodes_of(const LinkedList& list, Index cell) {
  std::vector<Index> nodes;
  for (Index node = list.head(cell); node >= 0; node = list.next(node)) nodes.push_back(node);
  return nodes;
}

// The paper, figures 2-4: 9 nodes on 6 cells, both numbered from 1. Legible: nodes 1, 2, 3, 4, 5, 6, 9 lie
// in cells 2, 3, 6, 3, 3, 3, 3; list 3 is 9, 6, 5, 4, 2; list 1 is empty. The cells of nodes 7 and 8 are not
// legible; they are neither 1 nor 3, and here 4 and 5, about which nothing is asserted.
TEST(LinkedList, HasTheListsOfThePapersFigures) {
  const Index unused = -1;  // node 0 and cell 0 do not exist in the figures
  const LinkedList list = make_list(7, {unused, 2, 3, 6, 3, 3, 3, 4, 5, 3});
  EXPECT_EQ(list.head(3), 9);
  EXPECT_EQ(list.next(9), 6);
  EXPECT_EQ(list.next(6), 5);
  EXPECT_EQ(list.next(5), 4);
  EXPECT_EQ(list.next(4), 2);
  EXPECT_EQ(list.next(2), -1);
  EXPECT_EQ(list.head(1), -1);
  EXPECT_EQ(nodes_of(list, 2), std::vector<Index>{1});
  EXPECT_EQ(nodes_of(list, 6), std::vector<Index>{3});
}

// Eq. (12): M = Ncell + N.
TEST(LinkedList, TakesAsManyIntegersAsEquation12) {
  EXPECT_EQ(make_list(6, {1, 2, 5, 2, 2, 2, 3, 4, 2}).integers(), 15);
  EXPECT_EQ(make_list(60 * 8 * 8, std::vector<Index>(829, 7)).integers(), 60 * 8 * 8 + 829);
}

TEST(LinkedList, LeavesOutNodesOfNoCell) {
  const LinkedList list = make_list(2, {-1, 1, -1, 1});
  EXPECT_EQ(list.linked(), 2);
  EXPECT_TRUE(nodes_of(list, 0).empty());
  EXPECT_EQ(nodes_of(list, 1), (std::vector<Index>{3, 1}));
}

TEST(LinkedList, ForgetsTheFillingBefore) {
  LinkedList list = make_list(3, {0, 1, 2, 2});
  const std::span<Index> places = list.prepare(2, 1);
  ASSERT_EQ(places.size(), 1u);
  places[0] = 1;
  list.link();
  EXPECT_EQ(list.integers(), 3);
  EXPECT_EQ(list.linked(), 1);
  EXPECT_EQ(list.head(0), -1);
  EXPECT_EQ(list.head(1), 0);
  EXPECT_EQ(list.next(0), -1);
}

TEST(LinkedList, MayBeEmpty) {
  const LinkedList list = make_list(1, {});
  EXPECT_EQ(list.head(0), -1);
  EXPECT_EQ(list.integers(), 1);
}

}  // namespace
}  // namespace cellsearch::linked_list_test
