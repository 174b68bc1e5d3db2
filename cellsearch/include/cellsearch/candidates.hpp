// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "cellsearch/array.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch {

/// Candidate pairs as compressed rows: one row per segment, in each row the nodes in ascending order, none
/// twice.
///
/// Node p is a candidate of segment s if p takes part, lies in the closed territory box of s and is none of
/// the nodes of s; where the user has given a cell domain, p must also lie inside it (surface included).
struct Candidates {
  Array<Offset> first;  ///< segments + 1 numbers: row s is node[first[s]] ... node[first[s + 1] - 1]
  Array<Index> node;    ///< the nodes of all rows

  /// Number of rows.
  Index segments() const { return first.empty() ? 0 : static_cast<Index>(first.size() - 1); }

  /// Number of pairs.
  Offset pairs() const { return static_cast<Offset>(node.size()); }

  /// The candidate nodes of `segment`.
  std::span<const Index> of(Index segment) const {
    const std::size_t begin = static_cast<std::size_t>(first[static_cast<std::size_t>(segment)]);
    const std::size_t end = static_cast<std::size_t>(first[static_cast<std::size_t>(segment) + 1]);
    return {node.data() + begin, end - begin};
  }

  bool operator==(const Candidates&) const = default;
};

}  // namespace cellsearch
