// SPDX-License-Identifier: BSD-3-Clause
#include "production/production.hpp"

#include <algorithm>
#include <array>

#include "cellsearch/territory.hpp"
#include "checks.hpp"
#include "parallel.hpp"
#include "production/cell_edges.hpp"

namespace cellsearch {

using production::CellEdges;
using production::NodeGridInput;
using production::QueryInput;

namespace {

/// After so many builds the cells are chosen anew, in case the territories have changed.
constexpr int builds_with_same_cells = 15;

/// Cells per node that a user may ask for.
constexpr double most_asked_cells = 64.0;

}  // namespace

void Production::build(const FinderInput& input) {
  input_ = input;
  NodeGridInput nodes;
  nodes.positions = input.scene.positions;
  // A list of all nodes, strictly ascending, is no restriction.
  if (input.scene.participants() != input.scene.positions.count()) nodes.nodes = input.scene.nodes;
  nodes.limit = input.limit;
  nodes.set = set_;
  nodes.threads = input.threads;
  nodes.edges = edges_;
  const bool keep_edges = may_keep_edges();
  if (!keep_edges || !sort_again(nodes)) sort_anew(nodes, keep_edges);
  edges_ = nodes.edges;
  out_of_lattice_ = reaches_out();
  sizes_.clear();
  if (grid_.crowded()) {
    const double edge = std::max(edges_.run, edges_.cross);
    if (edges_.smallest_territory < production::much_smaller * edge) measure_sizes(input);
    grid_.divide(nodes, sizes_);
  }
}

/// True if this build is of the same kind as the last one, whose cells were chosen not too many builds ago.
bool Production::may_keep_edges() {
  const Scene& scene = input_.scene;
  const Layout layout{scene.positions.count(), scene.participants(), scene.segments.count(), scene.expansion};
  const bool usable = layout == layout_ && builds_left_ > 0;
  layout_ = layout;
  if (usable) --builds_left_;
  return usable;
}

/// Sorts into the cells of the last build. False if the nodes have moved too far for it.
bool Production::sort_again(const NodeGridInput& nodes) {
  const production::NodeRange range = grid_.build_again(nodes);
  if (!range.finite) return false;
  all_nodes_ = range.box;
  const Box box = nodes.nodes ? box_of(*nodes.nodes) : range.box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double extent = box_.hi[axis] - box_.lo[axis];
    const double now = box.hi[axis] - box.lo[axis];
    const double moved = std::max(box_.lo[axis] - box.lo[axis], box.hi[axis] - box_.hi[axis]);
    if (!(moved <= 0.05 * extent && now >= 0.8 * extent)) return false;
  }
  return true;
}

/// Lays cells over where the nodes are now; they may have the edges of those before.
void Production::sort_anew(NodeGridInput& nodes, bool keep_edges) {
  const Scene& scene = input_.scene;
  box_ = measure(nodes);
  // Without a node the box is empty; any other serves as well then.
  if (box_.empty()) box_ = Box{{0, 0, 0}, {0, 0, 0}};
  nodes.box = box_;
  const Index count = static_cast<Index>(scene.participants());
  if (keep_edges && production::cells_for(box_, edges_) <= production::affordable_cells(count)) {
    all_nodes_ = grid_.build(nodes).box;
    return;
  }
  builds_left_ = builds_with_same_cells;
  if (input_.asked_cell_edge > 0.0) {
    nodes.edges = {0, input_.asked_cell_edge, input_.asked_cell_edge};
    while (production::cells_for(nodes.box, nodes.edges) > most_asked_cells * count + 1024.0) {
      nodes.edges.run *= 1.2;
      nodes.edges.cross *= 1.2;
    }
    all_nodes_ = grid_.build(nodes).box;
    return;
  }
  const production::TerritorySample sample = production::sample_territories(input_);
  nodes.edges = production::choose_edges(sample, nodes.box, count, layers_);
  all_nodes_ = grid_.build(nodes).box;
  // How crowded the territories are shows only when the nodes are sorted.
  layers_ = production::measure_layers(input_, sample, grid_, nodes.edges);
  const CellEdges better = production::choose_edges(sample, nodes.box, count, layers_);
  const auto differ = [](double a, double b) { return std::max(a, b) > 1.1 * std::min(a, b); };
  if (!differ(better.cross, nodes.edges.cross) && !differ(better.run, nodes.edges.run)) return;
  nodes.edges = better;
  grid_.build(nodes);
}

/// Bounding box of those that take part. Throws if a coordinate that matters is not finite.
Box Production::measure(const NodeGridInput& nodes) {
  const Index count = static_cast<Index>(nodes.positions.count());
  constexpr int blocks = 64;
  std::array<production::NodeRange, blocks> ranges;
  const production::Kernels& kernel = production::kernels(set_);
  for_blocks(nodes.threads, blocks, [&](int block) {
    const BlockRange range(count, block, blocks);
    ranges[static_cast<std::size_t>(block)] = kernel.measure(nodes.positions, range.begin, range.end);
  });
  Box box;
  bool finite = true;
  for (const production::NodeRange& range : ranges) {
    finite = finite && range.finite;
    box.include(range.box);
  }
  if (!finite) return check_scene(input_.scene, nodes.threads).nodes;
  return nodes.nodes ? box_of(*nodes.nodes) : box;
}

Box Production::box_of(std::span<const Index> nodes) const {
  Box box;
  for (const Index node : nodes) box.include(input_.scene.positions[node]);
  return box;
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

/// True if nodes or expansions are so far or large that their lattice numbers are cut. Only the exact test
/// can tell then. Nodes without a part in the search may be anywhere.
bool Production::reaches_out() const {
  const Scene& scene = input_.scene;
  double expansion = scene.expansion + input_.test.largest_radius();
  double largest = 0.0;
  for (const double more : scene.segment_expansion) largest = std::max(largest, more);
  expansion += largest;
  const production::Grid& grid = grid_.grids().front();
  constexpr double limit = 0.5 * production::lattice_limit;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto place = [&](double coordinate) { return coordinate * grid.scale[axis] + grid.offset[axis]; };
    if (!(place(all_nodes_.lo[axis]) > -limit && place(all_nodes_.hi[axis]) < 1.5 * limit)) return true;
    if (!(expansion * grid.scale[axis] < limit)) return true;
  }
  return false;
}

void Production::query_one_by_one(Index begin, Index end, FoundRows& rows) const {
  for (Index segment = begin; segment < end; ++segment) {
    if (input_.test.active(segment)) {
      collect(segment, rows);
      rows.nodes->insert(rows.nodes->end(), rows.spare->begin(), rows.spare->end());
    }
    rows.ends[segment - begin] = static_cast<Offset>(rows.nodes->size());
  }
}

void Production::query(Index begin, Index end, FoundRows& rows) const {
  if (begin == end) return;
  if (out_of_lattice_) return query_one_by_one(begin, end, rows);
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
  production::sort_row(rows.spare->data(), rows.spare->data() + rows.spare->size());
}

bool Production::accepts(Index segment, Index node) const {
  return input_.test(segment, territory(input_.scene, segment), node);
}

}  // namespace cellsearch
