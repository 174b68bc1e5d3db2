// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/error.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <ostream>
#include <string>

#include "cellsearch/search.hpp"
#include "scenes.hpp"

namespace cellsearch::error_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Fault {
  const char* name;
  ErrorKind kind;
  Index index;
  const char* part_of_message;
  std::function<void(scenes::Mesh&)> spoil;
};

std::ostream& operator<<(std::ostream& stream, const Fault& fault) {
  return stream << fault.name;
}

class BadScene : public testing::TestWithParam<Fault> {};

TEST_P(BadScene, GivesAnErrorThatNamesThePlace) {
  const Fault& fault = GetParam();
  const scenes::Mesh good = scenes::random_soup(500, 300, 1);
  scenes::Mesh bad = good;
  fault.spoil(bad);
  for (const Method method : methods()) {
    for (const int threads : {1, 4}) {
      Search search({.method = method, .threads = threads});
      search.find(good.scene());
      try {
        search.build(bad.scene());
        FAIL() << "no error";
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), fault.kind) << error.what();
        EXPECT_EQ(error.index(), fault.index) << error.what();
        EXPECT_NE(std::string(error.what()).find(fault.part_of_message), std::string::npos) << error.what();
      }
      // Nothing of the scene before is left, and the object can be used again.
      EXPECT_EQ(search.query().segments(), 0);
      EXPECT_GT(search.find(good.scene()).pairs(), 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Faults, BadScene,
    testing::Values(
        Fault{"nan", ErrorKind::NonFiniteCoordinate, 17, "Node 17 ",
              [](scenes::Mesh& m) { m.positions[3 * 17 + 1] = m.positions[3 * 430] = nan; }},
        Fault{"infinity", ErrorKind::NonFiniteCoordinate, 499, "z = inf",
              [](scenes::Mesh& m) { m.positions[3 * 499 + 2] = infinity; }},
        Fault{"minus infinity", ErrorKind::NonFiniteCoordinate, 0, "x = -inf",
              [](scenes::Mesh& m) { m.positions[0] = -infinity; }},
        Fault{"nan in a node of a segment that takes no part", ErrorKind::NonFiniteCoordinate, 3, "Node 3 ",
              [](scenes::Mesh& m) {
                m.nodes = {{100, 101}};
                m.segments[40] = 3;
                m.positions[3 * 3] = nan;
              }},
        Fault{"node too high", ErrorKind::BadConnectivity, 5, "Segment 5 names node 500",
              [](scenes::Mesh& m) { m.segments[4 * 5 + 2] = m.segments[4 * 290] = 500; }},
        Fault{"node negative", ErrorKind::BadConnectivity, 299, "names node -1",
              [](scenes::Mesh& m) { m.segments[4 * 299] = -1; }},
        Fault{"connectivity not in fours", ErrorKind::BadLayout, -1, "multiple of 4",
              [](scenes::Mesh& m) { m.segments.pop_back(); }},
        Fault{"half a position", ErrorKind::BadLayout, -1, "fewer than 3",
              [](scenes::Mesh& m) { m.positions.push_back(0.0); }},
        Fault{"stride", ErrorKind::BadLayout, -1, "stride", [](scenes::Mesh& m) { m.stride = 2; }},
        Fault{"no node", ErrorKind::EmptyInput, -1, "not a single node",
              [](scenes::Mesh& m) {
                m.positions.clear();
                m.segments.clear();
              }},
        Fault{"negative expansion", ErrorKind::BadExpansion, -1, "expansion",
              [](scenes::Mesh& m) { m.expansion = -0.1; }},
        Fault{"nan expansion", ErrorKind::BadExpansion, -1, "expansion",
              [](scenes::Mesh& m) { m.expansion = nan; }},
        Fault{"expansion of a segment", ErrorKind::BadExpansion, 7, "segment 7",
              [](scenes::Mesh& m) {
                m.segment_expansion.assign(300, 0.0);
                m.segment_expansion[7] = -1e-9;
                m.segment_expansion[200] = infinity;
              }},
        Fault{"number of expansions", ErrorKind::BadLayout, -1, "segment expansions",
              [](scenes::Mesh& m) { m.segment_expansion.assign(299, 0.0); }},
        Fault{"list not ascending", ErrorKind::BadNodeList, 2, "entry 2",
              [](scenes::Mesh& m) {
                m.nodes = {{4, 9, 9, 8}};
              }},
        Fault{"list out of range", ErrorKind::BadNodeList, 1, "entry 1 is 500",
              [](scenes::Mesh& m) {
                m.nodes = {{4, 500}};
              }},
        Fault{"list negative", ErrorKind::BadNodeList, 0, "entry 0 is -1", [](scenes::Mesh& m) {
                m.nodes = {{-1, 5}};
              }}));

void expect_bad_setting(const Settings& settings, ErrorKind kind) {
  try {
    const Search search(settings);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
  }
}

TEST(BadSettings, AreRefusedAtOnce) {
  expect_bad_setting({.threads = 0}, ErrorKind::BadSetting);
  expect_bad_setting({.cell_factor = 0.0}, ErrorKind::BadSetting);
  expect_bad_setting({.cell_factor = nan}, ErrorKind::BadSetting);
  expect_bad_setting({.cells_per_node = -1.0}, ErrorKind::BadSetting);
  expect_bad_setting({.cells_per_node = infinity}, ErrorKind::BadSetting);
  expect_bad_setting({.method = static_cast<Method>(99)}, ErrorKind::BadSetting);
  expect_bad_setting({.domain = CellDomain{Box{{0, 0, 0}, {-1, 1, 1}}, {1, 1, 1}}}, ErrorKind::BadDomain);
}

}  // namespace
}  // namespace cellsearch::error_test
