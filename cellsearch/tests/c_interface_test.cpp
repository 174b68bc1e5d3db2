// SPDX-License-Identifier: BSD-3-Clause
// The C interface gives what the C++ one gives, in both ways of counting.
#include "cellsearch/cellsearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "c_program.hpp"
#include "cellsearch/edge_pairs.hpp"
#include "cellsearch/edges.hpp"
#include "cellsearch/nearest_nodes.hpp"
#include "cellsearch/search.hpp"
#include "cellsearch/search_interval.hpp"
#include "cellsearch/segment_pairs.hpp"
#include "scenes.hpp"

namespace cellsearch::c_interface_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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
  EXPECT_EQ(cellsearch_set_instruction_set(handle.get(), "portable"), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_set_instruction_set(handle.get(), ""), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_set_cell_edge(handle.get(), 0.5), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_set_cell_edge(handle.get(), 0.0), CELLSEARCH_OK);
  EXPECT_EQ(cellsearch_set_method(handle.get(), "guess"), CELLSEARCH_BAD_SETTING);
  EXPECT_NE(std::string(cellsearch_error_message(handle.get())).find(" brute-force"), std::string::npos);
}

TEST(CInterface, TellsItsVersion) {
  EXPECT_EQ(std::string(cellsearch_version()), CELLSEARCH_VERSION);
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

/// Rows as the C++ interface has them, from what a handle lent.
template <class Number>
std::vector<Number> numbers_from_zero(const Number* numbers, int64_t count, Index base) {
  std::vector<Number> result(numbers, numbers + count);
  for (Number& number : result) number -= base;
  return result;
}

TEST(CInterface, AnswersTheFurtherQueriesAsTheCppInterfaceDoes) {
  const scenes::Mesh mesh = scenes::folded_sheets(600, 3);
  std::vector<std::uint8_t> active(mesh.segment_count(), 1);
  for (std::size_t s = 0; s < active.size(); s += 7) active[s] = 0;
  Scene scene = mesh.scene();
  scene.segment_active = active;
  const auto as_vector = [](const auto& array) { return std::vector(array.begin(), array.end()); };
  for (const Index base : {0, 1}) {
    for (const bool exclude : {false, true}) {
      const Program program(mesh, base);
      cellsearch_handle* handle = program.handle.get();
      ASSERT_EQ(cellsearch_set_active(handle, active.data()), CELLSEARCH_OK);
      const int64_t* first = nullptr;
      const int32_t* entries = nullptr;
      int64_t count = 0;
      const auto rows = static_cast<int64_t>(mesh.segment_count()) + 1;

      const Pairs pairs = SegmentPairSearch({.exclude_shared_nodes = exclude}).find(scene);
      ASSERT_GT(pairs.count(), 100);
      ASSERT_EQ(cellsearch_segment_pairs(handle, exclude, &first, &entries, &count), CELLSEARCH_OK);
      EXPECT_EQ(numbers_from_zero(first, rows, base), as_vector(pairs.first));
      EXPECT_EQ(numbers_from_zero(entries, count, base), as_vector(pairs.second));

      const Array<Index> edges = unique_edges(scene.segments, active);
      ASSERT_EQ(cellsearch_edges(handle, &entries, &count), CELLSEARCH_OK);
      EXPECT_EQ(numbers_from_zero(entries, 2 * count, base), as_vector(edges));

      EdgeScene edge_scene;
      edge_scene.positions = scene.positions;
      edge_scene.edges = Edges(edges);
      edge_scene.expansion = 0.125;
      const Pairs edge_pairs = EdgePairSearch({.exclude_shared_nodes = exclude}).find(edge_scene);
      ASSERT_GT(edge_pairs.count(), 100);
      ASSERT_EQ(cellsearch_edge_pairs(handle, 0.125, exclude, &first, &entries, &count), CELLSEARCH_OK);
      EXPECT_EQ(numbers_from_zero(first, edge_pairs.rows() + 1, base), as_vector(edge_pairs.first));
      EXPECT_EQ(numbers_from_zero(entries, count, base), as_vector(edge_pairs.second));

      cellsearch_neighbours found{};
      for (const Index neighbours : {1, 4}) {
        const NearestNodes nearest =
            NearestSearch({.neighbours = neighbours, .largest_distance = 1.5, .exclude_connected = exclude})
                .find(scene);
        ASSERT_GT(nearest.count(), 100);
        ASSERT_EQ(cellsearch_nearest(handle, neighbours, 1.5, exclude, &found), CELLSEARCH_OK);
        EXPECT_EQ(numbers_from_zero(found.first, nearest.rows() + 1, base), as_vector(nearest.first));
        EXPECT_EQ(numbers_from_zero(found.node, found.count, base), as_vector(nearest.node));
        EXPECT_EQ(std::vector(found.distance, found.distance + found.count), as_vector(nearest.distance));
      }
      EXPECT_EQ(cellsearch_query(handle, nullptr, nullptr, nullptr), CELLSEARCH_NOT_BUILT);
    }
  }
}

TEST(CInterface, HandlesAreIndependent) {
  const scenes::Mesh mesh = scenes::folded_sheets(600, 3);
  Search search;
  const Candidates& expected = search.find(mesh.scene());
  std::vector<std::jthread> threads;
  threads.reserve(4);
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
}  // namespace cellsearch::c_interface_test
