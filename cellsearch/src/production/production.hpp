// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "finder.hpp"
#include "production/node_grid.hpp"

namespace cellsearch {

/// The method to use: nodes sorted by cell, rows of cells as runs of one-byte coordinates that vector
/// instructions test 64 at a time, grids within crowded cells. Exact and linear for any layout; see
/// docs/production.md.
class Production final : public Finder, private production::QueryHelp {
 public:
  explicit Production(InstructionSet set) : set_(set) {}

  void build(const FinderInput& input) override;
  void query(Index begin, Index end, FoundRows& rows) const override;
  Offset cells() const override { return grid_.cells(); }
  Offset bytes() const override { return grid_.bytes() + static_cast<Offset>(sizes_.size() * sizeof(float)); }
  Offset nodes_in_domain() const override { return grid_.nodes(); }

 private:
  void collect(Index segment, FoundRows& rows) const override;
  bool accepts(Index segment, Index node) const override;
  bool may_keep_edges();
  bool sort_again(const production::NodeGridInput& nodes);
  void sort_anew(production::NodeGridInput& nodes, bool keep_edges);
  Box measure(const production::NodeGridInput& nodes);
  Box box_of(std::span<const Index> nodes) const;
  bool reaches_out() const;
  void query_one_by_one(Index begin, Index end, FoundRows& rows) const;
  void measure_sizes(const FinderInput& input);

  /// What must be as before for the cells of the last build to be used again.
  struct Layout {
    std::size_t nodes = 0;
    std::size_t participants = 0;
    std::size_t segments = 0;
    double expansion = 0.0;
    bool operator==(const Layout&) const = default;
  };

  InstructionSet set_;
  Layout layout_;
  int builds_left_ = 0;          ///< that may use cells of the same edges
  double layers_ = 2.0;          ///< see measure_layers()
  production::CellEdges edges_;  ///< of the cells in use
  bool out_of_lattice_ = false;
  Box all_nodes_;  ///< of all nodes, taking part or not [length]
  Box box_;        ///< of the nodes when the cells were chosen [length]
  FinderInput input_;
  production::NodeGrid grid_;
  Array<float> sizes_;  ///< by node, of a territory around it; only if cells are crowded
};

}  // namespace cellsearch
