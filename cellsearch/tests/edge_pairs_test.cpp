// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/edge_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scenes.hpp"

namespace cellsearch::edge_pairs_test {
namespace {

TEST(UniqueEdges, CountASharedEdgeOnceAndATrianglesThree) {
  const std::vector<Index> connectivity{0, 1, 5, 4, 1, 2, 6, 5, 6, 2, 3, 3};
  EXPECT_EQ(unique_edges(Segments(connectivity)),
            (Array<Index>{0, 1, 0, 4, 1, 2, 1, 5, 2, 3, 2, 6, 3, 6, 4, 5, 5, 6}));
  const std::vector<std::uint8_t> active{0, 1, 1};
  EXPECT_EQ(unique_edges(Segments(connectivity), active), (Array<Index>{1, 2, 1, 5, 2, 3, 2, 6, 3, 6, 5, 6}));
  EXPECT_TRUE(unique_edges(Segments()).empty());
}

TEST(UniqueEdges, AgreeWithASetOnEveryMesh) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(seed);
    std::set<std::pair<Index, Index>> expected;
    for (std::size_t s = 0; s < mesh.segment_count(); ++s) {
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const Index a = mesh.segments[4 * s + corner];
        const Index b = mesh.segments[4 * s + (corner + 1) % 4];
        if (a != b) expected.insert(std::minmax(a, b));
      }
    }
    Array<Index> written;
    for (const auto& [a, b] : expected) written.insert(written.end(), {a, b});
    EXPECT_EQ(unique_edges(Segments(mesh.segments)), written) << mesh.name;
  }
}

TEST(UniqueEdges, HoldForTheLargestNodeNumbers) {
  constexpr Index most = std::numeric_limits<Index>::max();
  const std::vector<Index> connectivity{most, 0, most - 1, most - 1};
  EXPECT_EQ(unique_edges(Segments(connectivity)), (Array<Index>{0, most - 1, 0, most, most - 1, most}));
}

TEST(UniqueEdges, RefuseBadInput) {
  const std::vector<Index> negative{0, 1, 2, 3, 0, 1, -2, 3};
  try {
    unique_edges(Segments(negative));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadConnectivity);
    EXPECT_EQ(error.index(), 1);
  }
  EXPECT_THROW(unique_edges(Segments(std::span(negative).first(7))), Error);
  const std::vector<std::uint8_t> active{1};
  EXPECT_THROW(unique_edges(Segments(negative), active), Error);
}

/// Edges with the memory that an EdgeScene views.
struct Wires {
  std::vector<double> positions{};
  std::size_t stride = 3;
  Array<Index> edges{};
  double expansion = 0.0;
  std::vector<double> edge_expansion{};
  std::optional<std::vector<Index>> subset{};
  Index groups = 0;
  std::vector<Index> group{};
  std::vector<std::uint8_t> allow{};

  EdgeScene scene() const {
    EdgeScene scene;
    scene.positions = Positions(positions, stride);
    scene.edges = Edges(edges);
    scene.expansion = expansion;
    scene.edge_expansion = edge_expansion;
    if (subset) scene.subset = *subset;
    scene.group_count = groups;
    scene.edge_group = group;
    scene.allow = allow;
    return scene;
  }
};

Pairs pairs_by_definition(const Wires& wires, bool apart) {
  const std::size_t count = wires.edges.size() / 2;
  const auto x = [&](std::size_t edge, std::size_t end, std::size_t axis) {
    return wires.positions[static_cast<std::size_t>(wires.edges[2 * edge + end]) * wires.stride + axis];
  };
  const auto lo = [&](std::size_t edge, std::size_t axis) {
    const double c = wires.expansion + (wires.edge_expansion.empty() ? 0.0 : wires.edge_expansion[edge]);
    return std::min(x(edge, 0, axis), x(edge, 1, axis)) - c;
  };
  const auto hi = [&](std::size_t edge, std::size_t axis) {
    const double c = wires.expansion + (wires.edge_expansion.empty() ? 0.0 : wires.edge_expansion[edge]);
    return std::max(x(edge, 0, axis), x(edge, 1, axis)) + c;
  };
  const auto takes_part = [&](std::size_t edge) {
    return !wires.subset ||
           std::count(wires.subset->begin(), wires.subset->end(), static_cast<Index>(edge)) != 0;
  };
  Pairs result;
  result.first.push_back(0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count && takes_part(i); ++j) {
      const auto own = wires.edges.begin() + static_cast<std::ptrdiff_t>(2 * i);
      if (apart && (std::count(own, own + 2, wires.edges[2 * j]) != 0 ||
                    std::count(own, own + 2, wires.edges[2 * j + 1]) != 0)) {
        continue;
      }
      bool touch = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        touch = touch && !(lo(i, axis) > hi(j, axis)) && !(lo(j, axis) > hi(i, axis));
      }
      if (wires.groups > 0) {
        const Index one = wires.group[i] * wires.groups + wires.group[j];
        const Index other = wires.group[j] * wires.groups + wires.group[i];
        touch = touch &&
                wires.allow[static_cast<std::size_t>(one)] + wires.allow[static_cast<std::size_t>(other)] > 0;
      }
      if (touch && takes_part(j)) result.second.push_back(static_cast<Index>(j));
    }
    result.first.push_back(result.count());
  }
  return result;
}

// A cross of two edges 0.5 apart, and a third edge that continues the first.
TEST(EdgePairs, AreBoxesThatTouchWithoutACommonNode) {
  Wires wires;
  wires.positions = {-1, 0, 0, 1, 0, 0, 0, -1, 0.5, 0, 1, 0.5, 3, 0, 0};
  wires.edges = {0, 1, 2, 3, 1, 4};
  EdgePairSearch search;
  wires.expansion = 0.25;
  EXPECT_EQ(search.find(wires.scene()).first, (Array<Offset>{0, 1, 1, 1}));
  EXPECT_EQ(search.find(wires.scene()).second, (Array<Index>{1}));
  wires.edge_expansion = {0.0, 0.75, 0.0};  // now the second box begins at z = -0.5, x = -1 .. 1
  EXPECT_EQ(search.find(wires.scene()).second, (Array<Index>{1, 2}));
  EXPECT_EQ(EdgePairSearch({.exclude_shared_nodes = false}).find(wires.scene()).second,
            (Array<Index>{1, 2, 2}));
  wires.subset = {{1, 2}};
  EXPECT_EQ(search.find(wires.scene()).first, (Array<Offset>{0, 0, 1, 1}));
  wires.subset = std::vector<Index>{};
  EXPECT_EQ(search.find(wires.scene()).first, (Array<Offset>{0, 0, 0, 0}));
}

TEST(EdgePairs, AgreeWithTheDefinitionOnEveryMesh) {
  std::vector<EdgePairSearch> searches;
  for (int threads = 1; threads <= 4; ++threads) {
    searches.emplace_back(EdgePairSettings{.exclude_shared_nodes = threads != 3, .threads = threads});
  }
  Offset pairs = 0;
  for (std::uint64_t seed = 0; seed < 64; ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(seed);
    scenes::Random random(seed);
    Wires wires{mesh.positions, mesh.stride, unique_edges(Segments(mesh.segments)), mesh.expansion};
    const std::size_t count = wires.edges.size() / 2;
    if (random.below(2) == 0) {
      for (std::size_t e = 0; e < count; ++e) {
        wires.edge_expansion.push_back(random.uniform(0.0, 2.0) * mesh.expansion);
      }
    }
    if (random.below(3) == 0) {
      wires.subset.emplace();
      for (std::size_t e = 0; e < count; ++e) {
        if (random.below(2) == 0) wires.subset->push_back(static_cast<Index>(e));
      }
    }
    if (random.below(2) == 0) {
      wires.groups = 2;
      for (std::size_t e = 0; e < count; ++e) wires.group.push_back(random.below(2));
      for (int k = 0; k < 4; ++k) wires.allow.push_back(static_cast<std::uint8_t>(random.below(2)));
    }
    const Pairs apart = pairs_by_definition(wires, true);
    const Pairs all = pairs_by_definition(wires, false);
    pairs += apart.count();
    for (std::size_t k = 0; k < searches.size(); ++k) {
      ASSERT_EQ(searches[k].find(wires.scene()), k == 2 ? all : apart)
          << "mesh " << seed << " (" << mesh.name << ")";
    }
  }
  EXPECT_GT(pairs, 20000);
}

TEST(EdgePairs, AgreeWithTheDefinitionForLengthsMixedAThousandfold) {
  EdgePairSearch search({.threads = 2});
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    scenes::Random random(seed);
    Wires wires;
    const Index count = 1500;
    for (Index e = 0; e < count; ++e) {
      const double length = std::pow(1000.0, -random.uniform(0.0, 1.0));
      std::array<double, 3> at{};
      for (double& x : at) x = random.uniform(0.0, 2.0);
      wires.positions.insert(wires.positions.end(), at.begin(), at.end());
      for (double& x : at) x += random.uniform(-length, length);
      wires.positions.insert(wires.positions.end(), at.begin(), at.end());
      wires.edges.insert(wires.edges.end(), {2 * e, 2 * e + 1});
    }
    const Pairs expected = pairs_by_definition(wires, true);
    EXPECT_GT(expected.count(), 1000);
    EXPECT_EQ(search.find(wires.scene()), expected);
  }
}

void expect_error(const Wires& wires, ErrorKind kind, Index index, const char* part_of_message) {
  EdgePairSearch search({.threads = 2});
  try {
    search.find(wires.scene());
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_EQ(error.index(), index) << error.what();
    EXPECT_NE(std::string(error.what()).find(part_of_message), std::string::npos) << error.what();
  }
  EXPECT_EQ(search.take().rows(), 0);
}

TEST(EdgePairs, RefuseBadInput) {
  Wires good;
  good.positions.assign(300, 0.5);
  for (Index e = 0; e < 99; ++e) good.edges.insert(good.edges.end(), {e, e + 1});
  const auto spoilt = [&](const auto& spoil) {
    Wires bad = good;
    spoil(bad);
    return bad;
  };
  expect_error(spoilt([](Wires& w) { w.edges.pop_back(); }), ErrorKind::BadLayout, -1, "multiple of 2");
  expect_error(spoilt([](Wires& w) { w.edges[31] = w.edges[90] = 100; }), ErrorKind::BadConnectivity, 15,
               "Edge 15 joins the nodes 15 and 100");
  expect_error(spoilt([](Wires& w) { w.positions[200] = std::nan(""); }), ErrorKind::NonFiniteCoordinate, 66,
               "Node 66 ");
  expect_error(spoilt([](Wires& w) { w.positions.clear(); }), ErrorKind::EmptyInput, -1, "node");
  expect_error(spoilt([](Wires& w) { w.expansion = -1.0; }), ErrorKind::BadExpansion, -1, "expansion");
  expect_error(spoilt([](Wires& w) { w.edge_expansion.assign(98, 0.0); }), ErrorKind::BadLayout, -1,
               "edge expansions");
  expect_error(spoilt([](Wires& w) {
                 w.edge_expansion.assign(99, 0.0);
                 w.edge_expansion[12] = std::nan("");
               }),
               ErrorKind::BadExpansion, 12, "edge 12");
  expect_error(spoilt([](Wires& w) { w.subset = {{3, 3}}; }), ErrorKind::BadNodeList, 1, "entry 1 is 3");
  expect_error(spoilt([](Wires& w) { w.subset = {{3, 99}}; }), ErrorKind::BadNodeList, 1, "entry 1 is 99");
  expect_error(spoilt([](Wires& w) {
                 w.groups = 1;
                 w.allow = {1};
                 w.group.assign(99, 0);
                 w.group[98] = 1;
               }),
               ErrorKind::BadSegmentGroup, 98, "Edge 98 belongs to group 1");
  expect_error(spoilt([](Wires& w) { w.groups = 1; }), ErrorKind::BadLayout, -1, "edge groups");
}

}  // namespace
}  // namespace cellsearch::edge_pairs_test
