// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "cellsearch/array.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch {

/// Puts points in an order in which neighbours in the list are mostly neighbours in space: along Morton's
/// curve through 2^21 cells each way, and anew inside each cell that holds many points, so that it works for
/// any mix of densities. Memory is re-used.
class SpatialOrder {
 public:
  /// The numbers of the points (3 finite coordinates each) in order. O(points) but for cells within cells.
  std::span<const Index> sort(std::span<const double> xyz);

  /// Memory in use [bytes].
  Offset bytes() const;

 private:
  struct Item {
    std::uint64_t code;
    Index point;
  };

  void sort_range(std::span<const double> xyz, std::size_t begin, std::size_t end);
  bool encode(std::span<const double> xyz, std::size_t begin, std::size_t end);
  void sort_by_code(std::size_t begin, std::size_t end);

  Array<Item> items_;
  Array<Item> scratch_;
  Array<Index> order_;
};

}  // namespace cellsearch
