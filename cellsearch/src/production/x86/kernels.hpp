// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "production/batch.hpp"
#include "production/kernels.hpp"
#include "production/x86/hits.hpp"
#include "production/x86/lanes.hpp"
#include "production/x86/motion.hpp"
#include "production/x86/nodes.hpp"
#include "production/x86/rows.hpp"
#include "production/x86/runs.hpp"

namespace cellsearch::production {
namespace {

/// Finder::query: 64 segments at a time through six loops, each short enough to keep the processor's window
/// full: territories, runs, test, hits, faces, rows. docs/production.md explains them.
template <InstructionSet Set>
void query(const QueryInput& input, Index begin, Index end, FoundRows& rows) {
  using Runs = RunLoops<Set>;
  using Hit = HitLoops<Set>;
  using Rows = RowLoop<Set>;
  Batch batch;
  typename Hit::Hits hits;
  batch.raw_visits = 0;
  batch.cell_visits = 0;
  batch.too_many = {};
  batch.any_too_many = false;
  batch.long_count = 0;
  for (Entry& entry : batch.entries) entry.base = {};
  for (LatticeBox& box : batch.boxes) box.grid = 0;
  Offset used = 0;
  for (Index at = begin; at < end; at += batch_segments) {
    const Index count = end - at < batch_segments ? end - at : batch_segments;
    const bool long_runs = batch.long_count > batch_segments / 12;
    if (input.child == nullptr) {
      Runs::territories(input, at, count, batch);
      if (long_runs) {
        Runs::template find_runs<false, Runs::LongRuns::Frequent>(input, at, count, batch);
      } else {
        Runs::template find_runs<false, Runs::LongRuns::Rare>(input, at, count, batch);
      }
    } else {
      Runs::nested_territories(input, at, count, batch);
      Runs::template find_runs<true, Runs::LongRuns::Rare>(input, at, count, batch);
    }
    Hit::test(input.table, batch);
    const bool many = batch.many_count > batch_segments / 12;
    std::uint32_t found = 0;
    if (many) {
      found = Hit::template list_hits<8>(input, at, rows, batch, hits);
    } else {
      found = Hit::template list_hits<4>(input, at, rows, batch, hits);
    }
    if (input.child == nullptr) {
      Hit::template check_faces<false>(input, at, found, batch, hits);
    } else {
      Hit::template check_faces<true>(input, at, found, batch, hits);
    }
    Index* const to = reserve(*rows.nodes, static_cast<std::size_t>(used), found + 16);
    Offset* const ends = rows.ends + (at - begin);
    const Offset before = used;
    Index* behind = nullptr;
    if (many) {
      behind = Rows::template write_rows<false>(count, batch, hits, to, before, ends);
    } else {
      behind = Rows::template write_rows<true>(count, batch, hits, to, before, ends);
    }
    used += behind - to;
    if (batch.any_too_many) [[unlikely]] {
      used = collect_rows(input, at, {batch.too_many.data(), static_cast<std::size_t>(count)}, rows, before,
                          ends);
      batch.too_many = {};
      batch.any_too_many = false;
    }
  }
  rows.raw_visits += batch.raw_visits;
  rows.cell_visits += batch.cell_visits;
  trim(*rows.nodes, static_cast<std::size_t>(used));
}

template <InstructionSet Set>
constexpr Kernels x86_kernels{NodeLoops<Set>::measure,
                              NodeLoops<Set>::largest,
                              NodeLoops<Set>::classify,
                              NodeLoops<Set>::place,
                              query<Set>,
                              MotionLoops<Set>::include};
}  // namespace
}  // namespace cellsearch::production
