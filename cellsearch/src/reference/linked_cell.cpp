// SPDX-License-Identifier: BSD-3-Clause
#include "reference/linked_cell.hpp"

#include <algorithm>
#include <cstddef>

#include "cellsearch/territory.hpp"
#include "parallel.hpp"

namespace cellsearch {

void LinkedCell::build(const FinderInput& input) {
  input_ = input;
  const Scene& scene = input.scene;
  const CellGrid& grid = input.grid;
  const Index nodes = static_cast<Index>(scene.participants());
  const std::span<Index> cell_of_place = list_.prepare(grid.count(), nodes);
  const int blocks = 4 * input.threads;
  for_blocks(input.threads, blocks, [&](int block) {
    const BlockRange range(nodes, block, blocks);
    for (Index place = range.begin; place < range.end; ++place) {
      const double* xyz = scene.positions[scene.participant(place)];
      const bool inside = !input.limit || input.limit->contains(xyz);
      cell_of_place[static_cast<std::size_t>(place)] = inside ? grid.cell_of(xyz) : -1;
    }
  });
  list_.link();
}

void LinkedCell::visit_cell(Index cell, Index segment, const Box& box, FoundRows& rows) const {
  ++rows.cell_visits;
  for (Index place = list_.head(cell); place >= 0; place = list_.next(place)) {
    const Index node = input_.scene.participant(place);
    ++rows.raw_visits;
    if (input_.test(segment, box, node)) rows.nodes->push_back(node);
  }
}

void LinkedCell::query(Index begin, Index end, FoundRows& rows) const {
  const CellGrid& grid = input_.grid;
  for (Index segment = begin; segment < end; ++segment) {
    const std::size_t row = rows.nodes->size();
    const Box cull = input_.test.culling_box(segment);
    // Clamping would move a territory beside the domain into its outer cells: right, but wasted work.
    if (input_.test.active(segment) && cull.intersects(grid.domain().box)) {
      const Box box = territory(input_.scene, segment);
      const CellRange range = grid.cells_of(cull);
      for (Index iz = range.first[2]; iz <= range.last[2]; ++iz) {
        for (Index iy = range.first[1]; iy <= range.last[1]; ++iy) {
          for (Index ix = range.first[0]; ix <= range.last[0]; ++ix) {
            visit_cell(grid.cell_number(ix, iy, iz), segment, box, rows);
          }
        }
      }
      std::sort(rows.nodes->begin() + static_cast<std::ptrdiff_t>(row), rows.nodes->end());
    }
    rows.ends[segment - begin] = static_cast<Offset>(rows.nodes->size());
  }
}

}  // namespace cellsearch
