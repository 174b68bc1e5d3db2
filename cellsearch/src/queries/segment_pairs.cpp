// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/segment_pairs.hpp"

#include <algorithm>
#include <span>

#include "cellsearch/territory.hpp"
#include "checks.hpp"
#include "parallel.hpp"
#include "queries/box_pairs.hpp"

namespace cellsearch {
namespace {

bool share_node(const Segments& segments, Index one, Index other) {
  const Index* own = segments[other];
  return segments.owns(one, own[0]) || segments.owns(one, own[1]) || segments.owns(one, own[2]) ||
         segments.owns(one, own[3]);
}

bool allowed_either_way(const Groups& groups, Index one, Index other) {
  const Index a = groups.segment_group[static_cast<std::size_t>(one)];
  const Index b = groups.segment_group[static_cast<std::size_t>(other)];
  return groups.allowed(a, b) || groups.allowed(b, a);
}

}  // namespace

SegmentPairSearch::SegmentPairSearch(const SegmentPairSettings& settings)
    : settings_(settings), boxes_(std::make_unique<BoxPairs>()) {
  check_threads(settings.threads);
}

SegmentPairSearch::~SegmentPairSearch() = default;
SegmentPairSearch::SegmentPairSearch(SegmentPairSearch&&) noexcept = default;
SegmentPairSearch& SegmentPairSearch::operator=(SegmentPairSearch&&) noexcept = default;

const Pairs& SegmentPairSearch::find(const Scene& scene) {
  pairs_.first.clear();
  pairs_.second.clear();
  Scene surface = scene;
  surface.nodes = std::span<const Index>{};  // no node takes part, and no filter of nodes
  surface.node_radius = {};
  surface.groups.node_group = {};
  surface.exclude_neighbours = false;
  check_scene(surface, settings_.threads);

  const Index count = static_cast<Index>(surface.segments.count());
  const std::span<Box> boxes = boxes_->prepare(count);
  const int blocks = 4 * settings_.threads;
  for_blocks(settings_.threads, blocks, [&](int block) {
    const BlockRange range(count, block, blocks);
    for (Index segment = range.begin; segment < range.end; ++segment) {
      boxes[static_cast<std::size_t>(segment)] =
          surface.active(segment) ? territory(surface, segment) : Box{};
    }
  });
  const bool apart = settings_.exclude_shared_nodes;
  const auto accepts = [&](Index i, Index j) {
    if (apart && share_node(surface.segments, i, j)) return false;
    return surface.groups.count == 0 || allowed_either_way(surface.groups, i, j);
  };
  boxes_->find(accepts, settings_.threads, pairs_);
  return pairs_;
}

Offset SegmentPairSearch::visits() const {
  return boxes_->visits();
}

Offset SegmentPairSearch::bytes() const {
  return boxes_->bytes();
}

}  // namespace cellsearch
