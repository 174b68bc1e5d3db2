// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "cellsearch/array.hpp"
#include "finder.hpp"
#include "reference/axis_cells.hpp"

namespace cellsearch {

/// Singly connected lists of bodies in integer arrays: head[list], next[body]. A body is in one list at most.
class BodyLists {
 public:
  /// Makes `lists` empty lists for bodies 0..bodies-1. Re-uses memory.
  void prepare(Index lists, Index bodies) {
    head_.assign(static_cast<std::size_t>(lists), -1);
    next_.resize(static_cast<std::size_t>(bodies));
  }

  /// Puts `body` at the front of `list`.
  void push(Index list, Index body) {
    next_[static_cast<std::size_t>(body)] = head(list);
    head_[static_cast<std::size_t>(list)] = body;
  }

  /// Forgets one list, in a time that does not depend on its length.
  void clear(Index list) { head_[static_cast<std::size_t>(list)] = -1; }

  /// The body pushed last, negative if the list is empty.
  Index head(Index list) const { return head_[static_cast<std::size_t>(list)]; }

  /// The body pushed before `body` into the same list, negative if it was the first.
  Index next(Index body) const { return next_[static_cast<std::size_t>(body)]; }

  /// Number of integers stored.
  Offset integers() const { return static_cast<Offset>(head_.size()) + static_cast<Offset>(next_.size()); }

 private:
  std::vector<Index> head_;
  std::vector<Index> next_;
};

/// The contact detection without binary search of A. Munjiza & K. R. F. Andrews, "NBS contact detection
/// algorithm for bodies of similar size", IJNME 43 (1998) 131-149; in space as in A. Munjiza, "The Combined
/// Finite-Discrete Element Method", Wiley 2004, chapter 3.
///
/// Bodies are put on lists by the layer of cells (z) in which their centre lies. Layer by layer, the bodies
/// of the layer and its neighbours are put on lists by row (y); row by row, those of the row and its
/// neighbours on lists by cell (x); each body then meets those in its cell and the neighbouring ones. Only
/// the lists of the layer and the row at work exist, so no array has the size of the number of cells, and
/// there is nothing to sort or to search.
///
/// Here two kinds of bodies meet. A segment is a body as large as its territory, with the territory's centre;
/// a node is a body of size 0. The original makes a cell as wide as the centres of two bodies in contact can
/// be apart, the size of the largest body; between a territory and a point that is half the largest
/// territory, and so wide (and a little wider, for rounding) are the cells here. A node inside a territory is
/// no further than a cell from its centre along each axis, hence in the same cell or in one of its 26
/// neighbours: nothing is missed. But cells made for the largest territory cost small ones many visits: the
/// method is for bodies of similar size, and build() refuses a scene whose largest territory exceeds
/// `size_limit` times the mean one with Error(UnsuitedMethod), naming the segment. The size of a territory is
/// the longest side of its box. Nodes outside a given domain, and segments that are not active or do not
/// reach the box around the nodes, are no bodies.
///
/// Ours are: the two kinds; one set of y-lists for all three layers and one of x-lists for all nine rows,
/// because a segment needs all its neighbours, where the original visits half of them for pairs of like
/// bodies; the limit 3; at most as many cells along an axis as bodies, however far they are apart. The method
/// finds the pairs of all segments at once, so that belongs to build(); query() hands out stored rows.
class Nbs final : public Finder {
 public:
  /// The largest territory over the mean one beyond which a scene is refused. At 3, and nodes spread over
  /// surfaces, a mean segment looks at up to 9 times as many nodes as it would in a scene of equal sizes.
  static constexpr double size_limit = 3.0;

  void build(const FinderInput& input) override;
  void query(Index begin, Index end, FoundRows& rows) const override;
  Offset cells() const override;
  Offset bytes() const override;
  Offset nodes_in_domain() const override { return nodes_in_domain_; }

  /// For tests: the cells along an axis.
  const AxisCells& axis(int number) const { return cells_[static_cast<std::size_t>(number)]; }

 private:
  /// A segment that takes part, and the centre of its territory [length].
  struct Body {
    Index segment;
    Point centre;
  };

  /// Where the candidates of a segment are in found_, and what it took to find them.
  struct Row {
    Offset begin = 0;
    Index count = 0;
    Index raw_visits = 0;
    Index cell_visits = 0;
  };

  double collect_bodies();
  void make_cells(double largest);
  void put_on_layers();
  void detect();
  void detect_layer(Index layer);
  void detect_row(Index row);
  void detect_body(const Body& body);
  Index cell_of_place(int axis, Index place) const;
  Index cell_of_body(int axis, Index body) const;

  FinderInput input_;
  Box bounds_;
  std::array<AxisCells, 3> cells_;
  BodyLists nodes_by_layer_;  // nodes are numbered by their place in the list of participants
  BodyLists nodes_by_row_;
  BodyLists nodes_by_cell_;
  std::vector<Body> bodies_;
  BodyLists bodies_by_layer_;
  BodyLists bodies_by_row_;
  std::vector<Row> rows_;
  Array<Index> found_;
  Offset nodes_in_domain_ = 0;
};

}  // namespace cellsearch
