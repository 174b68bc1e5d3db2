// SPDX-License-Identifier: BSD-3-Clause
// Radii, eroded segments, neighbours and groups: by hand, and against their definition for all methods.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "candidate_test.hpp"
#include "cellsearch/search.hpp"
#include "cellsearch/verify.hpp"
#include "scenes.hpp"

namespace cellsearch::filter_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A strip of three unit squares, 0 - 1 - 2 - 3 below and 4 - 5 - 6 - 7 above, and node 8 over the middle one.
struct Strip {
  std::vector<double> positions{0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0,   0,   0,  1,
                                0, 1, 1, 0, 2, 1, 0, 3, 1, 0, 1.5, 0.5, 0.5};
  std::vector<Index> connectivity{0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6};
  std::vector<double> radius{};
  std::vector<std::uint8_t> active{};
  std::vector<Index> node_group{};
  std::vector<Index> segment_group{};
  std::vector<std::uint8_t> allow{};
  Scene scene;

  Strip() {
    scene.positions = Positions(positions);
    scene.segments = Segments(connectivity);
  }
};

/// What the search finds, or nothing if the method is not made for the scene, which only one may say.
std::optional<Candidates> found_by(Search& search, const Scene& scene) {
  try {
    return search.find(scene);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::UnsuitedMethod) << error.what();
    EXPECT_EQ(search.settings().method, Method::Nbs);
    return std::nullopt;
  }
}

/// The candidates of every segment, found by all methods alike; rows as vectors, easy to write down.
std::vector<std::vector<Index>> rows_of(const Scene& scene) {
  std::vector<std::vector<Index>> rows;
  for (const Method method : methods()) {
    Search search({.method = method});
    const std::optional<Candidates> found = found_by(search, scene);
    if (!found) continue;
    std::vector<std::vector<Index>> its;
    its.reserve(static_cast<std::size_t>(found->segments()));
    for (Index segment = 0; segment < found->segments(); ++segment) {
      its.emplace_back(found->of(segment).begin(), found->of(segment).end());
    }
    if (rows.empty()) rows = its;
    EXPECT_EQ(its, rows) << name_of(method);
  }
  return rows;
}

using Rows = std::vector<std::vector<Index>>;

// With c = 0 the flat territories share only their edges: each finds nothing but what lies on it.
TEST(NodeRadius, ReachesTheTerritoryThatTheNodeItselfDoesNot) {
  Strip strip;
  EXPECT_EQ(rows_of(strip.scene), (Rows{{}, {}, {}}));
  strip.radius.assign(9, 0.0);
  strip.radius[8] = 0.5;  // touches the middle one, and with its corners the lines x = 1 and x = 2
  strip.scene.node_radius = strip.radius;
  EXPECT_EQ(rows_of(strip.scene), (Rows{{8}, {8}, {8}}));
  strip.radius[8] = std::nextafter(0.5, 0.0);
  EXPECT_EQ(rows_of(strip.scene), (Rows{{}, {}, {}}));
  strip.radius[4] = 1.0;  // the next square begins exactly there
  EXPECT_EQ(rows_of(strip.scene), (Rows{{}, {4}, {}}));
  strip.scene.expansion = 0.5;
  EXPECT_EQ(rows_of(strip.scene), (Rows{{8}, {4, 8}, {8}}));
}

// In exact numbers 2^-54 + (1 - 2^-53) falls short of 1 by 2^-54, but rounded to double it is 1. The test is
// defined in double, so no method may cut the node off with a box that is rounded the other way.
TEST(NodeRadius, IsAddedInDoubleAndNoMethodCutsTheNodeOff) {
  std::vector<double> positions{0x1p-54, 0.5, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0};
  const std::vector<Index> connectivity{1, 2, 3, 4};
  const std::vector<double> radius{1.0 - 0x1p-53, 0, 0, 0, 0};
  Scene scene;
  scene.positions = Positions(positions);
  scene.segments = Segments(connectivity);
  scene.node_radius = radius;
  EXPECT_EQ(rows_of(scene), (Rows{{0}}));
  for (double& coordinate : positions) coordinate = -coordinate;
  EXPECT_EQ(rows_of(scene), (Rows{{0}}));
  positions[0] = std::nextafter(-0x1p-54, 1.0);
  EXPECT_EQ(rows_of(scene), (Rows{{}}));
}

// Nodes as close as numbers allow to where x + r reaches the territory, from both sides.
TEST(NodeRadius, OfAnAcceptedNodeIsWithinTheCullingBox) {
  scenes::Random random(3);
  const std::vector<Index> connectivity{1, 1, 1, 1};
  int accepted = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const double scale = std::pow(10.0, random.uniform(-8.0, 8.0));
    const double wall = random.uniform(-1.0, 1.0) * scale;
    const std::vector<double> radius{random.uniform(0.0, 1.0) * std::pow(10.0, random.uniform(-8.0, 8.0)),
                                     0.0};
    const double side = random.below(2) == 0 ? -1.0 : 1.0;
    double x = wall + side * radius[0];
    for (int step = random.below(4); step > 0; --step) x = std::nextafter(x, side * 1e300);
    const std::vector<double> positions{x, 0, 0, wall, 0, 0};
    Scene scene;
    scene.positions = Positions(positions);
    scene.segments = Segments(connectivity);
    scene.node_radius = radius;
    const CandidateTest test(scene, nullptr, radius[0]);
    if (!test(0, territory(scene, 0), 0)) continue;
    ++accepted;
    ASSERT_TRUE(test.culling_box(0).contains(positions.data())) << x << " " << wall << " " << radius[0];
  }
  EXPECT_GT(accepted, 3000);
  EXPECT_LT(accepted, 17000);
}

TEST(ErodedSegments, HaveNoCandidatesButTheirNodesStayOthers) {
  Strip strip;
  strip.scene.expansion = 1.0;
  EXPECT_EQ(rows_of(strip.scene), (Rows{{2, 6, 8}, {0, 3, 4, 7, 8}, {1, 5, 8}}));
  strip.active = {1, 0, 1};
  strip.scene.segment_active = strip.active;
  EXPECT_EQ(rows_of(strip.scene), (Rows{{2, 6, 8}, {}, {1, 5, 8}}));
  strip.active = {0, 0, 0};
  EXPECT_EQ(rows_of(strip.scene), (Rows{{}, {}, {}}));
}

TEST(Neighbours, AreNodesOfSegmentsThatShareANode) {
  Strip strip;
  strip.scene.expansion = 2.0;
  EXPECT_EQ(rows_of(strip.scene), (Rows{{2, 3, 6, 7, 8}, {0, 3, 4, 7, 8}, {0, 1, 4, 5, 8}}));
  strip.scene.exclude_neighbours = true;
  EXPECT_EQ(rows_of(strip.scene), (Rows{{3, 7, 8}, {8}, {0, 4, 8}}));
}

TEST(Neighbours, AreNotMadeByErodedSegments) {
  Strip strip;
  strip.scene.expansion = 2.0;
  strip.scene.exclude_neighbours = true;
  strip.active = {1, 0, 1};
  strip.scene.segment_active = strip.active;
  EXPECT_EQ(rows_of(strip.scene), (Rows{{2, 3, 6, 7, 8}, {}, {0, 1, 4, 5, 8}}));
}

TEST(Groups, AllowWhatTheMatrixSaysRowBySegmentAndColumnByNode) {
  Strip strip;
  strip.scene.expansion = 2.0;
  strip.node_group = {0, 0, 1, 1, 0, 0, 1, 1, 2};
  strip.segment_group = {0, 2, 1};
  strip.allow = {0, 1, 0,   // segment 0 looks for the right half only
                 0, 1, 0,   // segment 2 likewise, so that segments of 0 find 1 but not the other way round
                 1, 0, 1};  // segment 1: the left half and node 8
  strip.scene.groups = {3, strip.node_group, strip.segment_group, strip.allow};
  EXPECT_EQ(rows_of(strip.scene), (Rows{{2, 3, 6, 7}, {0, 4, 8}, {}}));
}

// ---- all of them together, against the definition ----

struct Filters {
  std::vector<double> radius{};
  std::vector<std::uint8_t> active{};
  bool neighbours = false;
  Index groups = 0;
  std::vector<Index> node_group{};
  std::vector<Index> segment_group{};
  std::vector<std::uint8_t> allow{};

  Scene on(const scenes::Mesh& mesh) const {
    Scene scene = mesh.scene();
    scene.node_radius = radius;
    scene.segment_active = active;
    scene.exclude_neighbours = neighbours;
    scene.groups = {groups, node_group, segment_group, allow};
    return scene;
  }
};

bool takes_part(const scenes::Mesh& mesh, Index node) {
  return !mesh.nodes || std::count(mesh.nodes->begin(), mesh.nodes->end(), node) != 0;
}

/// Bits of `which`: radii, erosion, neighbours, groups. What belongs to nodes that take no part is nonsense.
Filters random_filters(const scenes::Mesh& mesh, int which, scenes::Random& random) {
  Filters filters;
  const Index nodes = static_cast<Index>(mesh.node_count());
  const std::size_t segments = mesh.segment_count();
  if ((which & 1) != 0) {
    for (Index node = 0; node < nodes; ++node) {
      // Multiples of c/2 give equalities on lattices.
      const double r = random.below(2) == 0 ? 0.5 * random.below(4) : random.uniform(0.0, 2.0);
      const double unit = mesh.expansion > 0.0 ? mesh.expansion : 0.25;
      filters.radius.push_back(takes_part(mesh, node) ? r * unit : nan);
    }
  }
  if ((which & 2) != 0) {
    for (std::size_t s = 0; s < segments; ++s) {
      filters.active.push_back(static_cast<std::uint8_t>(random.below(3)));
    }
  }
  filters.neighbours = (which & 4) != 0;
  if ((which & 8) != 0) {
    filters.groups = 1 + random.below(4);
    const std::size_t count = static_cast<std::size_t>(filters.groups);
    for (Index node = 0; node < nodes; ++node) {
      filters.node_group.push_back(takes_part(mesh, node) ? random.below(count) : -7);
    }
    for (std::size_t s = 0; s < segments; ++s) filters.segment_group.push_back(random.below(count));
    for (std::size_t k = 0; k < count * count; ++k) {
      filters.allow.push_back(static_cast<std::uint8_t>(random.below(3)));
    }
  }
  return filters;
}

/// Which nodes share an active segment, as a full matrix.
std::vector<std::vector<bool>> shared_segments(const scenes::Mesh& mesh, const Filters& filters) {
  std::vector<std::vector<bool>> shares(mesh.node_count(), std::vector<bool>(mesh.node_count(), false));
  for (std::size_t k = 0; k < mesh.segments.size(); ++k) {
    if (!filters.active.empty() && filters.active[k / 4] == 0) continue;
    for (std::size_t other = k / 4 * 4; other < k / 4 * 4 + 4; ++other) {
      shares[static_cast<std::size_t>(mesh.segments[k])][static_cast<std::size_t>(mesh.segments[other])] =
          true;
    }
  }
  return shares;
}

bool inside(const scenes::Mesh& mesh, const Filters& filters, std::size_t segment, std::size_t node) {
  const double c =
      mesh.segment_expansion.empty() ? mesh.expansion : mesh.expansion + mesh.segment_expansion[segment];
  const double r = filters.radius.empty() ? 0.0 : filters.radius[node];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = mesh.positions[node * mesh.stride + axis];
    std::array<double, 4> corners{};
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const std::size_t own = static_cast<std::size_t>(mesh.segments[4 * segment + corner]);
      corners[corner] = mesh.positions[own * mesh.stride + axis];
    }
    const auto [lo, hi] = std::minmax_element(corners.begin(), corners.end());
    if (x + r < *lo - c || x - r > *hi + c) return false;
    if (mesh.domain && (x < mesh.domain->box.lo[axis] || x > mesh.domain->box.hi[axis])) return false;
  }
  return true;
}

Candidates candidates_by_definition(const scenes::Mesh& mesh, const Filters& filters) {
  Candidates result;
  result.first.push_back(0);
  const std::vector<std::vector<bool>> shares = shared_segments(mesh, filters);
  for (std::size_t s = 0; s < mesh.segment_count(); ++s) {
    const Index* own = &mesh.segments[4 * s];
    for (std::size_t p = 0; p < mesh.node_count(); ++p) {
      const Index node = static_cast<Index>(p);
      if (!filters.active.empty() && filters.active[s] == 0) continue;
      if (!takes_part(mesh, node) || std::count(own, own + 4, node) != 0) continue;
      if (!inside(mesh, filters, s, p)) continue;
      if (filters.neighbours && std::any_of(own, own + 4, [&](Index corner) {
            return shares[static_cast<std::size_t>(corner)][p];
          })) {
        continue;
      }
      if (filters.groups > 0) {
        const Index entry = filters.segment_group[s] * filters.groups + filters.node_group[p];
        if (filters.allow[static_cast<std::size_t>(entry)] == 0) continue;
      }
      result.node.push_back(node);
    }
    result.first.push_back(result.pairs());
  }
  return result;
}

/// All 16 combinations of filters on each of the meshes first .. last - 1.
void expect_the_definition(Method method, std::uint64_t first, std::uint64_t last) {
  std::array<Offset, 16> pairs{};
  std::uint64_t compared = 0;
  Search alone({.method = method});
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(seed);
    scenes::Random random(seed + 1000);
    Search threaded({.method = method, .domain = mesh.domain, .threads = 3});
    for (int which = 0; which < 16; ++which) {
      const Filters filters = random_filters(mesh, which, random);
      const Candidates expected = candidates_by_definition(mesh, filters);
      pairs[static_cast<std::size_t>(which)] += expected.pairs();
      const Scene scene = filters.on(mesh);
      for (Search* search : {&threaded, &alone}) {
        if (search == &alone && mesh.domain) continue;
        const std::optional<Candidates> found = found_by(*search, scene);
        if (!found) continue;
        ++compared;
        const std::optional<Difference> difference = first_difference(*found, expected);
        ASSERT_FALSE(difference) << "mesh " << seed << " (" << mesh.name << "), filters " << which << ": "
                                 << difference->describe();
      }
    }
  }
  EXPECT_GT(compared, 3 * (last - first));
  for (std::size_t which = 1; which < 16; ++which) {
    EXPECT_GT(pairs[which], 0);
    EXPECT_NE(pairs[which], pairs[0]) << "filters " << which << " filter nothing";
  }
}

class AllFilters : public testing::TestWithParam<Method> {};

TEST_P(AllFilters, AgreeWithTheDefinitionInAllCombinations) {
  expect_the_definition(GetParam(), 0, 40);
}

TEST_P(AllFilters, NightlyAgreeWithTheDefinitionInAllCombinations) {
  expect_the_definition(GetParam(), 40, 360);
}

INSTANTIATE_TEST_SUITE_P(Methods, AllFilters, testing::ValuesIn(methods().begin(), methods().end()),
                         [](const auto& one) {
                           std::string name(name_of(one.param));
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace cellsearch::filter_test
