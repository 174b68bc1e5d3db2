// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/segment_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "scenes.hpp"

namespace cellsearch::segment_pairs_test {
namespace {

/// The bounding box of a segment, expanded, written out from the mesh's own arrays: lo and hi by axis.
std::array<double, 6> box_of(const scenes::Mesh& mesh, std::size_t segment) {
  const double c =
      mesh.segment_expansion.empty() ? mesh.expansion : mesh.expansion + mesh.segment_expansion[segment];
  std::array<double, 6> box{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto x = [&](std::size_t corner) {
      return mesh
          .positions[static_cast<std::size_t>(mesh.segments[4 * segment + corner]) * mesh.stride + axis];
    };
    box[axis] = std::min({x(0), x(1), x(2), x(3)}) - c;
    box[axis + 3] = std::max({x(0), x(1), x(2), x(3)}) + c;
  }
  return box;
}

struct Options {
  bool apart = true;
  std::vector<std::uint8_t> active{};
  Index groups = 0;
  std::vector<Index> group{};
  std::vector<std::uint8_t> allow{};
};

bool is_pair(const scenes::Mesh& mesh, const Options& options, std::size_t i, std::size_t j) {
  if (!options.active.empty() && (options.active[i] == 0 || options.active[j] == 0)) return false;
  if (options.apart) {
    for (std::size_t a = 4 * i; a < 4 * i + 4; ++a) {
      if (std::count(&mesh.segments[4 * j], &mesh.segments[4 * j] + 4, mesh.segments[a]) != 0) return false;
    }
  }
  if (options.groups > 0) {
    const Index one = options.group[i] * options.groups + options.group[j];
    const Index other = options.group[j] * options.groups + options.group[i];
    if (options.allow[static_cast<std::size_t>(one)] == 0 &&
        options.allow[static_cast<std::size_t>(other)] == 0) {
      return false;
    }
  }
  return true;
}

Pairs pairs_by_definition(const scenes::Mesh& mesh, const Options& options) {
  std::vector<std::array<double, 6>> boxes;
  for (std::size_t s = 0; s < mesh.segment_count(); ++s) boxes.push_back(box_of(mesh, s));
  Pairs result;
  result.first.push_back(0);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      bool touch = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        touch = touch && boxes[i][axis] <= boxes[j][axis + 3] && boxes[j][axis] <= boxes[i][axis + 3];
      }
      if (touch && is_pair(mesh, options, i, j)) result.second.push_back(static_cast<Index>(j));
    }
    result.first.push_back(result.count());
  }
  return result;
}

Scene scene_of(const scenes::Mesh& mesh, const Options& options) {
  Scene scene = mesh.scene();
  scene.segment_active = options.active;
  scene.groups.count = options.groups;
  scene.groups.segment_group = options.group;
  scene.groups.allow = options.allow;
  return scene;
}

Options random_options(const scenes::Mesh& mesh, scenes::Random& random) {
  Options options;
  options.apart = random.below(2) == 0;
  if (random.below(2) == 0) {
    for (std::size_t s = 0; s < mesh.segment_count(); ++s) {
      options.active.push_back(static_cast<std::uint8_t>(random.below(3)));
    }
  }
  if (random.below(2) == 0) {
    options.groups = 3;
    for (std::size_t s = 0; s < mesh.segment_count(); ++s) options.group.push_back(random.below(3));
    for (int entry = 0; entry < 9; ++entry) {
      options.allow.push_back(static_cast<std::uint8_t>(random.below(3) == 0 ? 1 : 0));
    }
  }
  return options;
}

// Three unit squares in a row, the third one 0.25 behind the second, and a large one over all of them.
TEST(SegmentPairs, AreTheTerritoriesThatTouch) {
  const std::vector<double> positions{0, 0,    0, 1, 0,  0,    1,    1, 0,  0,    1, 0, 2,
                                      0, 0,    2, 1, 0,  2.25, 0,    0, 3,  0,    0, 3, 1,
                                      0, 2.25, 1, 0, -9, -9,   0.25, 9, -9, 0.25, 9, 9, 0.25};
  const std::vector<Index> connectivity{0, 1, 2, 3, 1, 4, 5, 2, 6, 7, 8, 9, 10, 11, 12, 12};
  Scene scene;
  scene.positions = Positions(positions);
  scene.segments = Segments(connectivity);
  SegmentPairSearch search;
  EXPECT_EQ(search.find(scene).count(), 0);
  scene.expansion = 0.125;
  EXPECT_EQ(search.find(scene).first, (Array<Offset>{0, 1, 3, 4, 4}));
  EXPECT_EQ(search.find(scene).second, (Array<Index>{3, 2, 3, 3}));
  SegmentPairSearch with_neighbours({.exclude_shared_nodes = false});
  EXPECT_EQ(with_neighbours.find(scene).second, (Array<Index>{1, 3, 2, 3, 3}));
  std::vector<std::pair<Index, Index>> visited;
  search.visit(scene, [&](Index i, Index j) { visited.emplace_back(i, j); });
  EXPECT_EQ(visited, (std::vector<std::pair<Index, Index>>{{0, 3}, {1, 2}, {1, 3}, {2, 3}}));
  scene.expansion = 0.1249;
  EXPECT_EQ(search.find(scene).count(), 0);
}

TEST(SegmentPairs, AgreeWithTheDefinitionOnEveryMesh) {
  std::vector<SegmentPairSearch> searches;
  for (int threads = 1; threads <= 4; ++threads) {
    searches.emplace_back(SegmentPairSettings{.threads = threads});
    searches.emplace_back(SegmentPairSettings{.exclude_shared_nodes = false, .threads = threads});
  }
  Offset pairs = 0;
  for (std::uint64_t seed = 0; seed < 64; ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(seed);
    scenes::Random random(seed);
    Options options = random_options(mesh, random);
    options.apart = true;
    const Pairs apart = pairs_by_definition(mesh, options);
    options.apart = false;
    const Pairs all = pairs_by_definition(mesh, options);
    pairs += apart.count();
    for (std::size_t k = 0; k < searches.size(); ++k) {
      ASSERT_EQ(searches[k].find(scene_of(mesh, options)), k % 2 == 0 ? apart : all)
          << "mesh " << seed << " (" << mesh.name << "), " << 1 + k / 2 << " threads";
    }
  }
  EXPECT_GT(pairs, 20000);
}

/// Squares of random direction whose edges range over `ratio`, evenly in the exponent; in a cube of edge
/// `size`, but half of them about as near to some square before them as they are large (if `clustered`).
scenes::Mesh squares_of_many_sizes(int count, double size, double ratio, bool clustered, std::uint64_t seed) {
  scenes::Mesh mesh{.name = "squares of many sizes"};
  scenes::Random random(seed);
  for (int square = 0; square < count; ++square) {
    const double edge = std::pow(ratio, -random.uniform(0.0, 1.0));
    std::array<double, 3> at{};
    for (double& x : at) x = random.uniform(0.0, size);
    if (clustered && square > 0 && random.below(2) == 0) {
      const std::size_t node = static_cast<std::size_t>(random.below(mesh.node_count()));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        at[axis] = mesh.positions[3 * node + axis] + random.uniform(-edge, edge);
      }
    }
    const std::size_t flat = static_cast<std::size_t>(random.below(3));
    std::array<Index, 4> nodes{};
    for (std::size_t corner = 0; corner < 4; ++corner) {
      std::array<double, 3> p = at;
      if (corner == 1 || corner == 2) p[(flat + 1) % 3] += edge;
      if (corner >= 2) p[(flat + 2) % 3] += edge;
      nodes[corner] = mesh.add_node(p[0], p[1], p[2]);
    }
    mesh.add_segment(nodes[0], nodes[1], nodes[2], nodes[3]);
  }
  return mesh;
}

TEST(SegmentPairs, AgreeWithTheDefinitionForSizesMixedAThousandfold) {
  SegmentPairSearch search({.threads = 2});
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    scenes::Mesh mesh = squares_of_many_sizes(1200, 2.0, seed % 2 == 0 ? 1000.0 : 1e30, true, seed);
    if (seed % 3 == 0) mesh.expansion = 0.01;
    const Pairs expected = pairs_by_definition(mesh, {});
    EXPECT_GT(expected.count(), 300);
    EXPECT_EQ(search.find(mesh.scene()), expected);
  }
}

// Expansions may be so large that boxes become infinite.
TEST(SegmentPairs, SurviveInfiniteBoxes) {
  scenes::Mesh mesh = scenes::random_soup(60, 40, 2);
  for (double& x : mesh.positions) x *= 1e307;
  mesh.expansion = 1e305;
  mesh.segment_expansion.assign(40, 0.0);
  for (std::size_t s = 0; s < 40; s += 7) mesh.segment_expansion[s] = 1.79e308;
  ASSERT_EQ(box_of(mesh, 7)[3], std::numeric_limits<double>::infinity());
  SegmentPairSearch search;
  EXPECT_EQ(search.find(mesh.scene()), pairs_by_definition(mesh, {}));
}

// O(N), counted: what is looked at per segment does not grow with the mesh, whatever the sizes.
TEST(SegmentPairs, LookAtAsManyBoxesPerSegmentInALargeMeshAsInASmallOne) {
  for (const double ratio : {1.0, 1000.0}) {
    std::vector<double> visits;
    for (const int count : {10000, 80000}) {
      // The same number of squares per volume.
      const scenes::Mesh mesh = squares_of_many_sizes(count, 0.5 * std::cbrt(count), ratio, false, 1);
      SegmentPairSearch search;
      search.find(mesh.scene());
      visits.push_back(static_cast<double>(search.visits()) / count);
    }
    EXPECT_NEAR(visits[1] / visits[0], 1.0, 0.1) << ratio;
    EXPECT_LT(visits[1], 60.0) << ratio;
  }
}

void expect_error(const Scene& scene, ErrorKind kind, Index index) {
  SegmentPairSearch search({.threads = 2});
  try {
    search.find(scene);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_EQ(error.index(), index) << error.what();
  }
  EXPECT_EQ(search.take().rows(), 0);
}

TEST(SegmentPairs, RefuseBadInput) {
  scenes::Mesh mesh = scenes::random_soup(60, 40, 1);
  mesh.segments[4 * 7 + 1] = 60;
  expect_error(mesh.scene(), ErrorKind::BadConnectivity, 7);
  mesh.segments[4 * 7 + 1] = 9;
  mesh.positions[3 * 9] = std::numeric_limits<double>::quiet_NaN();
  expect_error(mesh.scene(), ErrorKind::NonFiniteCoordinate, 9);
  mesh.positions[3 * 9] = 0.0;
  mesh.expansion = -1.0;
  expect_error(mesh.scene(), ErrorKind::BadExpansion, -1);
  mesh.expansion = 1.0;
  Options options;
  options.groups = 2;
  options.group.assign(40, 1);
  options.allow.assign(4, 1);
  options.group[11] = 2;
  expect_error(scene_of(mesh, options), ErrorKind::BadSegmentGroup, 11);
  options.group.pop_back();
  expect_error(scene_of(mesh, options), ErrorKind::BadLayout, -1);
  EXPECT_THROW(SegmentPairSearch({.threads = 0}), Error);
}

TEST(SegmentPairs, LookAtNothingThatConcernsNodes) {
  const scenes::Mesh mesh = scenes::random_soup(200, 100, 4);
  SegmentPairSearch search;
  const Pairs expected = search.find(mesh.scene());
  ASSERT_GT(expected.count(), 0);
  Scene scene = mesh.scene();
  const std::vector<Index> no_list{5, 4, 3};
  const std::vector<double> no_radii{-1.0};
  scene.nodes = no_list;
  scene.node_radius = no_radii;
  scene.exclude_neighbours = true;
  EXPECT_EQ(search.find(scene), expected);
}

}  // namespace
}  // namespace cellsearch::segment_pairs_test
