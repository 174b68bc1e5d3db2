// SPDX-License-Identifier: BSD-3-Clause
// Every method against an oracle that shares no code with the library, on random and adversarial meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <string>

#include "cellsearch/search.hpp"
#include "cellsearch/verify.hpp"
#include "scenes.hpp"

namespace cellsearch {

std::ostream& operator<<(std::ostream& stream, Method method) {
  return stream << name_of(method);
}

namespace {

constexpr std::uint64_t meshes = 400;

bool is_between(double lo, double x, double hi) {
  return lo <= x && x <= hi;
}

/// The definition of a candidate pair, written out from the mesh's own arrays.
Candidates candidates_by_definition(const scenes::Mesh& mesh) {
  Candidates result;
  result.first.push_back(0);
  for (std::size_t s = 0; s < mesh.segment_count(); ++s) {
    const Index* own = &mesh.segments[4 * s];
    double c = mesh.expansion;
    if (!mesh.segment_expansion.empty()) c = mesh.expansion + mesh.segment_expansion[s];
    for (std::size_t node = 0; node < mesh.node_count(); ++node) {
      const Index id = static_cast<Index>(node);
      if (std::count(own, own + 4, id) != 0) continue;
      if (mesh.nodes && std::count(mesh.nodes->begin(), mesh.nodes->end(), id) == 0) continue;
      bool inside = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto coordinate = [&](Index n) {
          return mesh.positions[static_cast<std::size_t>(n) * mesh.stride + axis];
        };
        const auto [lo, hi] =
            std::minmax({coordinate(own[0]), coordinate(own[1]), coordinate(own[2]), coordinate(own[3])});
        inside = inside && is_between(lo - c, coordinate(id), hi + c);
        if (mesh.domain) {
          inside = inside && is_between(mesh.domain->box.lo[axis], coordinate(id), mesh.domain->box.hi[axis]);
        }
      }
      if (inside) result.node.push_back(id);
    }
    result.first.push_back(static_cast<Offset>(result.node.size()));
  }
  return result;
}

std::string difference(const Candidates& found, const Candidates& expected) {
  const std::optional<Difference> result = first_difference(found, expected);
  return result ? result->describe() : "";
}

class Oracle : public testing::TestWithParam<Method> {};

TEST_P(Oracle, AgreesOnEveryMeshAndNumberOfThreads) {
  std::map<std::string, Offset> pairs;
  for (std::uint64_t seed = 0; seed < meshes; ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(seed);
    const Candidates expected = candidates_by_definition(mesh);
    pairs[mesh.name] += expected.pairs();
    for (int threads = 1; threads <= 4; ++threads) {
      Search search({.method = GetParam(), .domain = mesh.domain, .threads = threads});
      const Candidates& found = search.find(mesh.scene());
      ASSERT_EQ(found, expected) << "mesh " << seed << " (" << mesh.name << "), " << threads
                                 << " threads: " << difference(found, expected);
      EXPECT_EQ(search.query(), expected) << "the second query differs";
      EXPECT_EQ(search.statistics().candidates, 2 * expected.pairs());
      EXPECT_GE(search.statistics().raw_visits, 2 * expected.pairs());
    }
  }
  // A mesh without a single pair tests little: every kind must have some, but for the one without segments.
  EXPECT_EQ(pairs.size(), static_cast<std::size_t>(scenes::kinds()) - 1) << "two kinds share a name";
  for (const auto& [name, count] : pairs) {
    if (name != "no segment") {
      EXPECT_GT(count, 0) << name;
    }
  }
}

TEST_P(Oracle, AgreesForAnyCellSize) {
  Search reused({.method = GetParam(), .threads = 3});
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const scenes::Mesh mesh = scenes::make_mesh(seed);
    if (mesh.domain) continue;
    const Candidates expected = candidates_by_definition(mesh);
    EXPECT_EQ(reused.find(mesh.scene()), expected) << mesh.name << ": memory of the mesh before it";
    for (const double factor : {0.05, 0.5, 3.0, 1e9}) {
      Search search(
          {.method = GetParam(), .cell_factor = factor, .cells_per_node = factor < 0.1 ? 100.0 : 1.0});
      EXPECT_EQ(search.find(mesh.scene()), expected) << mesh.name << ", cell factor " << factor;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Oracle, testing::ValuesIn(methods().begin(), methods().end()));

}  // namespace
}  // namespace cellsearch
