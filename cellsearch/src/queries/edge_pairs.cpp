// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/edge_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "checks.hpp"
#include "parallel.hpp"
#include "queries/box_pairs.hpp"

namespace cellsearch {
namespace {

constexpr Index none = std::numeric_limits<Index>::max();
constexpr int check_blocks = 64;

/// The first fault of each kind.
struct Faults {
  Index place = none;
  Index edge = none;
  Index node = none;
  Index expansion = none;
  Index group = none;
};

bool is_distance(double distance) {
  return distance >= 0.0 && std::isfinite(distance);
}

void check_layout(const EdgeScene& scene) {
  const auto fail = [](const char* message) { throw Error(ErrorKind::BadLayout, -1, message); };
  check_positions(scene.positions);
  const std::size_t count = scene.edges.count();
  if (scene.edges.nodes().size() % 2 != 0) fail("The edges are not a multiple of 2 node numbers.");
  if (count > static_cast<std::size_t>(none)) fail("There are more than 2147483647 edges.");
  if (!scene.edge_expansion.empty() && scene.edge_expansion.size() != count) {
    fail("The number of edge expansions is not the number of edges.");
  }
  const std::size_t groups = static_cast<std::size_t>(std::max(scene.group_count, 0));
  if (scene.group_count < 0) fail("The number of groups is negative.");
  if (scene.edge_group.size() != (groups > 0 ? count : 0)) {
    fail("The number of edge groups is not the number of edges, or there are no groups.");
  }
  if (scene.allow.size() != groups * groups) {
    fail("The matrix of groups that may touch is not the number of groups squared.");
  }
  if (scene.positions.count() == 0) throw Error(ErrorKind::EmptyInput, -1, "There is not a single node.");
  if (!is_distance(scene.expansion)) {
    throw Error(ErrorKind::BadExpansion, -1,
                "The expansion is " + std::to_string(scene.expansion) + ", but it must be finite and >= 0.");
  }
}

Faults scan(const EdgeScene& scene, BlockRange range) {
  Faults faults;
  const Index nodes = static_cast<Index>(scene.positions.count());
  const Index edges = static_cast<Index>(scene.edges.count());
  for (Index place = range.begin; place < range.end; ++place) {
    const Index edge = scene.participant(place);
    if (edge <= (place == 0 ? -1 : scene.participant(place - 1)) || edge >= edges) {
      faults.place = place;
      return faults;
    }
    const std::size_t at = static_cast<std::size_t>(edge);
    if ((!scene.edge_expansion.empty() && !is_distance(scene.edge_expansion[at])) ||
        !is_distance(scene.expansion_of(edge))) {
      faults.expansion = std::min(faults.expansion, edge);
    }
    if (scene.group_count > 0 && (scene.edge_group[at] < 0 || scene.edge_group[at] >= scene.group_count)) {
      faults.group = std::min(faults.group, edge);
    }
    const Index* own = scene.edges[edge];
    for (int end = 0; end < 2; ++end) {
      if (own[end] < 0 || own[end] >= nodes) {
        faults.edge = std::min(faults.edge, edge);
        continue;
      }
      const double* xyz = scene.positions[own[end]];
      if (!std::isfinite(xyz[0]) || !std::isfinite(xyz[1]) || !std::isfinite(xyz[2])) {
        faults.node = std::min(faults.node, own[end]);
      }
    }
  }
  return faults;
}

void throw_if_any(const EdgeScene& scene, const Faults& faults) {
  if (faults.place != none) {
    throw Error(ErrorKind::BadNodeList, faults.place,
                "The subset of edges must be strictly ascending and in range; entry " +
                    std::to_string(faults.place) + " is " + std::to_string(scene.participant(faults.place)) +
                    ".");
  }
  if (faults.edge != none) {
    throw Error(ErrorKind::BadConnectivity, faults.edge,
                "Edge " + std::to_string(faults.edge) + " joins the nodes " +
                    std::to_string(scene.edges[faults.edge][0]) + " and " +
                    std::to_string(scene.edges[faults.edge][1]) + ", but the nodes are numbered from 0 to " +
                    std::to_string(scene.positions.count() - 1) + ".");
  }
  if (faults.node != none) throw_bad_position(scene.positions, faults.node);
  if (faults.expansion != none) {
    throw Error(ErrorKind::BadExpansion, faults.expansion,
                "The expansion of edge " + std::to_string(faults.expansion) + " is negative or not finite.");
  }
  if (faults.group != none) {
    throw Error(ErrorKind::BadSegmentGroup, faults.group,
                "Edge " + std::to_string(faults.group) + " belongs to group " +
                    std::to_string(scene.edge_group[static_cast<std::size_t>(faults.group)]) +
                    ", but the groups are numbered from 0 to " + std::to_string(scene.group_count - 1) + ".");
  }
}

void check(const EdgeScene& scene, int threads) {
  check_layout(scene);
  const Index places = static_cast<Index>(scene.participants());
  std::array<Faults, check_blocks> blocks;
  for_blocks(threads, check_blocks, [&](int block) {
    blocks[static_cast<std::size_t>(block)] = scan(scene, BlockRange(places, block, check_blocks));
  });
  Faults total;
  for (const Faults& faults : blocks) {
    total.place = std::min(total.place, faults.place);
    total.edge = std::min(total.edge, faults.edge);
    total.node = std::min(total.node, faults.node);
    total.expansion = std::min(total.expansion, faults.expansion);
    total.group = std::min(total.group, faults.group);
  }
  throw_if_any(scene, total);
}

bool allowed_either_way(const EdgeScene& scene, Index one, Index other) {
  const std::size_t count = static_cast<std::size_t>(scene.group_count);
  const std::size_t a = static_cast<std::size_t>(scene.edge_group[static_cast<std::size_t>(one)]);
  const std::size_t b = static_cast<std::size_t>(scene.edge_group[static_cast<std::size_t>(other)]);
  return (scene.allow[a * count + b] | scene.allow[b * count + a]) != 0;
}

}  // namespace

EdgePairSearch::EdgePairSearch(const EdgePairSettings& settings)
    : settings_(settings), boxes_(std::make_unique<BoxPairs>()) {
  check_threads(settings.threads);
}

EdgePairSearch::~EdgePairSearch() = default;
EdgePairSearch::EdgePairSearch(EdgePairSearch&&) noexcept = default;
EdgePairSearch& EdgePairSearch::operator=(EdgePairSearch&&) noexcept = default;

const Pairs& EdgePairSearch::find(const EdgeScene& scene) {
  pairs_.first.clear();
  pairs_.second.clear();
  check(scene, settings_.threads);
  const std::span<Box> boxes = boxes_->prepare(static_cast<Index>(scene.edges.count()));
  if (scene.subset) std::fill(boxes.begin(), boxes.end(), Box{});
  const Index places = static_cast<Index>(scene.participants());
  const int blocks = 4 * settings_.threads;
  for_blocks(settings_.threads, blocks, [&](int block) {
    const BlockRange range(places, block, blocks);
    for (Index place = range.begin; place < range.end; ++place) {
      const Index edge = scene.participant(place);
      boxes[static_cast<std::size_t>(edge)] = scene.box_of(edge);
    }
  });
  const bool apart = settings_.exclude_shared_nodes;
  const auto accepts = [&](Index i, Index j) {
    if (apart && scene.edges.share_node(i, j)) return false;
    return scene.group_count == 0 || allowed_either_way(scene, i, j);
  };
  boxes_->find(accepts, settings_.threads, pairs_);
  return pairs_;
}

Offset EdgePairSearch::visits() const {
  return boxes_->visits();
}

Offset EdgePairSearch::bytes() const {
  return boxes_->bytes();
}

}  // namespace cellsearch
