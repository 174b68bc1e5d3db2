// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "cellsearch/array.hpp"
#include "cellsearch/instruction_set.hpp"
#include "cellsearch/types.hpp"
#include "finder.hpp"
#include "production/grid.hpp"

namespace cellsearch::production {

/// What one pass over nodes learns.
struct NodeRange {
  Box box;
  bool finite = true;
};

/// Smallest and largest of values by axis.
struct ValueRange {
  double lo[3] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                  std::numeric_limits<double>::infinity()};
  double hi[3] = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
  bool bad = false;  ///< something was not finite; lo and hi mean nothing then
};

/// Nodes sorted by cell, and what a query needs to read them. Views; see NodeGrid.
struct NodeTable {
  const NodeRecord* records = nullptr;  ///< by node number
  const std::uint8_t* x = nullptr;      ///< lattice number >> fine_bits, modulo 256, by place
  const std::uint8_t* y = nullptr;
  const std::uint8_t* z = nullptr;
  const Index* nodes = nullptr;           ///< node number by place, ascending within a cell
  const std::uint32_t* starts = nullptr;  ///< by cell: the first place; the next cell's ends it
};

/// What cannot be done in the straight loops of a kernel. Called for few segments.
class QueryHelp {
 public:
  virtual ~QueryHelp() = default;

  /// All candidates of `segment`, ascending, in rows.spare; counts visits. For territories that cover many
  /// cells, or cells with grids of their own beside others.
  virtual void collect(Index segment, FoundRows& rows) const = 0;

  /// The candidate test in double precision.
  virtual bool accepts(Index segment, Index node) const = 0;
};

/// Everything that a query reads.
struct QueryInput {
  NodeTable table;
  Positions positions;
  const Grid* grids = nullptr;  ///< the first covers all nodes
  /// By cell, as the starts: the grid that divides it further, or -1. Null if there is only one grid.
  const std::int32_t* child = nullptr;
  const Index* connectivity = nullptr;
  const double* segment_expansion = nullptr;  ///< by segment, or null
  const std::uint8_t* active = nullptr;       ///< by segment, or null
  double expansion = 0.0;                     ///< common to all segments, with the largest radius [length]
  bool plain = true;                          ///< the territory is the whole test
  const QueryHelp* help = nullptr;
};

/// Input of sorting nodes into cells.
struct SortInput {
  Positions positions;
  Grid grid;
  NodeRecord* records = nullptr;
};

/// Where the sorted nodes go.
struct SortOutput {
  std::uint8_t* x = nullptr;
  std::uint8_t* y = nullptr;
  std::uint8_t* z = nullptr;
  Index* nodes = nullptr;
};

/// The loops that depend on the instruction set.
struct Kernels {
  /// Range of the nodes begin..end-1.
  NodeRange (*measure)(const Positions&, Index begin, Index end);
  /// Largest of the numbers, taken as unsigned.
  std::uint32_t (*largest)(std::span<const Index> numbers);
  /// Writes the records of nodes begin..end-1, cells as places, and counts them by cell unless `counts` is
  /// null.
  /// Measures them on the way.
  NodeRange (*classify)(const SortInput&, Index begin, Index end, std::uint32_t* counts);
  /// Puts nodes begin..end-1 at the places that `next` counts up by cell, and notes the places.
  void (*place)(const SortInput&, const SortOutput&, Index begin, Index end, std::uint32_t* next);
  /// Finder::query.
  void (*query)(const QueryInput&, Index begin, Index end, FoundRows& rows);
  /// Includes now - then of so many nodes, each array x, y, z, x, ...; `then` may be null. The same bits for
  /// every instruction set, but for the sign of zeros.
  void (*include)(const double* now, const double* then, std::size_t nodes, ValueRange& range);
};

/// The loops for an instruction set that this processor has.
const Kernels& kernels(InstructionSet set);

/// Makes room for `more` numbers after the first `used` and returns the place after these.
Index* reserve(Array<Index>& numbers, std::size_t used, std::size_t more);
/// Cuts to `used` numbers.
void trim(Array<Index>& numbers, std::size_t used);
/// Replaces the rows of the segments at + j for which `helped[j]` by what input.help collects. The rows of
/// this batch begin at `from` and end at `ends`. Returns the new end of the last.
Offset collect_rows(const QueryInput& input, Index at, std::span<const bool> helped, FoundRows& rows,
                    Offset from, Offset* ends);
/// Sorts in ascending order.
void sort_row(Index* begin, Index* end);

}  // namespace cellsearch::production
