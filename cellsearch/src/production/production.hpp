// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
  void measure_sizes(const FinderInput& input);

  InstructionSet set_;
  FinderInput input_;
  production::NodeGrid grid_;
  Array<float> sizes_;  ///< by node, of a territory around it; only if cells are crowded
};

}  // namespace cellsearch
