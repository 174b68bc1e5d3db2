// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "cellsearch/candidates.hpp"
#include "cellsearch/search.hpp"

namespace cellsearch {

/// The first place at which two results differ.
struct Difference {
  Index segment = -1;    ///< the row; one past the shorter result if the numbers of rows differ
  Index node = -1;       ///< the node found by one only; -1 if the numbers of rows differ
  bool missing = false;  ///< true: expected, not found; false: found, not expected (or found twice)

  /// One sentence for a message.
  std::string describe() const;
};

/// Compares `found` with `expected` row by row; nothing if they are equal.
std::optional<Difference> first_difference(const Candidates& found, const Candidates& expected);

/// Compares `found` with what brute force gives for `scene` under `settings` (domain and threads; the method
/// is ignored): nothing if they are equal. O(N^2) time. Throws what Search::build throws.
std::optional<Difference> verify(const Candidates& found, const Scene& scene, const Settings& settings);

}  // namespace cellsearch
