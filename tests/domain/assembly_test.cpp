// SPDX-License-Identifier: BSD-3-Clause
#include "domain/assembly.hpp"

#include <gtest/gtest.h>

#include <set>

#include "base/parallel.hpp"
#include "domain/build.hpp"
#include "support/meshes.hpp"

namespace crumple::domain::assembly_test {
namespace {

model::Model sheet(Index columns, Index rows) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1.0, 3));
  test::add_grid(model, 0, columns, rows, [&](double u, double v) {
    return test::Point{u * columns, v * rows, 0};
  });
  return model;
}

/// Adds to every node of every element a number that depends on the element, as a kernel would.
void scatter_like_a_kernel(Domain& domain, int threads) {
  const auto& chunks = domain.assembly.chunks();
  parallel_for(static_cast<Index>(chunks.size()), threads, [&](Index c) {
    const Chunk& chunk = chunks[c];
    const ShellBlock& block = domain.shells[chunk.block];
    for (Index group = chunk.first_group; group < chunk.last_group; ++group)
      for (Index k = 0; k < 4; ++k)
        for (Index lane = 0; lane < lanes; ++lane) {
          const Index place = group * lanes + lane;
          const double value = 1.0 / (3.0 + place + 0.1 * k);
          const std::size_t entry = (static_cast<std::size_t>(group) * 4 + k) * lanes + lane;
          domain.nodes.force[block.target[entry]].force[0] += value;
          domain.nodes.force[block.target[entry]].moment[2] -= value;
        }
  });
  domain.assembly.gather_interface(domain.nodes.force, threads);
}

TEST(Assembly, EveryElementReachesEveryNodeOnce) {
  Domain domain = build(sheet(60, 40), {});
  scatter_like_a_kernel(domain, 1);
  std::vector<double> expected(domain.nodes.count(), 0.0);
  const ShellBlock& block = domain.shells[0];
  for (Index place = 0; place < block.elements; ++place)
    for (Index k = 0; k < 4; ++k) expected[block.nodes_of(place)[k]] += 1.0 / (3.0 + place + 0.1 * k);
  for (Index i = 0; i < domain.nodes.count(); ++i) {
    EXPECT_NEAR(domain.nodes.force[i].force[0], expected[i], 1e-15);
    EXPECT_NEAR(domain.nodes.force[i].moment[2], -expected[i], 1e-15);
  }
}

TEST(Assembly, SumsAreBitwiseTheSameForAnyNumberOfThreads) {
  Domain reference = build(sheet(73, 41), {});
  ASSERT_GT(reference.assembly.chunks().size(), 4U);
  scatter_like_a_kernel(reference, 1);
  for (const int threads : {2, 3, 4, 7}) {
    Domain domain = build(sheet(73, 41), {});
    scatter_like_a_kernel(domain, threads);
    for (Index i = 0; i < domain.nodes.count(); ++i)
      ASSERT_EQ(domain.nodes.force[i].force[0], reference.nodes.force[i].force[0]) << i << " " << threads;
  }
}

TEST(Assembly, ChunksGrowWithTheModelAsLongAsThereAreMany) {
  EXPECT_EQ(groups_per_chunk(1), 32);
  EXPECT_EQ(groups_per_chunk(4095), 32);
  EXPECT_EQ(groups_per_chunk(4096), 64);
  EXPECT_EQ(groups_per_chunk(16384), 256);
  EXPECT_EQ(groups_per_chunk(100000000), 256);
}

TEST(Assembly, SumsOfLargeChunksAreThoseOfSmallOnes) {
  Domain small = build(sheet(73, 41), {});
  Execution execution;
  execution.groups_per_chunk = 64;
  Domain large = build(sheet(73, 41), execution);
  ASSERT_EQ(large.assembly.chunks().size(), 3U);
  scatter_like_a_kernel(small, 1);
  scatter_like_a_kernel(large, 1);
  for (Index i = 0; i < small.nodes.count(); ++i)
    EXPECT_NEAR(small.nodes.force[i].force[0], large.nodes.force[i].force[0], 1e-15);
}

TEST(Assembly, SlotsAreClearedAfterTheGather) {
  Domain domain = build(sheet(73, 41), {});
  scatter_like_a_kernel(domain, 2);
  // The last slot takes what the fill lanes of the one block send and is never read.
  for (std::size_t s = domain.nodes.count(); s + 1 < domain.nodes.force.size(); ++s)
    EXPECT_EQ(domain.nodes.force[s].force[0], 0.0);
}

TEST(Assembly, ChunksOfDifferentPartsNeverWriteTheSamePlace) {
  model::Model model = sheet(30, 30);
  model.parts.push_back({.id = 2, .title = "second", .section = 0, .material = 0});
  for (std::size_t s = 0; s < model.shells.size(); s += 2) model.shells[s].part = 1;
  const Domain domain = build(model, {});
  std::vector<std::set<Index>> places;
  for (const Chunk& chunk : domain.assembly.chunks()) {
    std::set<Index> own;
    const ShellBlock& block = domain.shells[chunk.block];
    for (Index group = chunk.first_group; group < chunk.last_group; ++group)
      for (Index e = 0; e < 4 * lanes; ++e) {
        const Index place = group * lanes + e % lanes;
        if (place < block.elements) own.insert(block.target[static_cast<std::size_t>(group) * 4 * lanes + e]);
      }
    places.push_back(own);
  }
  std::set<Index> all;
  std::size_t sum = 0;
  for (const auto& own : places) {
    all.insert(own.begin(), own.end());
    sum += own.size();
  }
  EXPECT_EQ(all.size(), sum);
}

}  // namespace
}  // namespace crumple::domain::assembly_test
