// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cellsearch/box.hpp"
#include "cellsearch/distributed/distributed.hpp"
#include "cellsearch/error.hpp"

namespace cellsearch {

/// What every rank tells all others at a search.
struct RankSummary {
  Box nodes;                 ///< around the participants with their radii [length]; empty if there are none
  Box territories;           ///< around those of the active segments [length]
  double expansion = 0.0;    ///< c [length]
  std::uint64_t common = 0;  ///< hash of what must be the same on all ranks, beside c
  std::int64_t node_count = 0;         ///< of the rank's scene
  std::int32_t bad = 0;                ///< not 0 if the input is wrong
  std::int32_t expansion_differs = 0;  ///< not 0 if there are expansions by segment
};

/// Throws Error for input of one rank that is wrong. O(N).
void check_rank(const RankScene& own, int threads);

/// The summary of checked input.
RankSummary summarise(const RankScene& own, const Settings& settings);

/// Collective: all ranks exchange their summaries; throws on all if `failure` is set on any, or if they do
/// not agree.
void exchange_summaries(Transport& transport, const RankSummary& own, const std::optional<Error>& failure,
                        Gathered& memory, std::vector<RankSummary>& all);

/// Collective: returns if no rank has a failure, else throws on all.
void agree(Transport& transport, const std::optional<Error>& failure);

}  // namespace cellsearch
