// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cellsearch/linked_list.hpp"
#include "finder.hpp"

namespace cellsearch {

/// The paper's algorithm as printed: nodes in linked lists by cell, and for each segment a visit to all cells
/// that its territory intersects. Kept in this form as the reference that faster methods are compared with.
class LinkedCell final : public Finder {
 public:
  void build(const FinderInput& input) override;
  void query(Index begin, Index end, FoundRows& rows) const override;
  Offset cells() const override { return input_.grid.count(); }
  Offset bytes() const override { return 4 * list_.integers(); }
  Offset nodes_in_domain() const override { return list_.linked(); }

 private:
  void visit_cell(Index cell, Index segment, const Box& box, FoundRows& rows) const;

  FinderInput input_;
  LinkedList list_;  // holds places in the list of participants, which ascend with the node numbers
};

}  // namespace cellsearch
