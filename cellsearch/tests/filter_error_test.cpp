// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "cellsearch/error.hpp"
#include "cellsearch/search.hpp"
#include "scenes.hpp"

namespace cellsearch::filter_error_test {
namespace {

/// Filters that are right for 100 nodes and 60 segments.
struct FilterArrays {
  std::vector<double> radius = std::vector<double>(100, 0.1);
  std::vector<std::uint8_t> active = std::vector<std::uint8_t>(60, 1);
  Index groups = 2;
  std::vector<Index> node_group = std::vector<Index>(100, 0);
  std::vector<Index> segment_group = std::vector<Index>(60, 1);
  std::vector<std::uint8_t> allow = std::vector<std::uint8_t>(4, 1);

  Scene on(const scenes::Mesh& mesh) const {
    Scene scene = mesh.scene();
    scene.node_radius = radius;
    scene.segment_active = active;
    scene.groups = {groups, node_group, segment_group, allow};
    return scene;
  }
};

struct FilterFault {
  const char* name;
  ErrorKind kind;
  Index index;
  const char* part_of_message;
  std::function<void(FilterArrays&)> spoil;
};

std::ostream& operator<<(std::ostream& stream, const FilterFault& fault) {
  return stream << fault.name;
}

class BadFilter : public testing::TestWithParam<FilterFault> {};

TEST_P(BadFilter, GivesAnErrorThatNamesThePlace) {
  const FilterFault& fault = GetParam();
  const scenes::Mesh mesh = scenes::random_soup(100, 60, 1);
  const FilterArrays good;
  FilterArrays bad = good;
  fault.spoil(bad);
  for (const Method method : methods()) {
    for (const int threads : {1, 4}) {
      Search search({.method = method, .threads = threads});
      try {
        search.build(bad.on(mesh));
        FAIL() << "no error";
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), fault.kind) << error.what();
        EXPECT_EQ(error.index(), fault.index) << error.what();
        EXPECT_NE(std::string(error.what()).find(fault.part_of_message), std::string::npos) << error.what();
      }
      EXPECT_EQ(search.query().segments(), 0);
      EXPECT_GT(search.find(good.on(mesh)).pairs(), 0);
    }
  }
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Faults, BadFilter,
    testing::Values(
        FilterFault{"negative radius", ErrorKind::BadRadius, 41, "node 41",
                    [](FilterArrays& f) { f.radius[41] = f.radius[77] = -1e-9; }},
        FilterFault{"nan radius", ErrorKind::BadRadius, 99, "node 99",
                    [](FilterArrays& f) { f.radius[99] = nan; }},
        FilterFault{"infinite radius", ErrorKind::BadRadius, 0, "node 0",
                    [](FilterArrays& f) { f.radius[0] = infinity; }},
        FilterFault{"number of radii", ErrorKind::BadLayout, -1, "node radii",
                    [](FilterArrays& f) { f.radius.pop_back(); }},
        FilterFault{"number of flags", ErrorKind::BadLayout, -1, "active flags",
                    [](FilterArrays& f) { f.active.push_back(1); }},
        FilterFault{"node group too high", ErrorKind::BadNodeGroup, 8, "Node 8 belongs to group 2",
                    [](FilterArrays& f) { f.node_group[8] = f.node_group[80] = 2; }},
        FilterFault{"node group negative", ErrorKind::BadNodeGroup, 98, "from 0 to 1",
                    [](FilterArrays& f) { f.node_group[98] = -1; }},
        FilterFault{"segment group", ErrorKind::BadSegmentGroup, 3, "Segment 3 belongs to group -5",
                    [](FilterArrays& f) { f.segment_group[3] = f.segment_group[59] = -5; }},
        FilterFault{"number of node groups", ErrorKind::BadLayout, -1, "node groups",
                    [](FilterArrays& f) { f.node_group.pop_back(); }},
        FilterFault{"number of segment groups", ErrorKind::BadLayout, -1, "segment groups",
                    [](FilterArrays& f) { f.segment_group.clear(); }},
        FilterFault{"matrix", ErrorKind::BadLayout, -1, "matrix", [](FilterArrays& f) { f.allow.resize(3); }},
        FilterFault{"groups without a number of groups", ErrorKind::BadLayout, -1, "node groups",
                    [](FilterArrays& f) { f.groups = 0; }},
        FilterFault{"negative number of groups", ErrorKind::BadLayout, -1, "negative",
                    [](FilterArrays& f) { f.groups = -2; }}));

}  // namespace
}  // namespace cellsearch::filter_error_test
