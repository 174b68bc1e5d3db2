// SPDX-License-Identifier: BSD-3-Clause
// Every method against an oracle that shares no code with the library, on random and adversarial meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "cellsearch/error.hpp"
#include "cellsearch/search.hpp"
#include "cellsearch/verify.hpp"
#include "scenes.hpp"

namespace cellsearch::oracle_test {

std::ostream& operator<<(std::ostream& stream, Method method) {
  return stream << name_of(method);
}

namespace {

bool is_between(double lo, double x, double hi) {
  return lo <= x && x <= hi;
}

double coordinate(const scenes::Mesh& mesh, Index node, std::size_t axis) {
  return mesh.positions[static_cast<std::size_t>(node) * mesh.stride + axis];
}

/// The territory of segment `s` by eq. (7)-(9).
Box territory_by_definition(const scenes::Mesh& mesh, std::size_t s) {
  double c = mesh.expansion;
  if (!mesh.segment_expansion.empty()) c = mesh.expansion + mesh.segment_expansion[s];
  const Index* own = &mesh.segments[4 * s];
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lo, hi] = std::minmax({coordinate(mesh, own[0], axis), coordinate(mesh, own[1], axis),
                                       coordinate(mesh, own[2], axis), coordinate(mesh, own[3], axis)});
    box.lo[axis] = lo - c;
    box.hi[axis] = hi + c;
  }
  return box;
}

bool is_inside(const Box& box, const scenes::Mesh& mesh, Index node) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!is_between(box.lo[axis], coordinate(mesh, node, axis), box.hi[axis])) return false;
  }
  return true;
}

std::vector<Index> participants_by_definition(const scenes::Mesh& mesh) {
  std::vector<Index> participants;
  for (Index node = 0; node < static_cast<Index>(mesh.node_count()); ++node) {
    if (mesh.nodes && std::count(mesh.nodes->begin(), mesh.nodes->end(), node) == 0) continue;
    if (mesh.domain && !is_inside(mesh.domain->box, mesh, node)) continue;
    participants.push_back(node);
  }
  return participants;
}

/// The definition of a candidate pair, written out from the mesh's own arrays.
Candidates candidates_by_definition(const scenes::Mesh& mesh) {
  const std::vector<Index> participants = participants_by_definition(mesh);
  Candidates result;
  result.first.push_back(0);
  for (std::size_t s = 0; s < mesh.segment_count(); ++s) {
    const Index* own = &mesh.segments[4 * s];
    const Box box = territory_by_definition(mesh, s);
    for (const Index node : participants) {
      if (is_inside(box, mesh, node) && std::count(own, own + 4, node) == 0) result.node.push_back(node);
    }
    result.first.push_back(static_cast<Offset>(result.node.size()));
  }
  return result;
}

/// By how much the largest territory of the mesh exceeds the mean one; territories that do not reach the box
/// around the nodes left out, as in the definition of method nbs.
double size_ratio(const scenes::Mesh& mesh) {
  Box nodes;
  for (const Index node : participants_by_definition(mesh)) {
    const Point at{coordinate(mesh, node, 0), coordinate(mesh, node, 1), coordinate(mesh, node, 2)};
    nodes.include(at.data());
  }
  std::vector<double> sizes;
  for (std::size_t s = 0; s < mesh.segment_count(); ++s) {
    const Box box = territory_by_definition(mesh, s);
    if (!box.intersects(nodes)) continue;
    sizes.push_back(std::max({box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]}));
  }
  if (sizes.empty()) return 1.0;
  const double largest = *std::max_element(sizes.begin(), sizes.end());
  double sum = 0.0;
  for (const double size : sizes) sum += size / largest;
  return static_cast<double>(sizes.size()) / sum;
}

std::string difference(const Candidates& found, const Candidates& expected) {
  const std::optional<Difference> result = first_difference(found, expected);
  return result ? result->describe() : "";
}

/// False if the method refuses the mesh, which only nbs may do and only for its sizes.
bool is_accepted(Search& search, const scenes::Mesh& mesh) {
  const bool restricted = search.settings().method == Method::Nbs;
  const double ratio = restricted ? size_ratio(mesh) : 1.0;
  try {
    search.build(mesh.scene());
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::UnsuitedMethod) << error.what();
    EXPECT_TRUE(restricted) << name_of(search.settings().method) << " must take any mesh: " << error.what();
    EXPECT_GT(ratio, 3.0 * (1.0 - 1e-12)) << mesh.name << ": refused without a reason";
    EXPECT_EQ(search.query().segments(), 0) << "there is nothing to query after a refusal";
    return false;
  }
  // Sizes all 0 give no ratio.
  EXPECT_FALSE(ratio > 3.0 * (1.0 + 1e-12)) << mesh.name << ": should have been refused";
  return true;
}

class Oracle : public testing::TestWithParam<Method> {
 protected:
  /// Compares on the meshes of seeds begin..end-1. Returns how many the method accepts.
  int agree_on(std::uint64_t begin, std::uint64_t end) {
    int accepted = 0;
    for (std::uint64_t seed = begin; seed < end; ++seed) {
      const scenes::Mesh mesh = scenes::make_mesh(seed);
      const Candidates expected = candidates_by_definition(mesh);
      int accepted_by = 0;
      for (int threads = 1; threads <= 4; ++threads) {
        Search search({.method = GetParam(), .domain = mesh.domain, .threads = threads});
        if (!is_accepted(search, mesh)) continue;
        ++accepted_by;
        const Candidates& found = search.query();
        EXPECT_EQ(difference(found, expected), "")
            << "mesh " << seed << " (" << mesh.name << "), " << threads << " threads";
        EXPECT_EQ(found, expected);
        EXPECT_EQ(search.query(), expected) << "the second query differs";
        EXPECT_EQ(search.statistics().candidates, 2 * expected.pairs());
        EXPECT_GE(search.statistics().raw_visits, 2 * expected.pairs());
        if (HasFailure()) return accepted;
      }
      EXPECT_TRUE(accepted_by == 0 || accepted_by == 4) << "a refusal must not depend on the threads";
      if (accepted_by == 0) continue;
      ++accepted;
      pairs_[mesh.name] += expected.pairs();
    }
    return accepted;
  }

  std::map<std::string, Offset> pairs_;  // found in the accepted meshes, by kind of mesh
};

// nbs takes about 88% of the meshes of make_mesh; it refuses mixed sizes.
TEST_P(Oracle, AgreesOnEveryMeshAndNumberOfThreads) {
  const int accepted = agree_on(0, 200);
  RecordProperty("accepted", accepted);
  if (GetParam() == Method::Nbs) {
    EXPECT_GE(accepted, 160);
    EXPECT_LT(accepted, 200) << "mixed sizes by 1000x are to be refused";
  } else {
    EXPECT_EQ(accepted, 200);
    EXPECT_EQ(pairs_.size(), static_cast<std::size_t>(scenes::kinds()) - 1)
        << "only mixed sizes are two kinds";
  }
  // A mesh without a single pair tests little: every kind must have some, but for the one without segments.
  for (const auto& [name, count] : pairs_) {
    if (name != "no segment") {
      EXPECT_GT(count, 0) << name;
    }
  }
}

TEST_P(Oracle, AgreesOnThousandsOfMeshesNightly) {
  const int accepted = agree_on(200, 200 + 2400);
  RecordProperty("accepted", accepted);
  EXPECT_GE(accepted, GetParam() == Method::Nbs ? 2000 : 2400);
}

TEST_P(Oracle, AgreesForAnyCellSize) {
  Search reused({.method = GetParam(), .threads = 3});
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(seed);
    if (mesh.domain || !is_accepted(reused, mesh)) continue;
    const Candidates expected = candidates_by_definition(mesh);
    EXPECT_EQ(reused.query(), expected) << mesh.name << ": memory of the mesh before it";
    for (const double factor : {0.05, 0.5, 3.0, 1e9}) {
      Search search(
          {.method = GetParam(), .cell_factor = factor, .cells_per_node = factor < 0.1 ? 100.0 : 1.0});
      EXPECT_EQ(search.find(mesh.scene()), expected) << mesh.name << ", cell factor " << factor;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Oracle, testing::ValuesIn(methods().begin(), methods().end()));

}  // namespace
}  // namespace cellsearch::oracle_test
