// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace crumple::report {

/// Histories that are longer than this are thinned out for the report [bytes].
inline constexpr std::size_t most_history_bytes = 4U << 20U;

/// Drops what stands behind the last line end: the row that a run is writing.
std::string whole_rows(std::string text);

struct ThinnedHistory {
  std::string text;
  int every = 1;  ///< of so many moments one was kept
};

/// Keeps the header, all rows of every n-th moment and those of the last, with the smallest n that makes the
/// text of a history (CSV, time in the first column) about `most` bytes or less.
ThinnedHistory thin_history(std::string text, std::size_t most);

}  // namespace crumple::report
