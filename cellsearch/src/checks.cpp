// SPDX-License-Identifier: BSD-3-Clause
#include "checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "cellsearch/error.hpp"
#include "parallel.hpp"

namespace cellsearch {
namespace {

constexpr Index none = std::numeric_limits<Index>::max();
constexpr std::size_t most = static_cast<std::size_t>(none);

// The blocks do not depend on the number of threads, and neither does the sum over them.
constexpr int check_blocks = 64;

struct BlockSummary {
  Index bad_segment = none;
  Index bad_node = none;
  Index bad_place = none;
  Index bad_expansion = none;
  Index bad_radius = none;
  Index bad_node_group = none;
  Index bad_segment_group = none;
  Box nodes;
  double largest_radius = 0.0;
  double edge_sum = 0.0;
  Offset edges = 0;
};

bool is_finite(const double* xyz) {
  return std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]);
}

/// An expansion or a radius.
bool is_distance(double distance) {
  return distance >= 0.0 && std::isfinite(distance);
}

[[noreturn]] void fail_layout(const char* message) {
  throw Error(ErrorKind::BadLayout, -1, message);
}

void check_groups(const Scene& scene) {
  const Groups& groups = scene.groups;
  if (groups.count < 0) fail_layout("The number of groups is negative.");
  const bool given = groups.count > 0;
  const std::size_t count = static_cast<std::size_t>(groups.count);
  // Queries in which no node takes part need no groups of nodes either.
  const bool no_nodes = scene.participants() == 0 && groups.node_group.empty();
  if (!no_nodes && groups.node_group.size() != (given ? scene.positions.count() : 0)) {
    fail_layout("The number of node groups is not the number of nodes, or there are no groups.");
  }
  if (groups.segment_group.size() != (given ? scene.segments.count() : 0)) {
    fail_layout("The number of segment groups is not the number of segments, or there are no groups.");
  }
  if (groups.allow.size() != count * count) {
    fail_layout("The matrix of groups that may touch is not the number of groups squared.");
  }
}

/// Radius and group of one participant.
void scan_node_filters(const Scene& scene, Index node, BlockSummary& summary) {
  const std::size_t at = static_cast<std::size_t>(node);
  if (!scene.node_radius.empty()) {
    const double radius = scene.node_radius[at];
    if (!is_distance(radius)) summary.bad_radius = std::min(summary.bad_radius, node);
    summary.largest_radius = std::max(summary.largest_radius, radius);
  }
  const Groups& groups = scene.groups;
  if (groups.count > 0 && (groups.node_group[at] < 0 || groups.node_group[at] >= groups.count)) {
    summary.bad_node_group = std::min(summary.bad_node_group, node);
  }
}

/// Participants in places begin..end-1: order, range, coordinates, bounding box, radius and group.
void scan_nodes(const Scene& scene, BlockRange range, BlockSummary& summary) {
  const Index count = static_cast<Index>(scene.positions.count());
  const bool filtered = !scene.node_radius.empty() || scene.groups.count > 0;
  for (Index place = range.begin; place < range.end; ++place) {
    const Index node = scene.participant(place);
    const Index before = place == 0 ? -1 : scene.participant(place - 1);
    if (node <= before || node >= count) {
      summary.bad_place = place;
      return;
    }
    if (filtered) scan_node_filters(scene, node, summary);
    const double* xyz = scene.positions[node];
    if (is_finite(xyz)) {
      summary.nodes.include(xyz);
    } else {
      summary.bad_node = std::min(summary.bad_node, node);
    }
  }
}

double edge_length(const double* from, const double* to) {
  const double x = to[0] - from[0];
  const double y = to[1] - from[1];
  const double z = to[2] - from[2];
  return std::sqrt(x * x + y * y + z * z);
}

/// Segments begin..end-1: connectivity, expansion, group, coordinates of their nodes, lengths of their edges.
void scan_segments(const Scene& scene, BlockRange range, BlockSummary& summary) {
  const Index count = static_cast<Index>(scene.positions.count());
  for (Index segment = range.begin; segment < range.end; ++segment) {
    if (!is_distance(scene.expansion_of(segment)) ||
        (!scene.segment_expansion.empty() &&
         !is_distance(scene.segment_expansion[static_cast<std::size_t>(segment)]))) {
      summary.bad_expansion = std::min(summary.bad_expansion, segment);
    }
    const Groups& groups = scene.groups;
    if (groups.count > 0) {
      const Index group = groups.segment_group[static_cast<std::size_t>(segment)];
      if (group < 0 || group >= groups.count) {
        summary.bad_segment_group = std::min(summary.bad_segment_group, segment);
      }
    }
    const Index* own = scene.segments[segment];
    const auto exists = [&](Index node) { return node >= 0 && node < count; };
    if (!(exists(own[0]) && exists(own[1]) && exists(own[2]) && exists(own[3]))) {
      summary.bad_segment = std::min(summary.bad_segment, segment);
      continue;
    }
    for (int corner = 0; corner < 4; ++corner) {
      const Index from = own[corner];
      const Index to = own[(corner + 1) % 4];
      if (!is_finite(scene.positions[from])) summary.bad_node = std::min(summary.bad_node, from);
      if (from == to) continue;  // a triangle has three edges
      summary.edge_sum += edge_length(scene.positions[from], scene.positions[to]);
      ++summary.edges;
    }
  }
}

void throw_bad_segment(const Scene& scene, Index segment) {
  const Index count = static_cast<Index>(scene.positions.count());
  const Index* own = scene.segments[segment];
  const Index* bad = std::find_if(own, own + 4, [&](Index node) { return node < 0 || node >= count; });
  throw Error(ErrorKind::BadConnectivity, segment,
              "Segment " + std::to_string(segment) + " names node " + std::to_string(*bad) +
                  ", but the nodes are numbered from 0 to " + std::to_string(count - 1) + ".");
}

void throw_if_bad(const Scene& scene, const BlockSummary& total) {
  if (total.bad_place != none) {
    throw Error(ErrorKind::BadNodeList, total.bad_place,
                "The list of nodes must be strictly ascending and in range; entry " +
                    std::to_string(total.bad_place) + " is " +
                    std::to_string(scene.participant(total.bad_place)) + ".");
  }
  if (total.bad_segment != none) throw_bad_segment(scene, total.bad_segment);
  if (total.bad_node != none) throw_bad_position(scene.positions, total.bad_node);
  if (total.bad_expansion != none) {
    throw Error(
        ErrorKind::BadExpansion, total.bad_expansion,
        "The expansion of segment " + std::to_string(total.bad_expansion) + " is negative or not finite.");
  }
  if (total.bad_radius != none) {
    throw Error(ErrorKind::BadRadius, total.bad_radius,
                "The radius of node " + std::to_string(total.bad_radius) + " is negative or not finite.");
  }
  const auto throw_bad_group = [&](ErrorKind kind, const char* what, Index index, std::span<const Index> of) {
    throw Error(kind, index,
                what + std::to_string(index) + " belongs to group " +
                    std::to_string(of[static_cast<std::size_t>(index)]) +
                    ", but the groups are numbered from 0 to " + std::to_string(scene.groups.count - 1) +
                    ".");
  };
  if (total.bad_node_group != none) {
    throw_bad_group(ErrorKind::BadNodeGroup, "Node ", total.bad_node_group, scene.groups.node_group);
  }
  if (total.bad_segment_group != none) {
    throw_bad_group(ErrorKind::BadSegmentGroup, "Segment ", total.bad_segment_group,
                    scene.groups.segment_group);
  }
}

}  // namespace

void check_settings(const Settings& settings) {
  const auto fail = [](const char* message) { throw Error(ErrorKind::BadSetting, -1, message); };
  check_threads(settings.threads);
  if (!(settings.cell_factor > 0.0) || !std::isfinite(settings.cell_factor)) {
    fail("The cell factor must be positive and finite.");
  }
  if (!(settings.cells_per_node > 0.0) || !std::isfinite(settings.cells_per_node)) {
    fail("The number of cells per node must be positive and finite.");
  }
  if (settings.cell_edge && !(*settings.cell_edge > 0.0 && std::isfinite(*settings.cell_edge))) {
    fail("The edge of the cells must be positive and finite.");
  }
}

void check_positions(const Positions& positions) {
  const std::size_t values = positions.values().size();
  const std::size_t stride = positions.stride();
  if (stride < 3) fail_layout("The stride of the positions is below 3.");
  if (values % stride == 1 || values % stride == 2) {
    fail_layout("The last position has fewer than 3 coordinates.");
  }
  if (positions.count() > most) fail_layout("There are more than 2147483647 nodes.");
}

void check_threads(int threads) {
  if (threads < 1) {
    throw Error(ErrorKind::BadSetting, -1, "The number of threads must be at least 1.");
  }
}

void throw_bad_position(const Positions& positions, Index node) {
  const double* xyz = positions[node];
  throw Error(ErrorKind::NonFiniteCoordinate, node,
              "Node " + std::to_string(node) +
                  " has a coordinate that is not finite: x = " + std::to_string(xyz[0]) +
                  ", y = " + std::to_string(xyz[1]) + ", z = " + std::to_string(xyz[2]) + ".");
}

void check_layout(const Scene& scene) {
  check_positions(scene.positions);
  const std::size_t nodes = scene.positions.count();
  const std::size_t segments = scene.segments.count();
  if (scene.segments.nodes().size() % 4 != 0) {
    fail_layout("The connectivity is not a multiple of 4 node numbers.");
  }
  if (segments > most) fail_layout("There are more than 2147483647 segments.");
  if (!scene.segment_expansion.empty() && scene.segment_expansion.size() != segments) {
    fail_layout("The number of segment expansions is not the number of segments.");
  }
  if (!scene.node_radius.empty() && scene.node_radius.size() != nodes) {
    fail_layout("The number of node radii is not the number of nodes.");
  }
  if (!scene.segment_active.empty() && scene.segment_active.size() != segments) {
    fail_layout("The number of active flags is not the number of segments.");
  }
  check_groups(scene);
  if (nodes == 0) throw Error(ErrorKind::EmptyInput, -1, "There is not a single node.");
  if (!is_distance(scene.expansion)) {
    throw Error(ErrorKind::BadExpansion, -1,
                "The expansion is " + std::to_string(scene.expansion) + ", but it must be finite and >= 0.");
  }
}

SceneSummary check_scene(const Scene& scene, int threads) {
  check_layout(scene);
  std::array<BlockSummary, check_blocks> blocks;
  const Index places = static_cast<Index>(scene.participants());
  const Index segments = static_cast<Index>(scene.segments.count());
  for_blocks(threads, check_blocks, [&](int block) {
    BlockSummary summary;
    scan_nodes(scene, BlockRange(places, block, check_blocks), summary);
    scan_segments(scene, BlockRange(segments, block, check_blocks), summary);
    blocks[static_cast<std::size_t>(block)] = summary;
  });
  BlockSummary total;
  for (const BlockSummary& block : blocks) {
    total.bad_segment = std::min(total.bad_segment, block.bad_segment);
    total.bad_node = std::min(total.bad_node, block.bad_node);
    total.bad_place = std::min(total.bad_place, block.bad_place);
    total.bad_expansion = std::min(total.bad_expansion, block.bad_expansion);
    total.bad_radius = std::min(total.bad_radius, block.bad_radius);
    total.bad_node_group = std::min(total.bad_node_group, block.bad_node_group);
    total.bad_segment_group = std::min(total.bad_segment_group, block.bad_segment_group);
    total.largest_radius = std::max(total.largest_radius, block.largest_radius);
    total.nodes.include(block.nodes);
    total.edge_sum += block.edge_sum;
    total.edges += block.edges;
  }
  throw_if_bad(scene, total);
  const double mean_edge = total.edges == 0 ? 0.0 : total.edge_sum / static_cast<double>(total.edges);
  return {total.nodes, mean_edge, total.largest_radius};
}

}  // namespace cellsearch
