// SPDX-License-Identifier: BSD-3-Clause
// The C interface lets nothing out but codes, messages and numbers in the caller's way of counting.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "c_program.hpp"
#include "cellsearch/cellsearch.h"

namespace cellsearch::c_error_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A wrong input: what it does to two plates of which it may change everything.
struct Wrong {
  const char* name;
  int32_t status;
  int64_t index;  ///< counted from 0; -1: none
  const char* message_from_one;
  std::function<void(Program&)> spoil;
};

const std::vector<Wrong>& wrong_inputs() {
  static const std::vector<Wrong> all{
      {"coordinate", CELLSEARCH_NON_FINITE_COORDINATE, 5, "Node 6 ",
       [](Program& program) { program.positions[5 * program.stride + 1] = nan; }},
      {"connectivity", CELLSEARCH_BAD_CONNECTIVITY, 1, "Segment 2 ",
       [](Program& program) { program.segments[6] = program.base - 1; }},
      {"connectivity beyond", CELLSEARCH_BAD_CONNECTIVITY, 0, "Segment 1 ",
       [](Program& program) { program.segments[3] = program.base + 8; }},
      {"smallest number", CELLSEARCH_BAD_CONNECTIVITY, 0, "Segment 1 ",
       [](Program& program) { program.segments[3] = std::numeric_limits<Index>::min(); }},
      {"common expansion", CELLSEARCH_BAD_EXPANSION, -1, "The expansion is -1",
       [](Program& program) { cellsearch_set_expansion(program.handle.get(), -1.0); }},
      {"expansion", CELLSEARCH_BAD_EXPANSION, 1, "segment 2 ",
       [](Program& program) {
         static const std::array<double, 2> bad{0.0, infinity};
         cellsearch_set_segment_expansion(program.handle.get(), bad.data());
       }},
      {"list of nodes", CELLSEARCH_BAD_NODE_LIST, 2, "Entry 3 ",
       [](Program& program) {
         program.nodes = shifted(std::vector<Index>{0, 4, 4, 7}, program.base);
         cellsearch_set_nodes(program.handle.get(), 4, program.nodes.data());
       }},
      {"radius", CELLSEARCH_BAD_RADIUS, 3, "node 4 ",
       [](Program& program) {
         static const std::array<double, 8> bad{0, 0, 0, -1, 0, 0, 0, 0};
         cellsearch_set_node_radius(program.handle.get(), bad.data());
       }},
      {"group of a node", CELLSEARCH_BAD_NODE_GROUP, 2, "node 3 ",
       [](Program& program) {
         static const std::array<std::uint8_t, 1> allow{1};
         static std::vector<Index> of_nodes;
         static std::vector<Index> of_segments;
         of_nodes = shifted(std::vector<Index>{0, 0, 1, 0, 0, 0, 0, 0}, program.base);
         of_segments = shifted(std::vector<Index>{0, 0}, program.base);
         cellsearch_set_groups(program.handle.get(), 1, of_nodes.data(), of_segments.data(), allow.data());
       }},
      {"group of a segment", CELLSEARCH_BAD_SEGMENT_GROUP, 1, "segment 2 ",
       [](Program& program) {
         static const std::array<std::uint8_t, 1> allow{1};
         static std::vector<Index> of_nodes;
         static std::vector<Index> of_segments;
         of_nodes = shifted(std::vector<Index>(8, 0), program.base);
         of_segments = shifted(std::vector<Index>{0, -1}, program.base);
         cellsearch_set_groups(program.handle.get(), 1, of_nodes.data(), of_segments.data(), allow.data());
       }},
      {"stale array", CELLSEARCH_BAD_LAYOUT, -1, "expansions",
       [](Program& program) {
         static const std::array<double, 2> good{0.0, 0.0};
         cellsearch_set_segment_expansion(program.handle.get(), good.data());
         cellsearch_set_segments(program.handle.get(), 1, program.segments.data());
       }},
      {"no node", CELLSEARCH_EMPTY_INPUT, -1, "node",
       [](Program& program) { cellsearch_set_positions(program.handle.get(), 0, nullptr, 3); }},
  };
  return all;
}

TEST(CErrors, ReportsBadScenesInTheNumberingOfTheCaller) {
  for (const Wrong& wrong : wrong_inputs()) {
    for (const Index base : {0, 1}) {
      Program program(two_plates(), base);
      cellsearch_handle* handle = program.handle.get();
      ASSERT_EQ(cellsearch_find(handle, nullptr, nullptr, nullptr), CELLSEARCH_OK);
      wrong.spoil(program);
      ASSERT_EQ(cellsearch_error_code(handle), CELLSEARCH_OK) << cellsearch_error_message(handle);
      EXPECT_EQ(cellsearch_build(handle), wrong.status) << wrong.name;
      EXPECT_EQ(cellsearch_error_code(handle), wrong.status);
      EXPECT_EQ(cellsearch_error_index(handle), wrong.index < 0 ? -1 : wrong.index + base) << wrong.name;
      const std::string message = cellsearch_error_message(handle);
      if (base == 1) {
        EXPECT_NE(message.find(wrong.message_from_one), std::string::npos) << message;
      }
      EXPECT_GT(message.size(), 10U);
      // There is nothing to query, and a call that works clears the error.
      EXPECT_EQ(cellsearch_query(handle, nullptr, nullptr, nullptr), CELLSEARCH_NOT_BUILT);
      EXPECT_EQ(cellsearch_error_index(handle), -1);
      EXPECT_EQ(cellsearch_set_threads(handle, 2), CELLSEARCH_OK);
      EXPECT_EQ(std::string(cellsearch_error_message(handle)), "");
    }
  }
}

TEST(CErrors, RefusesBadSettingsAndKeepsTheOldOnes) {
  const Program program(two_plates(), 1);
  cellsearch_handle* handle = program.handle.get();
  ASSERT_EQ(cellsearch_build(handle), CELLSEARCH_OK);
  const std::array<double, 3> zero{0, 0, 0};
  const std::array<double, 3> one{1, 1, 1};
  const std::array<int32_t, 3> cells{2, 2, 2};
  const std::array<int32_t, 3> no_cells{2, 0, 2};
  EXPECT_EQ(cellsearch_set_index_base(handle, 2), CELLSEARCH_BAD_SETTING);
  EXPECT_EQ(cellsearch_set_threads(handle, 0), CELLSEARCH_BAD_SETTING);
  EXPECT_EQ(cellsearch_set_cell_factor(handle, 0.0), CELLSEARCH_BAD_SETTING);
  EXPECT_EQ(cellsearch_set_cell_factor(handle, nan), CELLSEARCH_BAD_SETTING);
  EXPECT_EQ(cellsearch_set_cell_edge(handle, -1.0), CELLSEARCH_BAD_SETTING);
  EXPECT_EQ(cellsearch_set_cell_edge(handle, nan), CELLSEARCH_BAD_SETTING);
  EXPECT_EQ(cellsearch_set_instruction_set(handle, "guess"), CELLSEARCH_BAD_SETTING);
  EXPECT_EQ(cellsearch_set_instruction_set(handle, nullptr), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_set_cells_per_node(handle, infinity), CELLSEARCH_BAD_SETTING);
  EXPECT_EQ(cellsearch_set_domain(handle, zero.data(), one.data(), no_cells.data()), CELLSEARCH_BAD_DOMAIN);
  EXPECT_EQ(cellsearch_error_index(handle), 1);  // axes are counted from 0
  EXPECT_EQ(cellsearch_set_domain(handle, one.data(), zero.data(), cells.data()), CELLSEARCH_BAD_DOMAIN);
  EXPECT_EQ(cellsearch_set_domain(handle, zero.data(), nullptr, cells.data()), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_set_positions(handle, 8, program.positions.data(), 2), CELLSEARCH_BAD_LAYOUT);
  EXPECT_EQ(cellsearch_set_positions(handle, int64_t{1} << 31, program.positions.data(), 3),
            CELLSEARCH_BAD_LAYOUT);
  EXPECT_EQ(cellsearch_set_segments(handle, int64_t{1} << 31, program.segments.data()),
            CELLSEARCH_BAD_LAYOUT);
  int64_t pairs = 0;
  EXPECT_EQ(cellsearch_query(handle, nullptr, nullptr, &pairs), CELLSEARCH_OK);
  EXPECT_EQ(pairs, 8);
  // Cells over half of the plates, and over all again.
  const std::array<double, 3> half{0.5, 1, 1};
  EXPECT_EQ(cellsearch_set_domain(handle, zero.data(), half.data(), cells.data()), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_query(handle, nullptr, nullptr, &pairs), CELLSEARCH_NOT_BUILT);
  EXPECT_EQ(cellsearch_find(handle, nullptr, nullptr, &pairs), CELLSEARCH_OK);
  EXPECT_EQ(pairs, 4);
  EXPECT_EQ(cellsearch_set_domain(handle, nullptr, nullptr, nullptr), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_find(handle, nullptr, nullptr, &pairs), CELLSEARCH_OK);
  EXPECT_EQ(pairs, 8);
}

TEST(CErrors, SurvivesNullPointersAndNegativeNumbers) {
  cellsearch_handle* no_handle = nullptr;
  EXPECT_EQ(cellsearch_build(no_handle), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_error_code(no_handle), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_error_index(no_handle), -1);
  EXPECT_NE(std::string(cellsearch_error_message(no_handle)), "");
  cellsearch_destroy(no_handle);

  const Program program(two_plates(), 0);
  cellsearch_handle* handle = program.handle.get();
  ASSERT_EQ(cellsearch_build(handle), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_set_method(handle, nullptr), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_set_positions(handle, 8, nullptr, 3), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_set_positions(handle, -8, program.positions.data(), 3), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_set_segments(handle, 2, nullptr), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_set_segments(handle, -2, program.segments.data()), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_set_nodes(handle, -1, program.segments.data()), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_set_groups(handle, -1, nullptr, nullptr, nullptr), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_set_groups(handle, 1, nullptr, nullptr, nullptr), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_visit(handle, nullptr, nullptr), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_statistics(handle, nullptr), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_verify(handle, nullptr, nullptr), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_motion_steps(handle, nullptr, 3, 1.0, 10, nullptr), CELLSEARCH_BAD_ARGUMENT);
  EXPECT_EQ(cellsearch_query(handle, nullptr, nullptr, nullptr), CELLSEARCH_OK);

  const Handle fresh(cellsearch_create());
  int64_t number = 0;
  cellsearch_counts counts{};
  EXPECT_EQ(cellsearch_query(fresh.get(), nullptr, nullptr, nullptr), CELLSEARCH_NOT_BUILT);
  EXPECT_EQ(cellsearch_statistics(fresh.get(), &counts), CELLSEARCH_NOT_BUILT);
  EXPECT_EQ(cellsearch_verify(fresh.get(), &number, &number), CELLSEARCH_NOT_BUILT);
  EXPECT_EQ(cellsearch_motion_start(fresh.get(), 1.0, 0.0), CELLSEARCH_NOT_BUILT);
  EXPECT_EQ(cellsearch_build(fresh.get()), CELLSEARCH_EMPTY_INPUT);
}

TEST(CErrors, RefusesFurtherQueriesOfBadScenes) {
  for (const Index base : {0, 1}) {
    Program program(two_plates(), base);
    cellsearch_handle* handle = program.handle.get();
    cellsearch_neighbours nearest{};
    EXPECT_EQ(cellsearch_nearest(handle, 1, 1.0, 0, nullptr), CELLSEARCH_BAD_ARGUMENT);
    EXPECT_EQ(cellsearch_nearest(handle, 0, 1.0, 0, &nearest), CELLSEARCH_BAD_SETTING);
    EXPECT_EQ(cellsearch_nearest(handle, 1, nan, 0, &nearest), CELLSEARCH_BAD_SETTING);
    EXPECT_EQ(cellsearch_nearest(handle, 1, infinity, 0, &nearest), CELLSEARCH_OK);
    EXPECT_EQ(cellsearch_edge_pairs(handle, -1.0, 0, nullptr, nullptr, nullptr), CELLSEARCH_BAD_EXPANSION);
    EXPECT_EQ(cellsearch_edge_pairs(handle, 0.5, 0, nullptr, nullptr, nullptr), CELLSEARCH_OK);
    program.segments[6] = base + 8;
    EXPECT_EQ(cellsearch_segment_pairs(handle, 0, nullptr, nullptr, nullptr), CELLSEARCH_BAD_CONNECTIVITY);
    EXPECT_EQ(cellsearch_error_index(handle), base + 1);
    EXPECT_EQ(cellsearch_edges(handle, nullptr, nullptr), CELLSEARCH_BAD_CONNECTIVITY);
    EXPECT_EQ(cellsearch_error_index(handle), base + 1);
    EXPECT_EQ(cellsearch_edge_pairs(handle, 0.5, 0, nullptr, nullptr, nullptr), CELLSEARCH_BAD_CONNECTIVITY);
    program.segments[6] = base + 6;
    program.positions[3 * 4] = nan;
    EXPECT_EQ(cellsearch_edge_pairs(handle, 0.5, 0, nullptr, nullptr, nullptr),
              CELLSEARCH_NON_FINITE_COORDINATE);
    EXPECT_EQ(cellsearch_error_index(handle), base + 4);
  }
  EXPECT_EQ(cellsearch_edges(nullptr, nullptr, nullptr), CELLSEARCH_BAD_ARGUMENT);
}

}  // namespace
}  // namespace cellsearch::c_error_test
