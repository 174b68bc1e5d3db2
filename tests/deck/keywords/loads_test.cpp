// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::loads_test {
namespace {

TEST(Loads, NodesSegmentsAndShells) {
  const model::Model model = read_with(
      "*DEFINE_CURVE\n         1\n                 0.0                 0.0\n"
      "                 3.0                 2.0\n"
      "*SET_NODE_LIST\n         3\n         5         6\n"
      "*LOAD_NODE_POINT\n         2         3         1      -5.0\n         1         6         1\n"
      "*LOAD_NODE_SET\n         3         1         1       4.0\n"
      "*LOAD_SEGMENT\n         1       0.5       0.1         1         2         3\n"
      "*LOAD_SHELL_ELEMENT\n        12         1       0.7\n");
  ASSERT_EQ(model.nodal_loads.size(), 4U);
  EXPECT_EQ(model.nodal_loads[0].node, 1);
  EXPECT_EQ(model.nodal_loads[0].force[2], -5.0);
  EXPECT_EQ(model.nodal_loads[1].moment[1], 1.0);
  EXPECT_EQ(model.nodal_loads[3].node, 5);
  EXPECT_EQ(model.nodal_loads[3].force[0], 4.0);
  EXPECT_EQ(model.nodal_loads[3].curve, 0);
  ASSERT_EQ(model.pressure_loads.size(), 2U);
  EXPECT_EQ(model.pressure_loads[0].node, (std::array<Index, 4>{0, 1, 2, 2}));
  EXPECT_EQ(model.pressure_loads[0].pressure, 0.5);
  EXPECT_EQ(model.pressure_loads[0].arrival, 0.1);
  EXPECT_EQ(model.pressure_loads[1].node, (std::array<Index, 4>{1, 4, 5, 2}));
  EXPECT_EQ(model.pressure_loads[0].shell, no_index);
  EXPECT_EQ(model.pressure_loads[1].shell, 1);
}

}  // namespace
}  // namespace crumple::deck::test::loads_test
