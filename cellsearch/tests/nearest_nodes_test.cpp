// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/nearest_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scenes.hpp"

namespace cellsearch::nearest_nodes_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// For each node all others, sorted, cut to k. Squares are formed from coordinates times `scale`, a power of
/// two, for meshes whose squares would be out of the range of numbers.
NearestNodes nearest_by_definition(const scenes::Mesh& mesh, const std::vector<std::uint8_t>& active,
                                   const NearestSettings& settings, double scale) {
  const std::size_t count = mesh.node_count();
  std::set<std::pair<Index, Index>> connected;
  for (std::size_t k = 0; k < mesh.segments.size() && settings.exclude_connected; ++k) {
    if (!active.empty() && active[k / 4] == 0) continue;
    for (std::size_t m = k / 4 * 4; m < k / 4 * 4 + 4; ++m)
      connected.insert({mesh.segments[k], mesh.segments[m]});
  }
  const auto takes_part = [&](std::size_t p) {
    return !mesh.nodes || std::binary_search(mesh.nodes->begin(), mesh.nodes->end(), static_cast<Index>(p));
  };
  NearestNodes result;
  result.first.push_back(0);
  for (std::size_t p = 0; p < count; ++p) {
    std::vector<std::pair<double, Index>> others;
    for (std::size_t q = 0; q < count; ++q) {
      if (p == q || !takes_part(p) || !takes_part(q)) continue;
      if (connected.count({static_cast<Index>(p), static_cast<Index>(q)}) != 0) continue;
      double square = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double d =
            mesh.positions[p * mesh.stride + axis] * scale - mesh.positions[q * mesh.stride + axis] * scale;
        square += d * d;
      }
      if (std::sqrt(square) / scale <= settings.largest_distance)
        others.emplace_back(square, static_cast<Index>(q));
    }
    std::sort(others.begin(), others.end());
    others.resize(std::min(others.size(), static_cast<std::size_t>(settings.neighbours)));
    for (const auto& [square, node] : others) {
      result.node.push_back(node);
      result.distance.push_back(std::sqrt(square) / scale);
    }
    result.first.push_back(result.count());
  }
  return result;
}

TEST(NearestNodes, AreSortedByDistanceThenNumber) {
  const std::vector<double> positions{0, 0, 0, 3, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0.5, 0};
  Scene scene;
  scene.positions = Positions(positions);
  NearestSearch search({.neighbours = 3});
  const NearestNodes& found = search.find(scene);
  EXPECT_EQ(found.first, (Array<Offset>{0, 3, 6, 9, 12, 15}));
  EXPECT_EQ(std::vector<Index>(found.of(0).begin(), found.of(0).end()), (std::vector<Index>{4, 2, 3}));
  EXPECT_EQ(std::vector<double>(found.distances_of(0).begin(), found.distances_of(0).end()),
            (std::vector<double>{0.5, 1.0, 1.0}));
  EXPECT_EQ(found.of(1)[0], 2);
  NearestSearch within({.neighbours = 3, .largest_distance = 0.5});
  EXPECT_EQ(within.find(scene).first, (Array<Offset>{0, 1, 1, 1, 1, 2}));
  const std::vector<Index> listed{0, 1, 3};
  scene.nodes = listed;
  EXPECT_EQ(search.find(scene).first, (Array<Offset>{0, 2, 4, 4, 6, 6}));
  EXPECT_EQ(search.find(scene).node, (Array<Index>{3, 1, 0, 3, 0, 1}));
  std::vector<double> sum(5, 0.0);
  search.visit(scene, [&](Index p, Index, double distance) { sum[static_cast<std::size_t>(p)] += distance; });
  EXPECT_EQ(sum[0], 4.0);
}

TEST(NearestNodes, MayLeaveOutThoseOfTheSameSegment) {
  const std::vector<double> positions{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 5};
  const std::vector<Index> connectivity{0, 1, 2, 3};
  Scene scene;
  scene.positions = Positions(positions);
  scene.segments = Segments(connectivity);
  NearestSearch search({.neighbours = 2, .exclude_connected = true});
  EXPECT_EQ(search.find(scene).first, (Array<Offset>{0, 1, 2, 3, 4, 6}));
  EXPECT_EQ(search.find(scene).node, (Array<Index>{4, 4, 4, 4, 0, 1}));
  const std::vector<std::uint8_t> active{0};
  scene.segment_active = active;
  EXPECT_EQ(search.find(scene).of(0)[0], 1);
}

TEST(NearestNodes, AgreeWithTheDefinitionOnEveryMesh) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(seed);
    scenes::Random random(seed);
    std::vector<std::uint8_t> active;
    if (random.below(2) == 0) {
      for (std::size_t s = 0; s < mesh.segment_count(); ++s)
        active.push_back(static_cast<std::uint8_t>(random.below(2)));
    }
    double scale = 1.0;
    double most = 0.0;
    for (std::size_t k = 0; k < mesh.positions.size(); ++k) {
      if (k % mesh.stride < 3) most = std::max(most, std::fabs(mesh.positions[k]));
    }
    if (most > 1e100) scale = 0x1p-993;
    if (most < 1e-100) scale = 0x1p+993;
    NearestSettings settings{.neighbours = 1 + random.below(12), .exclude_connected = random.below(2) == 0};
    if (random.below(2) == 0) settings.largest_distance = mesh.expansion * random.uniform(0.0, 10.0);
    if (random.below(20) == 0) settings.neighbours = std::numeric_limits<Index>::max();
    const NearestNodes expected = nearest_by_definition(mesh, active, settings, scale);
    Scene scene = mesh.scene();
    scene.segment_active = active;
    for (settings.threads = 1; settings.threads <= 4; ++settings.threads) {
      NearestSearch search(settings);
      ASSERT_EQ(search.find(scene), expected) << "mesh " << seed << " (" << mesh.name << ")";
      if (settings.threads == 3) {
        ASSERT_EQ(search.find(scene), expected) << "the second time";
      }
    }
  }
}

/// Clusters of points within clusters, each level `shrink` times smaller, and a point far away.
scenes::Mesh clusters(int count, double shrink, std::uint64_t seed) {
  scenes::Mesh mesh{.name = "clusters"};
  scenes::Random random(seed);
  mesh.add_node(1e12, 0.0, -1e12);
  while (static_cast<int>(mesh.node_count()) < count) {
    double size = 1.0;
    std::array<double, 3> at{0.0, 0.0, 0.0};
    for (int level = random.below(4); level >= 0; --level) {
      for (double& x : at) x += size * 0.25 * random.below(5);
      size *= shrink;
    }
    mesh.add_node(at[0] + random.uniform(0.0, size), at[1] + random.uniform(0.0, size), at[2]);
  }
  return mesh;
}

TEST(NearestNodes, AgreeWithTheDefinitionInClustersWithinClusters) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const scenes::Mesh mesh = clusters(700, seed % 2 == 0 ? 1e-3 : 0.2, seed);
    const NearestSettings settings{.neighbours = 5, .threads = 2};
    NearestSearch search(settings);
    ASSERT_EQ(search.find(mesh.scene()), nearest_by_definition(mesh, {}, settings, 1.0));
  }
}

// O(N), counted: distances computed per node do not grow with the mesh.
TEST(NearestNodes, LookAtAsManyNodesInALargeMeshAsInASmallOne) {
  std::vector<double> visits;
  for (const int nodes : {10000, 90000}) {
    const scenes::Mesh mesh = scenes::random_soup(nodes, 1, 1);
    NearestSearch search({.neighbours = 6});
    search.find(mesh.scene());
    visits.push_back(static_cast<double>(search.visits()) / nodes);
  }
  EXPECT_NEAR(visits[1] / visits[0], 1.0, 0.1);
  EXPECT_LT(visits[1], 150.0);
}

// A point far away puts all others into one cell of the order in space, which must go on inside that cell:
// else the first guesses are those of a random order.
TEST(NearestNodes, AreNotSlowedByAPointFarAway) {
  scenes::Mesh mesh = scenes::random_soup(60000, 1, 1);
  NearestSearch search({.neighbours = 4});
  search.find(mesh.scene());
  const Offset before = search.visits();
  mesh.add_node(1e9, -1e9, 1e9);
  search.find(mesh.scene());
  EXPECT_LT(static_cast<double>(search.visits()), 1.5 * static_cast<double>(before));
}

TEST(NearestNodes, RefuseBadInput) {
  EXPECT_THROW(NearestSearch({.neighbours = 0}), Error);
  EXPECT_THROW(NearestSearch({.largest_distance = -1.0}), Error);
  EXPECT_THROW(NearestSearch({.largest_distance = std::nan("")}), Error);
  EXPECT_THROW(NearestSearch({.threads = 0}), Error);
  scenes::Mesh mesh = scenes::random_soup(50, 20, 1);
  mesh.positions[3 * 31 + 2] = infinity;
  NearestSearch search;
  try {
    search.find(mesh.scene());
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::NonFiniteCoordinate);
    EXPECT_EQ(error.index(), 31);
  }
  EXPECT_EQ(search.take().rows(), 0);
}

TEST(NearestNodes, OfOneNodeAreNone) {
  scenes::Mesh mesh;
  mesh.add_node(1.0, 2.0, 3.0);
  NearestSearch search({.neighbours = 4});
  EXPECT_EQ(search.find(mesh.scene()).first, (Array<Offset>{0, 0}));
  mesh.nodes.emplace();
  EXPECT_EQ(search.find(mesh.scene()).first, (Array<Offset>{0, 0}));
}

}  // namespace
}  // namespace cellsearch::nearest_nodes_test
