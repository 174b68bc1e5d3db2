// SPDX-License-Identifier: BSD-3-Clause
// What the benchmarks assume of their scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "cellsearch/search.hpp"
#include "scenes.hpp"

namespace cellsearch::scenes_test {
namespace {

double pairs_per_segment(const scenes::Mesh& mesh) {
  Search search({.method = Method::LinkedCell});
  const Candidates& found = search.find(mesh.scene());
  return static_cast<double>(found.pairs()) / found.segments();
}

void expect_flat(std::initializer_list<int> sizes) {
  for (const scenes::Family& family : scenes::families()) {
    double least = HUGE_VAL;
    double most = 0.0;
    for (const int nodes : sizes) {
      const scenes::Mesh mesh = family.make(nodes, 42);
      EXPECT_NEAR(static_cast<double>(mesh.node_count()) / nodes, 1.0, 0.15) << family.name;
      const double pairs = pairs_per_segment(mesh);
      least = std::min(least, pairs);
      most = std::max(most, pairs);
    }
    EXPECT_GT(least, 0.3) << family.name << ": so few pairs test little";
    EXPECT_LE(most, 1.05 * least) << family.name;
  }
}

TEST(Scenes, HaveAsManyPairsPerSegmentWhateverTheirSize) {
  expect_flat({10000, 30000, 100000});
}

TEST(Scenes, HaveAsManyPairsPerSegmentInAMillionNodesNightly) {
  expect_flat({10000, 1000000, 3000000});
}

/// Of the bits of all coordinates and the connectivity.
std::uint64_t fingerprint(const scenes::Mesh& mesh) {
  std::uint64_t hash = 0;
  const auto add = [&](std::uint64_t value) { hash = (hash ^ value) * 0x9E3779B97F4A7C15u + (hash >> 31); };
  for (const double coordinate : mesh.positions) add(std::bit_cast<std::uint64_t>(coordinate));
  for (const Index node : mesh.segments) add(static_cast<std::uint64_t>(node));
  return hash;
}

TEST(Scenes, AreTheSameOnEveryPlatform) {
  const std::vector<std::uint64_t> expected{
      518345104681198936U,  16435686974036278873U, 3697668213049579967U, 13031427651937333598U,
      2973384957550807763U, 12724564038747238579U, 14840871049335303946U};
  std::vector<std::uint64_t> found;
  for (const scenes::Family& family : scenes::families()) found.push_back(fingerprint(family.make(2000, 42)));
  EXPECT_EQ(found, expected);
}

TEST(Scenes, UseAllBitsOfADouble) {
  for (const scenes::Family& family : scenes::families()) {
    const scenes::Mesh mesh = family.make(2000, 42);
    const auto is_float = [](double x) { return static_cast<double>(static_cast<float>(x)) == x; };
    EXPECT_EQ(std::count_if(mesh.positions.begin(), mesh.positions.end(), is_float), 0) << family.name;
  }
}

TEST(Scenes, KeepTheirPairsWhenTheyAreShuffled) {
  for (const scenes::Family& family : scenes::families()) {
    const scenes::Mesh mesh = family.make(3000, 42);
    scenes::Mesh shuffled = mesh;
    shuffled.shuffle(5);
    EXPECT_NE(shuffled.segments, mesh.segments) << family.name;
    EXPECT_EQ(pairs_per_segment(shuffled), pairs_per_segment(mesh)) << family.name;
  }
}

}  // namespace
}  // namespace cellsearch::scenes_test
