// SPDX-License-Identifier: BSD-3-Clause
// Where the lattice of the production method ends or is as fine as double precision: three faults that it
// had.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "production_check.hpp"
#include "scenes.hpp"

namespace cellsearch::production_lattice_test {
namespace {

class ProductionLattice : public testing::TestWithParam<InstructionSet> {
 protected:
  static Search search_with_edge(double edge) {
    Settings settings{.instruction_set = GetParam()};
    if (edge > 0.0) settings.cell_edge = edge;
    return Search(settings);
  }
};

/// A segment whose four nodes are one.
void add_point_segment(scenes::Mesh& mesh, Index node) {
  mesh.add_segment(node, node, node, node);
}

// Fault A: cells are kept while nodes move by up to 5% of the extent, and then numbers beyond the end of the
// lattice were cut to the same.
TEST_P(ProductionLattice, TellsApartNodesThatDriftBeyondItsEndBetweenBuilds) {
  for (const double drift : {0.5, 10.0, 20.0, 24.0, 26.0, 60.0}) {
    for (const double width : {0.0, 5e-4}) {
      scenes::Mesh mesh;
      for (int node = 0; node <= 500; ++node) mesh.add_node(0.5 * width, node, 0.5 * width);
      mesh.positions[0] = mesh.positions[2] = 0.0;
      mesh.positions[3] = mesh.positions[5] = width;
      add_point_segment(mesh, 500);
      add_point_segment(mesh, 0);
      mesh.expansion = 1e-4;
      Search search = search_with_edge(1e-3);
      search.build(mesh.scene());
      const std::vector<double> at_rest = mesh.positions;
      for (const double side : {1.0, -1.0}) {
        mesh.positions = at_rest;
        const std::size_t moved = side > 0.0 ? 499 : 0;
        mesh.positions[3 * moved + 1] += side * 0.5 * drift;
        mesh.positions[3 * (moved + 1) + 1] += side * drift;
        EXPECT_EQ(difference_from_brute_force(search, mesh.scene()), "") << drift << ' ' << width;
      }
    }
  }
}

scenes::Mesh ribbon(int rows) {
  scenes::Mesh mesh;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < 5; ++column) mesh.add_node(column, row, 0.1 * ((7 * row + column) % 3));
  }
  for (Index row = 0; row + 1 < rows; ++row) {
    for (Index column = 0; column < 4; ++column) {
      const Index corner = 5 * row + column;
      mesh.add_segment(corner, corner + 1, corner + 6, corner + 5);
    }
  }
  mesh.expansion = 0.2;
  return mesh;
}

// Fault A on a mesh that is drawn out step by step.
TEST_P(ProductionLattice, FollowsARibbonThatIsDrawnOut) {
  for (const double edge : {0.0, 1.0, 0.01}) {
    scenes::Mesh mesh = ribbon(700);
    Search search = search_with_edge(edge);
    for (int build = 0; build < 6; ++build) {
      EXPECT_EQ(difference_from_brute_force(search, mesh.scene()), "") << "edge " << edge << ", " << build;
      for (std::size_t place = 1; place < mesh.positions.size(); place += 3) mesh.positions[place] *= 1.024;
    }
  }
}

// Fault B: a node that takes no part itself may be as far from the cells as it likes, and its segment still
// reach them by its expansion.
TEST_P(ProductionLattice, KnowsWhichLargeExpansionsOfFarUnlistedNodesReach) {
  const std::vector<double> crowd{0.0, 0.4, 0.5, 0.6, 1.0};
  for (const double far : {1e3, 1e6, 1e9, 1e12}) {
    for (const double part : {0.5, 0.9, 0.999, 0.9999, 1.0}) {
      for (const double edge : {0.0, 0.5, 2.0, 4.0}) {
        for (const double width : {0.5, 1.0}) {
          scenes::Mesh mesh;
          for (const double place : crowd) mesh.add_node(width * place, place, place);
          add_point_segment(mesh, mesh.add_node(far, 0.5, 0.5));
          add_point_segment(mesh, mesh.add_node(0.5, -far, 0.5));
          mesh.nodes = {{0, 1, 2, 3, 4}};
          mesh.expansion = part * far;
          Search search = search_with_edge(edge);
          EXPECT_EQ(difference_from_brute_force(search, mesh.scene()), "")
              << far << ' ' << part << ' ' << edge << ' ' << width;
        }
      }
    }
  }
}

// Fault B with the expansion of one segment only.
TEST_P(ProductionLattice, KnowsWhichLargeExpansionsOfOneSegmentReach) {
  scenes::Mesh mesh;
  scenes::Random random(1);
  mesh.nodes.emplace();
  for (Index node = 0; node < 1000; ++node) {
    mesh.add_node(random.uniform(0.0, 10.0), random.uniform(0.0, 10.0), random.uniform(0.0, 10.0));
    mesh.nodes->push_back(node);
    add_point_segment(mesh, node);
  }
  mesh.segment_expansion.assign(1000, 0.0);
  add_point_segment(mesh, mesh.add_node(1e12, 5.0, 5.0));
  mesh.segment_expansion.push_back(0.5e12);
  mesh.expansion = 0.2;
  Search search = search_with_edge(0.0);
  EXPECT_EQ(difference_from_brute_force(search, mesh.scene()), "");
  mesh.segment_expansion.back() = 1e12 - 5.0;
  EXPECT_EQ(difference_from_brute_force(search, mesh.scene()), "");
  EXPECT_GT(search.query().of(1000).size(), 100U);
}

// Fault B behind an unlisted node that is not finite: it must not hide how far the others are.
TEST_P(ProductionLattice, LooksPastUnlistedNodesThatAreNotFinite) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    for (const double part : {0.5, 0.9999, 1.0}) {
      scenes::Mesh mesh;
      for (const double place : {0.0, 0.5, 1.0}) mesh.add_node(place, place, place);
      add_point_segment(mesh, mesh.add_node(1e9, 0.5, 0.5));
      mesh.add_node(bad, bad, bad);
      mesh.add_node(0.25, 0.75, 0.5);
      add_point_segment(mesh, 0);
      mesh.segment_expansion = {part * 1e9, 0.6};
      mesh.nodes = {{0, 1, 2, 5}};
      Search search = search_with_edge(0.0);
      EXPECT_EQ(difference_from_brute_force(search, mesh.scene()), "") << bad << ' ' << part;
    }
  }
}

// Fault C: x * scale + offset is rounded once or twice, depending on the processor, and far from the origin
// that is more than one step of the lattice.
TEST_P(ProductionLattice, RoundsConservativelyFarFromTheOrigin) {
  const double step = 0x1p-23;  // of the numbers at 1e9
  scenes::Mesh mesh;
  mesh.add_node(1e9 + 20 * step, 1e9 + 26 * step, 1e9 + 8 * step);
  mesh.add_node(1e9 + 3 * step, 1e9 + 27 * step, 1e9 + 13 * step);
  add_point_segment(mesh, 0);
  mesh.expansion = 16.5 * step;
  Search search = search_with_edge(40 * step);
  EXPECT_EQ(difference_from_brute_force(search, mesh.scene()), "");
}

/// Nodes a few steps of double precision apart, around `origin` [length].
scenes::Mesh grains(std::uint64_t seed, double origin, int nodes, int steps) {
  scenes::Mesh mesh;
  scenes::Random random(seed);
  const double step = std::nextafter(std::fabs(origin), 1e300) - std::fabs(origin);
  const std::size_t spread = static_cast<std::size_t>(steps);
  const auto place = [&] { return origin + step * random.below(spread); };
  for (int node = 0; node < nodes; ++node) {
    const double x = place();
    const double y = place();
    mesh.add_node(x, y, place());
  }
  for (int segment = 0; segment < 30; ++segment)
    add_point_segment(mesh, random.below(static_cast<std::size_t>(nodes)));
  mesh.expansion = 0.5 * step * random.below(spread);
  return mesh;
}

// Fault C at random, with cells from the whole to one step of double precision, and with a far node, for
// which the crowd gets cells of its own.
TEST_P(ProductionLattice, IsExactWhereTheStepsOfDoublePrecisionShow) {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    const int number = static_cast<int>(seed);
    const double origin = 1e9 * (1 + number % 7) * (number % 2 == 0 ? -1.0 : 1.0);
    const int steps = 3 << (number % 16);
    scenes::Mesh mesh = grains(seed, origin, number % 3 == 0 ? 300 : 60, steps);
    if (number % 5 == 0) mesh.add_node(-origin, -origin, origin);
    const double step = std::nextafter(std::fabs(origin), 1e300) - std::fabs(origin);
    Search search = search_with_edge(number % 4 == 1 ? 0.25 * steps * step : number % 4 == 3 ? step : 0.0);
    EXPECT_EQ(difference_from_brute_force(search, mesh.scene()), "") << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Instructions, ProductionLattice, testing::ValuesIn(instruction_sets()),
                         [](const auto& set) { return std::string(name_of(set.param)); });

}  // namespace
}  // namespace cellsearch::production_lattice_test
