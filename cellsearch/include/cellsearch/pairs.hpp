// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "cellsearch/array.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch {

/// Pairs i < j of things of one kind (segments, edges) as compressed rows: row i holds all its j in ascending
/// order, none twice.
struct Pairs {
  Array<Offset> first;  ///< things + 1 numbers: row i is second[first[i]] ... second[first[i + 1] - 1]
  Array<Index> second;  ///< the j of all rows

  /// Number of rows: of things, paired or not.
  Index rows() const { return first.empty() ? 0 : static_cast<Index>(first.size() - 1); }

  /// Number of pairs.
  Offset count() const { return static_cast<Offset>(second.size()); }

  /// All j > i that are paired with i.
  std::span<const Index> of(Index i) const {
    const std::size_t begin = static_cast<std::size_t>(first[static_cast<std::size_t>(i)]);
    const std::size_t end = static_cast<std::size_t>(first[static_cast<std::size_t>(i) + 1]);
    return {second.data() + begin, end - begin};
  }

  /// Calls visitor(i, j) for all pairs, i ascending and for each of them j ascending.
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    for (Index i = 0; i < rows(); ++i) {
      for (const Index j : of(i)) visitor(i, j);
    }
  }

  bool operator==(const Pairs&) const = default;
};

}  // namespace cellsearch
