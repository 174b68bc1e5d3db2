// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "cellsearch/array.hpp"
#include "cellsearch/error.hpp"
#include "cellsearch/scene.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch {

/// The nearest nodes of every node as compressed rows, in each row by ascending distance, at equal distances
/// by ascending number. Rows of nodes that take no part are empty.
struct NearestNodes {
  Array<Offset> first;     ///< nodes + 1 numbers: row p is at first[p] ... first[p + 1] - 1
  Array<Index> node;       ///< the nodes of all rows
  Array<double> distance;  ///< their distances [length]

  /// Number of rows: of nodes, participating or not.
  Index rows() const { return first.empty() ? 0 : static_cast<Index>(first.size() - 1); }

  /// Number of entries in all rows.
  Offset count() const { return static_cast<Offset>(node.size()); }

  /// The nodes nearest to node `p`.
  std::span<const Index> of(Index p) const { return {node.data() + begin(p), begin(p + 1) - begin(p)}; }

  /// The distances of the nodes in of(p) [length].
  std::span<const double> distances_of(Index p) const {
    return {distance.data() + begin(p), begin(p + 1) - begin(p)};
  }

  /// Calls visitor(p, node, distance) for all entries in the order of the rows.
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    for (Index p = 0; p < rows(); ++p) {
      for (std::size_t entry = begin(p); entry < begin(p + 1); ++entry)
        visitor(p, node[entry], distance[entry]);
    }
  }

  bool operator==(const NearestNodes&) const = default;

 private:
  std::size_t begin(Index p) const { return static_cast<std::size_t>(first[static_cast<std::size_t>(p)]); }
};

/// Which nodes count as nearest.
struct NearestSettings {
  /// k, the most nodes per row, >= 1.
  Index neighbours = 1;

  /// Nodes farther away are left out [length], >= 0; may be infinite.
  double largest_distance = std::numeric_limits<double>::infinity();

  /// Leaves out nodes with which a node shares an active segment.
  bool exclude_connected = false;

  /// Number of threads, >= 1. The results are bitwise the same for any number.
  int threads = 1;
};

/// For every participating node the k nearest other participating nodes. Exact: sorted by the square of the
/// distance, (x x + y y) + z z in double, and by number where that is equal; the distance given is its root.
/// (Distances below 1e-150 of the largest coordinate may count as none at all: their squares vanish.)
///
/// Of the scene count the positions and `nodes`, and if connected nodes are left out the segments and
/// `segment_active`. Time and memory are O(k nodes) for any density that varies gradually or in patches, but
/// a node looks at all others that are as near as its k-th: where very many coincide the time is their
/// square. Keep the object: it re-uses its memory. One thread at a time may use it.
class NearestSearch {
 public:
  /// Throws Error(BadSetting).
  explicit NearestSearch(const NearestSettings& settings = {});
  ~NearestSearch();
  NearestSearch(NearestSearch&&) noexcept;
  NearestSearch& operator=(NearestSearch&&) noexcept;
  NearestSearch(const NearestSearch&) = delete;
  NearestSearch& operator=(const NearestSearch&) = delete;

  /// All rows. The scene is looked at during this call only. The result belongs to this object and is
  /// overwritten by the next call. Throws Error (see ErrorKind); the result is then empty.
  const NearestNodes& find(const Scene& scene);

  /// Calls visitor(p, node, distance) for all entries; what it throws reaches the caller.
  template <class Visitor>
  void visit(const Scene& scene, Visitor&& visitor) {
    find(scene).visit(std::forward<Visitor>(visitor));
  }

  /// Moves the last result out of the object.
  NearestNodes take() { return std::move(nearest_); }

  /// Distances computed by the last search; the same for any number of threads.
  Offset visits() const;

  /// Working memory besides the result [bytes].
  Offset bytes() const;

 private:
  class Rows;

  NearestSettings settings_;
  NearestNodes nearest_;
  std::unique_ptr<Rows> rows_;
};

}  // namespace cellsearch
