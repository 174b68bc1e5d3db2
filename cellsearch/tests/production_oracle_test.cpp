// SPDX-License-Identifier: BSD-3-Clause
// The production method with every instruction set and number of threads against brute force, which
// oracle_test.cpp holds to the definition.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cellsearch/error.hpp"
#include "family_test_name.hpp"
#include "production_check.hpp"
#include "scenes.hpp"

namespace cellsearch::production_oracle_test {
namespace {

std::string described(InstructionSet set, int threads) {
  return std::string(name_of(set)) + ", " + std::to_string(threads) + " threads";
}

/// Searches the mesh with every instruction set, on each of these numbers of threads.
void expect_rows(const Candidates& expected, const scenes::Mesh& mesh,
                 const std::vector<int>& numbers_of_threads, std::optional<double> cell_edge = std::nullopt) {
  for (const InstructionSet set : instruction_sets()) {
    for (const int threads : numbers_of_threads) {
      Search search(
          {.domain = mesh.domain, .cell_edge = cell_edge, .instruction_set = set, .threads = threads});
      EXPECT_EQ(difference_from(expected, search, mesh.scene()), "") << described(set, threads);
      EXPECT_EQ(search.query(), expected) << "the second query differs, " << described(set, threads);
      EXPECT_EQ(search.statistics().candidates, 2 * expected.pairs());
    }
  }
}

void expect_agreement(const scenes::Mesh& mesh, const std::vector<int>& numbers_of_threads) {
  expect_rows(by_brute_force(mesh.scene(), {.domain = mesh.domain}), mesh, numbers_of_threads);
}

// Two numbers of threads for a mesh, and all of 1-4 for each kind of mesh.
TEST(ProductionOracle, AgreesOnEveryMeshAndInstructionSet) {
  for (int seed = 0; seed < 200 && !HasFailure(); ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(5000 + static_cast<std::uint64_t>(seed));
    SCOPED_TRACE("mesh " + std::to_string(5000 + seed) + " (" + mesh.name + ")");
    const int round = seed / scenes::kinds();
    expect_agreement(mesh, {1 + round % 4, 1 + (round + 2) % 4});
  }
}

TEST(ProductionOracle, AgreesOnThousandsOfMeshesAndEveryNumberOfThreadsNightly) {
  for (std::uint64_t seed = 5200; seed < 5200 + 2400 && !HasFailure(); ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(seed);
    SCOPED_TRACE("mesh " + std::to_string(seed) + " (" + mesh.name + ")");
    expect_agreement(mesh, {1, 2, 3, 4});
  }
}

class ProductionScene : public testing::TestWithParam<scenes::Family> {};

TEST_P(ProductionScene, IsSearchedExactly) {
  std::uint64_t seed = 40;
  for (const int nodes : {2000, 5000}) {
    scenes::Mesh mesh = GetParam().make(nodes, ++seed);
    ASSERT_GT(by_brute_force(mesh.scene()).pairs(), nodes / 10);
    expect_agreement(mesh, {1, 3});
    mesh.shuffle(seed);
    SCOPED_TRACE("shuffled");
    expect_agreement(mesh, {1, 4});
  }
}

// Also where hardly anything or nearly everything is a candidate, and where all axes are alike.
TEST_P(ProductionScene, IsSearchedExactlyWithOtherExpansions) {
  scenes::Mesh mesh = GetParam().make(2000, 7);
  mesh.rotate(0.25, 0.25);
  for (const double factor : {0.0, 1e-3, 10.0, 1e6}) {
    SCOPED_TRACE(factor);
    scenes::Mesh changed = mesh;
    changed.expansion *= factor;
    for (double& expansion : changed.segment_expansion) expansion *= factor;
    changed.segments.resize(factor > 100.0 ? 4 * 50 : mesh.segments.size());
    if (!changed.segment_expansion.empty()) changed.segment_expansion.resize(changed.segment_count());
    expect_agreement(changed, {2});
  }
}

// The user's cells may be of any size: much too small or too large ones cost time, never a pair.
TEST_P(ProductionScene, IsSearchedExactlyWithCellsOfAnySize) {
  const scenes::Mesh mesh = GetParam().make(2000, 8);
  const Candidates expected = by_brute_force(mesh.scene());
  for (const double edge : {1e-300, 1e-12, 1e-6, 1e-2, 0.3, 5.0, 100.0, 1e9, 1e300}) {
    SCOPED_TRACE(edge);
    expect_rows(expected, mesh, {2}, edge);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, ProductionScene,
                         testing::ValuesIn(scenes::families().begin(), scenes::families().end()),
                         scenes::test_name);

TEST(ProductionOracle, AgreesWithCellsOfAnySizeOnSmallMeshes) {
  for (std::uint64_t seed = 300; seed < 396; ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(seed);
    SCOPED_TRACE("mesh " + std::to_string(seed) + " (" + mesh.name + ")");
    const Candidates expected = by_brute_force(mesh.scene(), {.domain = mesh.domain});
    for (const double edge : {1e-308, 1e-9, 0.05, 2.0, 1e4, 1e308}) expect_rows(expected, mesh, {1}, edge);
  }
}

TEST(ProductionOracle, RefusesCellEdgesThatAreNoLengths) {
  for (const double edge :
       {0.0, -0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    try {
      const Search search({.cell_edge = edge});
      FAIL() << "no error for " << edge;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadSetting) << error.what();
    }
  }
}

/// A crowd of nodes, and `count` times the same segment around it.
scenes::Mesh long_rows(int count, int nodes) {
  scenes::Mesh mesh;
  scenes::Random random(3);
  for (int node = 0; node < nodes; ++node) {
    const double x = random.uniform(0.0, 10.0);
    const double y = random.uniform(0.0, 10.0);
    mesh.add_node(x, y, random.uniform(0.0, 0.1));
  }
  const Index first = mesh.add_node(0.0, 0.0, 0.0);
  mesh.add_node(10.0, 0.0, 0.0);
  mesh.add_node(10.0, 10.0, 0.0);
  mesh.add_node(0.0, 10.0, 0.0);
  for (int segment = 0; segment < count; ++segment) mesh.add_segment(first, first + 1, first + 2, first + 3);
  mesh.expansion = 0.1;
  return mesh;
}

TEST(ProductionRows, MayBeThousandsLong) {
  for (const int count : {1, 64, 100, 300}) {
    const scenes::Mesh mesh = long_rows(count, 5000);
    const Candidates expected = by_brute_force(mesh.scene());
    ASSERT_EQ(expected.pairs(), Offset{5000} * count);
    expect_agreement(mesh, {1, 2});
  }
}

// Between rows of a handful, where a batch of segments has room for few.
TEST(ProductionRows, MayBeThousandsLongAmongShortOnes) {
  scenes::Mesh mesh = scenes::folded_sheets(5000, 4);
  const scenes::Mesh crowd = long_rows(0, 5000);
  const Index shift = static_cast<Index>(mesh.node_count());
  mesh.positions.insert(mesh.positions.end(), crowd.positions.begin(), crowd.positions.end());
  const std::vector<Index> ordinary = std::exchange(mesh.segments, {});
  for (std::size_t segment = 0; 4 * segment < ordinary.size(); ++segment) {
    const Index* own = &ordinary[4 * segment];
    mesh.add_segment(own[0], own[1], own[2], own[3]);
    const Index corner = shift + 5000;
    if (segment % 97 == 5) mesh.add_segment(corner, corner + 1, corner + 2, corner + 3);
    if (segment % 640 == 639) mesh.add_segment(shift, shift + 1, corner, corner);
  }
  expect_agreement(mesh, {1, 2});
}

TEST(ProductionRows, MayHoldAllOfManyCoincidentNodes) {
  scenes::Mesh mesh;
  for (int node = 0; node < 20000; ++node) mesh.add_node(1.25, -3.5, 1e5 / 3.0);
  for (Index segment = 0; segment < 130; ++segment) mesh.add_segment(segment, 19999, 7, 7);
  for (const double expansion : {0.0, 0.5}) {
    mesh.expansion = expansion;
    expect_agreement(mesh, {1, 2});
  }
  // Apart from a few, so that there are cells of which one holds nearly all.
  for (const double place : {-1.0, 2.0, 1e7}) mesh.add_segment(mesh.add_node(place, place, place), 9, 9, 9);
  expect_agreement(mesh, {1, 2});
  mesh.add_segment(mesh.add_node(1.25 + 1e-9, -3.5, 1e5 / 3.0), 9, 9, 9);
  mesh.expansion = 0.0;
  expect_agreement(mesh, {1, 2});
}

/// What is wrong with a scene, and what must be named.
struct Fault {
  ErrorKind kind;
  Index index;
};

void expect_error(Search& search, const scenes::Mesh& bad, const Fault& fault) {
  try {
    search.build(bad.scene());
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), fault.kind) << error.what();
    EXPECT_EQ(error.index(), fault.index) << error.what();
  }
  EXPECT_EQ(search.query().segments(), 0);
}

// Errors must not depend on how many good builds there were: some of these keep the cells of the last one.
TEST(ProductionErrors, NameTheSmallestPlaceInAnyBuild) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const scenes::Mesh good = scenes::folded_sheets(3000, 9);
  const Candidates expected = by_brute_force(good.scene());
  std::vector<std::pair<scenes::Mesh, Fault>> faults(6, {good, {}});
  const auto spoil = [&](std::size_t at, ErrorKind kind, Index index) -> scenes::Mesh& {
    faults[at].second = {kind, index};
    return faults[at].first;
  };
  scenes::Mesh& two_nans = spoil(0, ErrorKind::NonFiniteCoordinate, 1700);
  two_nans.positions[3 * 1700 + 2] = two_nans.positions[3 * 2900] = nan;
  scenes::Mesh& far = spoil(1, ErrorKind::NonFiniteCoordinate, 0);
  far.positions[1] = -infinity;
  far.positions[3 * 8] = nan;
  spoil(2, ErrorKind::NonFiniteCoordinate, 11).positions[3 * 11] = infinity;
  scenes::Mesh& too_high = spoil(3, ErrorKind::BadConnectivity, 21);
  too_high.segments[4 * 21 + 3] = static_cast<Index>(good.node_count());
  too_high.segments[4 * 1500] = -7;
  spoil(4, ErrorKind::BadConnectivity, 0).segments[1] = std::numeric_limits<Index>::min();
  scenes::Mesh& listed = spoil(5, ErrorKind::NonFiniteCoordinate, 40);
  listed.nodes = {{40, 41}};
  listed.positions[3 * 40] = listed.positions[3 * 41] = nan;
  for (const InstructionSet set : instruction_sets()) {
    for (const int threads : {1, 4}) {
      SCOPED_TRACE(described(set, threads));
      Search search({.instruction_set = set, .threads = threads});
      for (int good_builds = 0; good_builds < 4; ++good_builds) {
        for (const auto& [bad, fault] : faults) {
          expect_error(search, bad, fault);
          for (int build = 0; build < good_builds; ++build)
            EXPECT_EQ(difference_from(expected, search, good.scene()), "");
        }
      }
    }
  }
}

}  // namespace
}  // namespace cellsearch::production_oracle_test
