// SPDX-License-Identifier: BSD-3-Clause
#include "reference/position_code.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "cellsearch/territory.hpp"

namespace cellsearch {

std::uint64_t PositionCode::code_of(Index ix, Index iy, Index iz) const {
  const auto wide = [](Index number) { return static_cast<std::uint64_t>(number); };
  return (wide(iz) * wide(boxes_[1].count) + wide(iy)) * wide(boxes_[0].count) + wide(ix);
}

Offset PositionCode::cells() const {
  return Offset{boxes_[0].count} * boxes_[1].count * boxes_[2].count;
}

void PositionCode::build(const FinderInput& input) {
  input_ = input;
  bounds_ = bounds_of_nodes(input);
  entries_.clear();
  boxes_ = {};
  if (bounds_.empty()) return;
  const Point widths = cell_widths(input);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    boxes_[axis] =
        AxisCells::of_width(bounds_.lo[axis], bounds_.hi[axis], widths[axis], AxisCells::most_cells);
  }
  const Index participants = static_cast<Index>(input.scene.participants());
  for (Index place = 0; place < participants; ++place) {
    const Index node = input.scene.participant(place);
    if (!in_limit(input, node)) continue;
    const double* xyz = input.scene.positions[node];
    entries_.push_back({code_of(boxes_[0].of(xyz[0]), boxes_[1].of(xyz[1]), boxes_[2].of(xyz[2])), node});
  }
  std::sort(entries_.begin(), entries_.end());
}

void PositionCode::visit_row(std::uint64_t first, std::uint64_t last, Index segment, const Box& box,
                             FoundRows& rows) const {
  const auto below = [](const Entry& entry, std::uint64_t code) { return entry.code < code; };
  auto entry = std::lower_bound(entries_.begin(), entries_.end(), first, below);
  for (; entry != entries_.end() && entry->code <= last; ++entry) {
    ++rows.raw_visits;
    if (input_.test(segment, box, entry->node)) rows.nodes->push_back(entry->node);
  }
}

void PositionCode::visit_boxes(const Box& cull, Index segment, const Box& box, FoundRows& rows) const {
  std::array<Index, 3> first;
  std::array<Index, 3> last;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first[axis] = boxes_[axis].of(cull.lo[axis]);
    last[axis] = boxes_[axis].of(cull.hi[axis]);
  }
  const Offset rows_of_boxes = (Offset{last[1]} - first[1] + 1) * (Offset{last[2]} - first[2] + 1);
  if (rows_of_boxes > static_cast<Offset>(entries_.size())) {
    ++rows.cell_visits;
    visit_row(0, std::numeric_limits<std::uint64_t>::max(), segment, box, rows);
    return;
  }
  rows.cell_visits += rows_of_boxes * (last[0] - first[0] + 1);
  for (Index iz = first[2]; iz <= last[2]; ++iz) {
    for (Index iy = first[1]; iy <= last[1]; ++iy) {
      visit_row(code_of(first[0], iy, iz), code_of(last[0], iy, iz), segment, box, rows);
    }
  }
}

void PositionCode::query(Index begin, Index end, FoundRows& rows) const {
  for (Index segment = begin; segment < end; ++segment) {
    const std::size_t row = rows.nodes->size();
    const Box cull = input_.test.culling_box(segment);
    if (input_.test.active(segment) && cull.intersects(bounds_)) {
      visit_boxes(cull, segment, territory(input_.scene, segment), rows);
      std::sort(rows.nodes->begin() + static_cast<std::ptrdiff_t>(row), rows.nodes->end());
    }
    rows.ends[segment - begin] = static_cast<Offset>(rows.nodes->size());
  }
}

}  // namespace cellsearch
