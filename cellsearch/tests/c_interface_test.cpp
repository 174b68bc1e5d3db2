// SPDX-License-Identifier: BSD-3-Clause
// The C interface gives what the C++ one gives, in both ways of counting, and lets nothing out but codes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "cellsearch/cellsearch.h"
#include "cellsearch/search.hpp"
#include "cellsearch/search_interval.hpp"
#include "scenes.hpp"

namespace cellsearch {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Destroy {
  void operator()(cellsearch_handle* handle) const { cellsearch_destroy(handle); }
};
using Handle = std::unique_ptr<cellsearch_handle, Destroy>;

std::vector<Index> shifted(std::span<const Index> numbers, Index base) {
  std::vector<Index> result(numbers.begin(), numbers.end());
  for (Index& number : result) number += base;
  return result;
}

/// A scene in the numbering of a C or Fortran program, with the handle that views it.
struct Program {
  Index base;
  std::vector<double> positions;
  std::size_t stride;
  std::vector<Index> segments;
  std::vector<Index> nodes;
  Handle handle{cellsearch_create()};

  Program(const scenes::Mesh& mesh, Index index_base)
      : base(index_base),
        positions(mesh.positions),
        stride(mesh.stride),
        segments(shifted(mesh.segments, base)) {
    cellsearch_handle* own = handle.get();
    EXPECT_EQ(cellsearch_set_index_base(own, base), CELLSEARCH_OK);
    const auto count = static_cast<int64_t>(mesh.node_count());
    EXPECT_EQ(cellsearch_set_positions(own, count, positions.data(), static_cast<int64_t>(stride)),
              CELLSEARCH_OK);
    EXPECT_EQ(cellsearch_set_segments(own, static_cast<int64_t>(mesh.segment_count()), segments.data()),
              CELLSEARCH_OK);
    EXPECT_EQ(cellsearch_set_expansion(own, mesh.expansion), CELLSEARCH_OK);
    if (!mesh.segment_expansion.empty()) {
      EXPECT_EQ(cellsearch_set_segment_expansion(own, mesh.segment_expansion.data()), CELLSEARCH_OK);
    }
    if (mesh.nodes) {
      nodes = shifted(*mesh.nodes, base);
      nodes.reserve(1);  // an empty list still has an address
      EXPECT_EQ(cellsearch_set_nodes(own, static_cast<int64_t>(nodes.size()), nodes.data()), CELLSEARCH_OK);
    }
    if (mesh.domain) {
      EXPECT_EQ(cellsearch_set_domain(own, mesh.domain->box.lo.data(), mesh.domain->box.hi.data(),
                                      mesh.domain->cells.data()),
                CELLSEARCH_OK);
    }
  }
};

/// What a handle finds, counted from 0 as the C++ interface does.
Candidates found_by(cellsearch_handle* handle, Index base, std::size_t segments) {
  const int64_t* first = nullptr;
  const int32_t* node = nullptr;
  int64_t pairs = -1;
  Candidates found;
  EXPECT_EQ(cellsearch_find(handle, &first, &node, &pairs), CELLSEARCH_OK)
      << cellsearch_error_message(handle);
  if (first == nullptr) return found;
  for (std::size_t s = 0; s <= segments; ++s) found.first.push_back(first[s] - base);
  for (int64_t place = 0; place < pairs; ++place) found.node.push_back(node[place] - base);
  EXPECT_EQ(found.first.back(), pairs);
  return found;
}

TEST(CInterface, FindsWhatTheCppInterfaceFinds) {
  Offset pairs = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(seed);
    Settings settings;
    settings.domain = mesh.domain;
    Search search(settings);
    const Candidates& expected = search.find(mesh.scene());
    pairs += expected.pairs();
    for (const Index base : {0, 1}) {
      const Program program(mesh, base);
      cellsearch_set_threads(program.handle.get(), 1 + static_cast<int32_t>(seed % 3));
      EXPECT_EQ(found_by(program.handle.get(), base, mesh.segment_count()), expected) << mesh.name;
      int64_t segment = 7;
      int64_t node = 7;
      EXPECT_EQ(cellsearch_verify(program.handle.get(), &segment, &node), CELLSEARCH_OK);
      EXPECT_EQ(segment, base - 1);
      EXPECT_EQ(node, base - 1);
    }
  }
  EXPECT_GT(pairs, 1000);
}

TEST(CInterface, FiltersAsTheCppInterfaceDoes) {
  const scenes::Mesh mesh = scenes::folded_sheets(600, 3);
  const std::size_t nodes = mesh.node_count();
  const std::size_t segments = mesh.segment_count();
  const std::vector<double> radius(nodes, 0.3);
  std::vector<std::uint8_t> active(segments, 1);
  std::vector<Index> node_group;
  std::vector<Index> segment_group;
  for (std::size_t s = 0; s < segments; s += 5) active[s] = 0;
  for (std::size_t n = 0; n < nodes; ++n) node_group.push_back(n < nodes / 2 ? 0 : 1);
  for (std::size_t s = 0; s < segments; ++s) segment_group.push_back(static_cast<Index>(s % 2));
  const std::vector<std::uint8_t> allow{1, 0, 1, 1};  // segments of group 0 take no nodes of group 1
  Scene scene = mesh.scene();
  scene.node_radius = radius;
  scene.segment_active = active;
  scene.exclude_neighbours = true;
  scene.groups = {2, node_group, segment_group, allow};
  Search search;
  const Candidates expected = search.find(scene);
  Search plain;
  ASSERT_NE(plain.find(mesh.scene()), expected);
  ASSERT_GT(expected.pairs(), 100);
  for (const Index base : {0, 1}) {
    const Program program(mesh, base);
    cellsearch_handle* handle = program.handle.get();
    const std::vector<Index> group_of_node = shifted(node_group, base);
    const std::vector<Index> group_of_segment = shifted(segment_group, base);
    EXPECT_EQ(cellsearch_set_node_radius(handle, radius.data()), CELLSEARCH_OK);
    EXPECT_EQ(cellsearch_set_active(handle, active.data()), CELLSEARCH_OK);
    EXPECT_EQ(cellsearch_set_exclude_neighbours(handle, 1), CELLSEARCH_OK);
    EXPECT_EQ(cellsearch_set_groups(handle, 2, group_of_node.data(), group_of_segment.data(), allow.data()),
              CELLSEARCH_OK);
    EXPECT_EQ(found_by(handle, base, segments), expected);
    // All of it can be taken back.
    EXPECT_EQ(cellsearch_set_node_radius(handle, nullptr), CELLSEARCH_OK);
    EXPECT_EQ(cellsearch_set_active(handle, nullptr), CELLSEARCH_OK);
    EXPECT_EQ(cellsearch_set_exclude_neighbours(handle, 0), CELLSEARCH_OK);
    EXPECT_EQ(cellsearch_set_groups(handle, 0, nullptr, nullptr, nullptr), CELLSEARCH_OK);
    EXPECT_EQ(found_by(handle, base, segments), plain.query());
  }
}

TEST(CInterface, VisitsInTheOrderOfTheRowsAndStopsWhenAsked) {
  const scenes::Mesh mesh = scenes::folded_sheets(600, 3);
  struct Visited {
    Candidates found;
    Index segment = 0;
    int64_t most = std::numeric_limits<int64_t>::max();
  };
  const auto visitor = [](int32_t segment, int32_t node, void* data) -> int32_t {
    auto* visited = static_cast<Visited*>(data);
    EXPECT_GE(segment, visited->segment);
    visited->segment = segment;
    visited->found.node.push_back(node);
    return visited->found.pairs() == visited->most ? 1 : 0;
  };
  for (const Index base : {0, 1}) {
    const Program program(mesh, base);
    ASSERT_EQ(cellsearch_build(program.handle.get()), CELLSEARCH_OK);
    Visited all;
    EXPECT_EQ(cellsearch_visit(program.handle.get(), visitor, &all), CELLSEARCH_OK);
    const int32_t* node = nullptr;
    int64_t pairs = 0;
    EXPECT_EQ(cellsearch_query(program.handle.get(), nullptr, &node, &pairs), CELLSEARCH_OK);
    EXPECT_EQ(all.found.node, Array<Index>(node, node + pairs));
    Visited some;
    some.most = 5;
    EXPECT_EQ(cellsearch_visit(program.handle.get(), visitor, &some), CELLSEARCH_OK);
    EXPECT_EQ(some.found.pairs(), 5);
  }
}

TEST(CInterface, CountsAsTheCppInterfaceDoes) {
  const scenes::Mesh mesh = scenes::folded_sheets(600, 3);
  Search search;
  search.find(mesh.scene());
  const Statistics& expected = search.statistics();
  const Program program(mesh, 1);
  cellsearch_counts counts{};
  EXPECT_EQ(cellsearch_find(program.handle.get(), nullptr, nullptr, nullptr), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_statistics(program.handle.get(), &counts), CELLSEARCH_OK);
  EXPECT_EQ(counts.segments, expected.segments);
  EXPECT_EQ(counts.participants, expected.participants);
  EXPECT_EQ(counts.nodes_in_domain, expected.nodes_in_domain);
  EXPECT_EQ(counts.cells, expected.cells);
  EXPECT_EQ(counts.bytes, expected.bytes);
  EXPECT_EQ(counts.cell_visits, expected.cell_visits);
  EXPECT_EQ(counts.raw_visits, expected.raw_visits);
  EXPECT_EQ(counts.candidates, expected.candidates);
  EXPECT_GT(counts.candidates, 0);
}

TEST(CInterface, KnowsTheMethodsByName) {
  ASSERT_EQ(cellsearch_method_count(), static_cast<int32_t>(methods().size()));
  EXPECT_EQ(cellsearch_method_name(-1), nullptr);
  EXPECT_EQ(cellsearch_method_name(cellsearch_method_count()), nullptr);
  const Handle handle(cellsearch_create());
  for (int32_t number = 0; number < cellsearch_method_count(); ++number) {
    const std::string name = cellsearch_method_name(number);
    EXPECT_EQ(name, name_of(methods()[static_cast<std::size_t>(number)]));
    EXPECT_EQ(cellsearch_set_method(handle.get(), name.c_str()), CELLSEARCH_OK);
  }
  EXPECT_EQ(cellsearch_set_method(handle.get(), "guess"), CELLSEARCH_BAD_SETTING);
  EXPECT_NE(std::string(cellsearch_error_message(handle.get())).find(" brute-force"), std::string::npos);
}

TEST(CInterface, TellsItsVersion) {
  EXPECT_EQ(std::string(cellsearch_version()), CELLSEARCH_VERSION);
}

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

scenes::Mesh two_plates() {
  scenes::Mesh mesh;
  for (const double z : {0.0, 0.25}) {
    const Index first = mesh.add_node(0, 0, z);
    mesh.add_node(1, 0, z);
    mesh.add_node(1, 1, z);
    mesh.add_node(0, 1, z);
    mesh.add_segment(first, first + 1, first + 2, first + 3);
  }
  mesh.expansion = 0.25;
  return mesh;
}

TEST(CInterface, ReportsBadScenesInTheNumberingOfTheCaller) {
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

TEST(CInterface, RefusesBadSettingsAndKeepsTheOldOnes) {
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

TEST(CInterface, SurvivesNullPointersAndNegativeNumbers) {
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

TEST(CInterface, HasNoCandidatesWithoutSegmentsOrNodes) {
  const Program program(two_plates(), 1);
  int64_t pairs = -1;
  const int64_t* first = nullptr;
  EXPECT_EQ(cellsearch_set_nodes(program.handle.get(), 0, program.segments.data()), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_find(program.handle.get(), nullptr, nullptr, &pairs), CELLSEARCH_OK);
  EXPECT_EQ(pairs, 0);
  EXPECT_EQ(cellsearch_set_nodes(program.handle.get(), 0, nullptr), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_set_segments(program.handle.get(), 0, nullptr), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_find(program.handle.get(), &first, nullptr, &pairs), CELLSEARCH_OK);
  EXPECT_EQ(pairs, 0);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first[0], 1);
}

// c = 0.25 and h = 0.125, both plates of one contact: a node may move by 0.125.
TEST(CInterface, WatchesTheMotion) {
  Program program(two_plates(), 1);
  cellsearch_handle* handle = program.handle.get();
  double used = 0;
  double left = 0;
  int32_t due = 0;
  int32_t steps = 0;
  const std::vector<double> velocities{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.25,
                                       0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(cellsearch_motion_update(handle, &used, &left, &due), CELLSEARCH_OK);
  EXPECT_EQ(used, infinity);
  EXPECT_EQ(due, 1);
  EXPECT_EQ(cellsearch_motion_steps(handle, velocities.data(), 3, 0.0625, 50, &steps), CELLSEARCH_OK);
  EXPECT_EQ(steps, 1);
  ASSERT_EQ(cellsearch_build(handle), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_motion_start(handle, -1.0, 0.0), CELLSEARCH_BAD_SETTING);
  ASSERT_EQ(cellsearch_motion_start(handle, 0.25, 0.125), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_motion_steps(handle, velocities.data(), 3, 0.0625, 50, &steps), CELLSEARCH_OK);
  EXPECT_EQ(steps, 8);
  EXPECT_EQ(cellsearch_motion_steps(handle, velocities.data(), 2, 0.0625, 50, &steps), CELLSEARCH_BAD_LAYOUT);
  program.positions[3 * 6 + 2] -= 0.0625;
  EXPECT_EQ(cellsearch_motion_update(handle, &used, &left, &due), CELLSEARCH_OK);
  EXPECT_EQ(used, 0.0625);
  EXPECT_EQ(left, 0.0625);
  EXPECT_EQ(due, 0);
  program.positions[3 * 2] += 1.0;
  EXPECT_EQ(cellsearch_motion_update(handle, &used, nullptr, &due), CELLSEARCH_OK);
  EXPECT_EQ(used, 1.0);
  EXPECT_EQ(due, 1);
  program.positions[3 * 2] = nan;
  EXPECT_EQ(cellsearch_motion_update(handle, nullptr, nullptr, &due), CELLSEARCH_NON_FINITE_COORDINATE);
  EXPECT_EQ(due, 1);
  EXPECT_EQ(cellsearch_error_index(handle), 3);
  EXPECT_NE(std::string(cellsearch_error_message(handle)).find("Node 3 "), std::string::npos);
  EXPECT_EQ(cellsearch_interval(2.5, 1.25, 0.5, 0.25, 100), search_interval(2.5, 1.25, 0.5, 0.25, 100));
  EXPECT_EQ(cellsearch_interval(2.5, 1.25, 0.5, 0.25, 100), 10);
}

TEST(CInterface, HandlesAreIndependent) {
  const scenes::Mesh mesh = scenes::folded_sheets(600, 3);
  Search search;
  const Candidates& expected = search.find(mesh.scene());
  std::vector<std::jthread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      for (int time = 0; time < 3; ++time) {
        const Program program(mesh, thread % 2);
        EXPECT_EQ(found_by(program.handle.get(), thread % 2, mesh.segment_count()), expected);
      }
    });
  }
}

}  // namespace
}  // namespace cellsearch
