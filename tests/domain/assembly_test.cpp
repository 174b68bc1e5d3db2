// SPDX-License-Identifier: BSD-3-Clause
#include "domain/assembly.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

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

/// The sheet, its elements cut in some way.
Domain cut_sheet(Index columns, Index rows, int threads, Index groups = 0) {
  Execution execution;
  execution.threads = threads;
  execution.groups_per_chunk = groups;
  return build(sheet(columns, rows), execution);
}

double value_of(Index place, Index corner) {
  return 1.0 / (3.0 + place + 0.1 * corner);
}

/// Adds to every node of every element a number that depends on the element, as a kernel would.
void scatter_like_a_kernel(Domain& domain) {
  const auto& shares = domain.assembly.shares();
  const auto add = [&](const ShellBlock& block, Index place) {
    for (Index k = 0; k < 4; ++k) {
      const std::size_t entry = (static_cast<std::size_t>(place / lanes) * 4 + k) * lanes + place % lanes;
      domain.nodes.force[block.target[entry]].force[0] += value_of(place, k);
      domain.nodes.force[block.target[entry]].moment[2] -= value_of(place, k);
    }
  };
  parallel_for(static_cast<Index>(shares.size()), domain.execution.threads, [&](Index s) {
    for (Index c = shares[s].first_chunk; c < shares[s].last_chunk; ++c) {
      const Chunk& chunk = domain.assembly.chunks()[c];
      for (Index place = chunk.first_group * lanes; place < chunk.last_group * lanes; ++place)
        add(domain.shells[chunk.block], place);
    }
  });
  domain.assembly.gather_interface(domain.nodes.force, domain.execution.threads);
}

TEST(Assembly, AddsUpLikeOneThreadHoweverElementsAreCut) {
  Domain whole = cut_sheet(73, 41, 1);
  ASSERT_EQ(whole.assembly.chunks().size(), 1U);
  std::vector<double> expected(whole.nodes.count(), 0.0);
  const ShellBlock& block = whole.shells[0];
  for (Index place = 0; place < block.elements; ++place)
    for (Index k = 0; k < 4; ++k) expected[block.nodes_of(place)[k]] += value_of(place, k);
  const auto compare = [&](Domain domain) {
    scatter_like_a_kernel(domain);
    for (Index i = 0; i < domain.nodes.count(); ++i) {
      ASSERT_EQ(domain.nodes.force[i].force[0], expected[i]) << i;
      ASSERT_EQ(domain.nodes.force[i].moment[2], -expected[i]) << i;
    }
  };
  for (const int threads : {1, 2, 3, 4, 7, 1000}) compare(cut_sheet(73, 41, threads));
  for (const Index groups : {1, 2, 5, 33, 1000}) compare(cut_sheet(73, 41, 3, groups));
}

TEST(Assembly, DealsOutSharesOfEqualCost) {
  for (const int threads : {2, 3, 7}) {
    const Domain domain = cut_sheet(64, 64, threads);
    const auto& shares = domain.assembly.shares();
    ASSERT_EQ(shares.size(), static_cast<std::size_t>(threads));
    Index next = 0;
    for (const ThreadShare& share : shares) {
      ASSERT_EQ(share.first_chunk, next);
      ASSERT_EQ(share.last_chunk, next + 1);
      next = share.last_chunk;
      const Chunk& chunk = domain.assembly.chunks()[share.first_chunk];
      EXPECT_NEAR(chunk.last_group - chunk.first_group, 256.0 / threads, 1.0);
    }
  }
}

TEST(Assembly, SharesCountWhatElementsCost) {
  model::Model model = sheet(64, 64);
  model.parts.push_back({.id = 2, .title = "second", .section = 0, .material = 0});
  for (std::size_t s = 0; s < model.shells.size(); s += 2) model.shells[s].part = 1;
  Domain domain = build(model, {});
  domain.execution.threads = 2;
  domain.shells[1].points = 20;  // 24 to 5, corners included
  deal_out(domain);
  ASSERT_EQ(domain.assembly.shares().size(), 2U);
  const Chunk& last = domain.assembly.chunks().back();
  EXPECT_EQ(last.block, 1);
  EXPECT_NEAR(last.last_group - last.first_group, 0.5 * 128 * 29 / 24, 1.0);
}

TEST(Assembly, SlotsAreClearedAfterTheGather) {
  Domain domain = cut_sheet(73, 41, 2);
  ASSERT_GT(domain.assembly.slots(), 1);
  scatter_like_a_kernel(domain);
  // The last slot takes what the fill lanes of the one block send and is never read.
  for (std::size_t s = domain.nodes.count(); s + 1 < domain.nodes.force.size(); ++s)
    EXPECT_EQ(domain.nodes.force[s].force[0], 0.0);
}

TEST(Assembly, DifferentSharesNeverWriteTheSamePlace) {
  model::Model model = sheet(30, 30);
  model.parts.push_back({.id = 2, .title = "second", .section = 0, .material = 0});
  for (std::size_t s = 0; s < model.shells.size(); s += 2) model.shells[s].part = 1;
  Execution execution;
  execution.threads = 5;
  const Domain domain = build(model, execution);
  std::set<Index> all;
  std::size_t sum = 0;
  for (const ThreadShare& share : domain.assembly.shares()) {
    std::set<Index> own;
    for (Index c = share.first_chunk; c < share.last_chunk; ++c) {
      const Chunk& chunk = domain.assembly.chunks()[c];
      const ShellBlock& block = domain.shells[chunk.block];
      for (Index group = chunk.first_group; group < chunk.last_group; ++group)
        for (Index e = 0; e < 4 * lanes; ++e) {
          const Index place = group * lanes + e % lanes;
          if (place < block.elements)
            own.insert(block.target[static_cast<std::size_t>(group) * 4 * lanes + e]);
        }
    }
    all.insert(own.begin(), own.end());
    sum += own.size();
  }
  EXPECT_EQ(all.size(), sum);
}

}  // namespace
}  // namespace crumple::domain::assembly_test
