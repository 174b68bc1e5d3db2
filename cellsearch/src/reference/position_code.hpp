// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "finder.hpp"
#include "reference/axis_cells.hpp"

namespace cellsearch {

/// The position code algorithm of M. Oldenburg & L. Nilsson, IJNME 37 (1994) 359-386.
///
/// Space is divided into boxes. The numbers of a node's box along x, y and z are merged into one integer, its
/// position code; the codes are sorted, and a segment finds the nodes in its boxes by binary search. No array
/// has the size of the number of boxes: memory is O(N) however empty the space is. Time is O(N log N).
///
/// The original text could not be read. Ours are: the order of merging (x fastest, which gives eq. 6 of the
/// paper), boxes as large as the cells of the other methods, one binary search per row of boxes, whose codes
/// follow each other, and the way out for a territory of more rows than there are nodes: it looks at all of
/// them.
class PositionCode final : public Finder {
 public:
  /// The code of a node's box, and the node.
  struct Entry {
    std::uint64_t code;
    Index node;
    bool operator<(const Entry& other) const {
      return code != other.code ? code < other.code : node < other.node;
    }
  };

  void build(const FinderInput& input) override;
  void query(Index begin, Index end, FoundRows& rows) const override;
  Offset cells() const override;
  Offset bytes() const override { return static_cast<Offset>(entries_.size() * sizeof(Entry)); }
  Offset nodes_in_domain() const override { return static_cast<Offset>(entries_.size()); }

  /// The position code of box (ix, iy, iz): ix + Nx (iy + Ny iz).
  std::uint64_t code_of(Index ix, Index iy, Index iz) const;

  /// For tests: the sorted codes.
  std::span<const Entry> entries() const { return entries_; }

 private:
  void visit_row(std::uint64_t first, std::uint64_t last, Index segment, const Box& box,
                 FoundRows& rows) const;
  void visit_boxes(const Box& cull, Index segment, const Box& box, FoundRows& rows) const;

  FinderInput input_;
  Box bounds_;
  std::array<AxisCells, 3> boxes_;
  std::vector<Entry> entries_;
};

}  // namespace cellsearch
