// SPDX-License-Identifier: BSD-3-Clause
#include "production/production.hpp"

#include <algorithm>

#include "cellsearch/territory.hpp"
#include "parallel.hpp"
#include "production/cell_edges.hpp"

namespace cellsearch {

using production::CellEdges;
using production::NodeGridInput;
using production::QueryInput;

void Production::build(const FinderInput& input) {
  input_ = input;
  NodeGridInput nodes;
  nodes.positions = input.scene.positions;
  nodes.nodes = input.scene.nodes;
  nodes.limit = input.limit;
  nodes.box = input.nodes;
  // Without a node the box is empty; any other serves as well then.
  if (nodes.box.empty()) nodes.box = Box{{0, 0, 0}, {0, 0, 0}};
  nodes.set = set_;
  nodes.threads = input.threads;
  const Index count = static_cast<Index>(input.scene.participants());
  if (input.asked_cell_edge > 0.0) {
    nodes.edges = {0, input.asked_cell_edge, input.asked_cell_edge};
    while (production::cells_for(nodes.box, nodes.edges) > 64.0 * count + 1024.0) {
      nodes.edges.run *= 1.2;
      nodes.edges.cross *= 1.2;
    }
  } else {
    nodes.edges = production::choose_edges(input, nodes.box, count);
  }
  grid_.build(nodes);
  sizes_.clear();
  if (grid_.crowded()) {
    measure_sizes(input);
    grid_.divide(nodes, sizes_);
  }
}

/// The size of one territory around each node: enough to choose cells by.
void Production::measure_sizes(const FinderInput& input) {
  sizes_.assign(input.scene.positions.count(), 0.0F);
  const Index segments = static_cast<Index>(input.scene.segments.count());
  for (Index segment = 0; segment < segments; ++segment) {
    const Box box = input.test.culling_box(segment);
    double size = 0.0;
    for (int axis = 0; axis < 3; ++axis) size = std::max(size, box.hi[axis] - box.lo[axis]);
    sizes_[static_cast<std::size_t>(input.scene.segments[segment][0])] = static_cast<float>(size);
  }
}

void Production::query(Index begin, Index end, FoundRows& rows) const {
  const Scene& scene = input_.scene;
  QueryInput query;
  query.table = grid_.table();
  query.positions = scene.positions;
  query.grids = grid_.grids().data();
  query.child = grid_.child();
  query.connectivity = scene.segments.nodes().data();
  query.segment_expansion = scene.segment_expansion.empty() ? nullptr : scene.segment_expansion.data();
  query.active = scene.segment_active.empty() ? nullptr : scene.segment_active.data();
  query.expansion = scene.expansion + input_.test.largest_radius();
  query.plain = input_.test.plain();
  query.help = this;
  production::kernels(set_).query(query, begin, end, rows);
}

void Production::collect(Index segment, FoundRows& rows) const {
  rows.spare->clear();
  const Box box = territory(input_.scene, segment);
  const auto test = [&](std::uint32_t first, std::uint32_t last) {
    rows.raw_visits += last - first;
    for (std::uint32_t place = first; place < last; ++place) {
      const Index node = grid_.node(place);
      if (input_.test(segment, box, node)) rows.spare->push_back(node);
    }
  };
  grid_.visit(input_.test.culling_box(segment), rows.cell_visits, test);
  std::sort(rows.spare->begin(), rows.spare->end());
}

bool Production::accepts(Index segment, Index node) const {
  return input_.test(segment, territory(input_.scene, segment), node);
}

}  // namespace cellsearch
