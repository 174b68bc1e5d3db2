// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cellsearch/array.hpp"
#include "cellsearch/box.hpp"
#include "cellsearch/instruction_set.hpp"
#include "cellsearch/scene.hpp"
#include "production/grid.hpp"
#include "production/kernels.hpp"

namespace cellsearch::production {

/// What a NodeGrid is built from.
struct NodeGridInput {
  Positions positions;
  std::optional<std::span<const Index>> nodes{};  ///< those that take part, ascending; not set: all
  std::optional<Box> limit{};                     ///< nodes outside take no part
  Box box;                                        ///< around all nodes that take part; not empty
  CellEdges edges;
  InstructionSet set = InstructionSet::Portable;
  int threads = 1;
};

/// Nodes sorted into the cells of a grid; crowded cells have grids of their own, and so on, so that time and
/// memory are linear for any layout. Memory is kept from one build to the next.
class NodeGrid {
 public:  /// Sorts the nodes into the cells of one grid, chosen for input.box and input.edges. Returns the
          /// range of all
  /// nodes, taking part or not; unless that is finite the grid is of no use.
  NodeRange build(const NodeGridInput& input);

  /// The same with the grid of the last build, whatever input.box says; nodes outside it count as on its
  /// border.
  NodeRange build_again(const NodeGridInput& input);
  /// True if a cell of that grid has more than most_in_cell nodes.
  bool crowded() const { return crowded_; }

  /// Gives every crowded cell a grid of its own, and the crowded cells of these, until none is left. `sizes`:
  /// by node, the size of a territory around it [length], 0 where there is none; may be empty.
  void divide(const NodeGridInput& input, std::span<const float> sizes);

  NodeTable table() const;
  std::span<const Grid> grids() const { return grids_; }
  /// See QueryInput.
  const std::int32_t* child() const { return grids_.size() > 1 ? child_.data() : nullptr; }

  Offset cells() const { return static_cast<Offset>(starts_.size()); }
  Offset bytes() const;
  Index nodes() const { return count_; }

  /// Calls visit(places first..last-1) for runs of nodes that contain all nodes inside `box`; counts the
  /// cells.
  template <class Visit>
  void visit(const Box& box, Offset& cell_visits, const Visit& visit) const {
    visit_grid(0, box, cell_visits, visit);
  }

  /// The node at a place.
  Index node(std::uint32_t place) const { return node_[place]; }

 private:
  template <class Visit>
  void visit_grid(std::size_t number, const Box& box, Offset& cell_visits, const Visit& visit) const;
  NodeRange sort(const NodeGridInput& input);
  NodeRange sort_root(const NodeGridInput& input);
  std::uint32_t add_up(int blocks, std::size_t cells);
  void choose_participants(const NodeGridInput& input);
  void divide_cell(const NodeGridInput& input, std::span<const float> sizes, std::size_t parent, Offset cell);
  void sort_child(const NodeGridInput& input, const Grid& grid, std::uint32_t begin, std::uint32_t end);

  std::vector<Grid> grids_;
  Array<NodeRecord> records_;
  Array<std::uint8_t> coordinate_;  ///< x, y and z, one after another
  Array<Index> node_;
  Array<std::uint32_t> starts_;  ///< of all cells of all grids; one more for each grid
  Array<std::int32_t> child_;    ///< by entry of starts_; only if a cell is divided
  Array<std::uint32_t> counts_;  ///< of all threads but the last
  Array<Index> spare_;
  std::size_t stride_ = 0;  ///< from x to y to z
  Index count_ = 0;
  bool crowded_ = false;
};

/// The cells, clamped into the grid, that a box covers: the range of places of each row is visited.
struct CoveredCells {
  std::array<Index, 3> first;
  std::array<Index, 3> last;
};

CoveredCells covered_cells(const Grid& grid, const Box& box);

template <class Visit>
void NodeGrid::visit_grid(std::size_t number, const Box& box, Offset& cell_visits, const Visit& visit) const {
  const Grid& grid = grids_[number];
  const CoveredCells covered = covered_cells(grid, box);
  const auto [run, second, third] = grid.axis;
  const auto at = [](int axis) { return static_cast<std::size_t>(axis); };
  for (Index k = covered.first[at(third)]; k <= covered.last[at(third)]; ++k) {
    for (Index j = covered.first[at(second)]; j <= covered.last[at(second)]; ++j) {
      const Offset row =
          grid.first_cell + Offset{k} * grid.step[at(third)] + Offset{j} * grid.step[at(second)];
      const Offset begin = row + covered.first[at(run)];
      const Offset end = row + covered.last[at(run)] + 1;
      const std::uint32_t* const starts = starts_.data();
      cell_visits += end - begin;
      if (grids_.size() == 1 || starts[end] - starts[begin] <= most_in_cell) {
        visit(starts[begin], starts[end]);
        continue;
      }
      for (Offset cell = begin; cell < end; ++cell) {
        const std::int32_t child = child_[static_cast<std::size_t>(cell)];
        if (child >= 0) {
          visit_grid(static_cast<std::size_t>(child), box, cell_visits, visit);
        } else if (starts[cell] < starts[cell + 1]) {
          visit(starts[cell], starts[cell + 1]);
        }
      }
    }
  }
}

}  // namespace cellsearch::production
