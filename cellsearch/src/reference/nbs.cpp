// SPDX-License-Identifier: BSD-3-Clause
#include "reference/nbs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "cellsearch/error.hpp"
#include "cellsearch/territory.hpp"

namespace cellsearch {
namespace {

/// The longest side of a box [length].
double size_of(const Box& box) {
  return std::max({box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]});
}

/// Calls visit(number) for `cell` and its neighbours along one axis.
template <class Visit>
void for_neighbours(const AxisCells& cells, Index cell, const Visit& visit) {
  const Index last = std::min(cell + 1, cells.count - 1);
  for (Index number = std::max(cell - 1, 0); number <= last; ++number) visit(number);
}

/// Calls visit(body) for all bodies of a list. The visitor may push the body into other lists.
template <class Visit>
void for_bodies(const BodyLists& lists, Index list, const Visit& visit) {
  for (Index body = lists.head(list); body >= 0; body = lists.next(body)) visit(body);
}

}  // namespace

Index Nbs::cell_of_place(int axis, Index place) const {
  return this->axis(axis).of(input_.scene.positions[input_.scene.participant(place)][axis]);
}

Index Nbs::cell_of_body(int axis, Index body) const {
  return this->axis(axis).of(bodies_[static_cast<std::size_t>(body)].centre[axis]);
}

/// Lists the segments that take part. Returns the size of the largest [length]; throws if it is too large for
/// the rest.
double Nbs::collect_bodies() {
  double largest = 0.0;
  double sum = 0.0;  // of all sizes, relative to the largest so far: that cannot overflow
  Index largest_segment = -1;
  const Index segments = static_cast<Index>(input_.scene.segments.count());
  for (Index segment = 0; segment < segments; ++segment) {
    const Box box = input_.test.culling_box(segment);
    if (!input_.test.active(segment) || !box.intersects(bounds_)) continue;
    bodies_.push_back({segment, {}});
    for (int axis = 0; axis < 3; ++axis) {
      bodies_.back().centre[axis] = 0.5 * box.lo[axis] + 0.5 * box.hi[axis];
    }
    const double size = size_of(box);
    if (size > largest) {
      sum *= largest / size;
      largest = size;
      largest_segment = segment;
    }
    if (largest > 0.0) sum += size / largest;
  }
  const double mean = sum / static_cast<double>(bodies_.size());
  // False where there is no size at all, or one beyond the range of numbers: one cell serves both.
  if (size_limit * mean < 1.0 && largest > 0.0) {
    throw Error(ErrorKind::UnsuitedMethod, largest_segment,
                "The territory of segment " + std::to_string(largest_segment) + " is " +
                    std::to_string(1.0 / mean) + " times as large as the mean one, but method nbs is for " +
                    "bodies of similar size and allows " + std::to_string(size_limit) + " times at most.");
  }
  return largest;
}

/// Cells for a largest body of size `largest` [length].
void Nbs::make_cells(double largest) {
  double farthest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    farthest = std::max({farthest, std::fabs(bounds_.lo[axis]), std::fabs(bounds_.hi[axis])});
  }
  // A node is at most half a territory from the centre. What is added keeps the difference of the two cell
  // numbers at 1 although the centre, the distance from the first cell and the number itself are all rounded.
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double width = (0.5 + 0x1p-20) * largest + 8.0 * epsilon * (farthest + largest);
  const std::size_t bodies = input_.scene.participants() + bodies_.size();
  const Index most = static_cast<Index>(std::min(bodies, static_cast<std::size_t>(AxisCells::most_cells)));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cells_[axis] = AxisCells::of_width(bounds_.lo[axis], bounds_.hi[axis], width, most);
  }
}

void Nbs::put_on_layers() {
  const Index places = static_cast<Index>(input_.scene.participants());
  const Index bodies = static_cast<Index>(bodies_.size());
  nodes_by_layer_.prepare(cells_[2].count, places);
  nodes_by_row_.prepare(cells_[1].count, places);
  nodes_by_cell_.prepare(cells_[0].count, places);
  bodies_by_layer_.prepare(cells_[2].count, bodies);
  bodies_by_row_.prepare(cells_[1].count, bodies);
  for (Index place = 0; place < places; ++place) {
    if (!in_limit(input_, input_.scene.participant(place))) continue;
    nodes_by_layer_.push(cell_of_place(2, place), place);
    ++nodes_in_domain_;
  }
  for (Index body = 0; body < bodies; ++body) bodies_by_layer_.push(cell_of_body(2, body), body);
}

/// Looks for the nodes in the territory of one body, when the nodes of its row and the neighbouring rows
/// are on lists by cell.
void Nbs::detect_body(const Body& body) {
  const Box box = territory(input_.scene, body.segment);
  Row& row = rows_[static_cast<std::size_t>(body.segment)];
  row.begin = static_cast<Offset>(found_.size());
  for_neighbours(cells_[0], cells_[0].of(body.centre[0]), [&](Index cell) {
    ++row.cell_visits;
    for_bodies(nodes_by_cell_, cell, [&](Index place) {
      const Index node = input_.scene.participant(place);
      ++row.raw_visits;
      if (input_.test(body.segment, box, node)) found_.push_back(node);
    });
  });
  std::sort(found_.begin() + row.begin, found_.end());
  row.count = static_cast<Index>(static_cast<Offset>(found_.size()) - row.begin);
}

/// One row of cells of the layer at work, whose nodes and those of the neighbouring layers are on lists by
/// row.
void Nbs::detect_row(Index row) {
  for_neighbours(cells_[1], row, [&](Index near) {
    for_bodies(nodes_by_row_, near,
               [&](Index place) { nodes_by_cell_.push(cell_of_place(0, place), place); });
  });
  for_bodies(bodies_by_row_, row, [&](Index body) { detect_body(bodies_[static_cast<std::size_t>(body)]); });
  for_neighbours(cells_[1], row, [&](Index near) {
    for_bodies(nodes_by_row_, near, [&](Index place) { nodes_by_cell_.clear(cell_of_place(0, place)); });
  });
}

void Nbs::detect_layer(Index layer) {
  for_neighbours(cells_[2], layer, [&](Index near) {
    for_bodies(nodes_by_layer_, near,
               [&](Index place) { nodes_by_row_.push(cell_of_place(1, place), place); });
  });
  for_bodies(bodies_by_layer_, layer, [&](Index body) { bodies_by_row_.push(cell_of_body(1, body), body); });
  for_bodies(bodies_by_layer_, layer, [&](Index body) {
    const Index row = cell_of_body(1, body);
    if (bodies_by_row_.head(row) == body) detect_row(row);
  });
  // Lists are emptied by their bodies, not one by one: most rows may be empty.
  for_neighbours(cells_[2], layer, [&](Index near) {
    for_bodies(nodes_by_layer_, near, [&](Index place) { nodes_by_row_.clear(cell_of_place(1, place)); });
  });
  for_bodies(bodies_by_layer_, layer, [&](Index body) { bodies_by_row_.clear(cell_of_body(1, body)); });
}

/// Works through the layers in which there is a body: each is met once, at the head of its list.
void Nbs::detect() {
  const Index bodies = static_cast<Index>(bodies_.size());
  for (Index body = 0; body < bodies; ++body) {
    const Index layer = cell_of_body(2, body);
    if (bodies_by_layer_.head(layer) == body) detect_layer(layer);
  }
}

void Nbs::build(const FinderInput& input) {
  input_ = input;
  bounds_ = bounds_of_nodes(input);
  nodes_in_domain_ = 0;
  bodies_.clear();
  found_.clear();
  rows_.assign(input.scene.segments.count(), Row{});
  cells_ = {};
  if (bounds_.empty()) return;
  make_cells(collect_bodies());
  put_on_layers();
  detect();
}

void Nbs::query(Index begin, Index end, FoundRows& rows) const {
  for (Index segment = begin; segment < end; ++segment) {
    const Row& row = rows_[static_cast<std::size_t>(segment)];
    const auto from = found_.begin() + row.begin;
    rows.nodes->insert(rows.nodes->end(), from, from + row.count);
    rows.raw_visits += row.raw_visits;
    rows.cell_visits += row.cell_visits;
    rows.ends[segment - begin] = static_cast<Offset>(rows.nodes->size());
  }
}

Offset Nbs::cells() const {
  return Offset{cells_[0].count} * cells_[1].count * cells_[2].count;
}

Offset Nbs::bytes() const {
  const Offset integers = nodes_by_layer_.integers() + nodes_by_row_.integers() + nodes_by_cell_.integers() +
                          bodies_by_layer_.integers() + bodies_by_row_.integers();
  return integers * static_cast<Offset>(sizeof(Index)) +
         static_cast<Offset>(bodies_.size() * sizeof(Body) + rows_.size() * sizeof(Row) +
                             found_.size() * sizeof(Index));
}

}  // namespace cellsearch
