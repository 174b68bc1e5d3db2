// SPDX-License-Identifier: BSD-3-Clause
#include "reference/bucket_sort.hpp"

#include <algorithm>
#include <cstddef>

#include "cellsearch/territory.hpp"

namespace cellsearch {
namespace {

std::size_t place(Index number) {
  return static_cast<std::size_t>(number);
}

}  // namespace

/// Divides the interval that the nodes order_[begin] ... order_[end - 1] take up along `axis`, and sorts them
/// by part; inside a part their order stays. `starts` gets where each part begins in order_, but not where
/// the last one ends. Sorting by counting: linear in the nodes, as there are no more parts than nodes.
AxisCells BucketSort::divide(int axis, Index begin, Index end, std::vector<Index>& starts) {
  const Positions& positions = input_.scene.positions;
  double lo = positions[order_[place(begin)]][axis];
  double hi = lo;
  for (Index at = begin + 1; at < end; ++at) {
    const double coordinate = positions[order_[place(at)]][axis];
    lo = std::min(lo, coordinate);
    hi = std::max(hi, coordinate);
  }
  const Index most = std::min(end - begin, AxisCells::most_cells);
  const AxisCells cells = AxisCells::of_width(lo, hi, widths_[axis], most);
  const std::size_t first = starts.size();
  starts.resize(first + place(cells.count), 0);
  if (cells.count == 1) {
    starts[first] = begin;
    return cells;
  }
  Index* const start = starts.data() + first;
  for (Index at = begin; at < end; ++at) {
    const Index node = order_[place(at)];
    unsorted_[place(at)] = node;
    part_[place(at)] = cells.of(positions[node][axis]);
    ++start[part_[place(at)]];
  }
  Index next = begin;
  for (Index part = 0; part < cells.count; ++part) {
    const Index nodes = start[part];
    start[part] = next;
    next += nodes;
  }
  for (Index at = begin; at < end; ++at) order_[place(start[part_[place(at)]]++)] = unsorted_[place(at)];
  // Each start has moved to the next one's place; move them back.
  for (Index part = cells.count - 1; part > 0; --part) start[part] = start[part - 1];
  start[0] = begin;
  return cells;
}

/// Divides one slab along y, and its strips along z. An empty slab has no strip, an empty strip no bucket.
void BucketSort::divide_slab(Index begin, Index end) {
  const Index first_strip = static_cast<Index>(buckets_of_strip_.size());
  if (begin == end) {
    strips_of_slab_.push_back({{.count = 0}, first_strip});
    return;
  }
  strip_start_.clear();
  const AxisCells strips = divide(1, begin, end, strip_start_);
  strip_start_.push_back(end);
  strips_of_slab_.push_back({strips, first_strip});
  for (Index strip = 0; strip < strips.count; ++strip) {
    const Index from = strip_start_[place(strip)];
    const Index to = strip_start_[place(strip) + 1];
    const Index first_bucket = static_cast<Index>(bucket_start_.size());
    AxisCells buckets{.count = 0};
    if (from < to) buckets = divide(2, from, to, bucket_start_);
    buckets_of_strip_.push_back({buckets, first_bucket});
  }
}

void BucketSort::build(const FinderInput& input) {
  input_ = input;
  widths_ = cell_widths(input);
  strips_of_slab_.clear();
  buckets_of_strip_.clear();
  bucket_start_.clear();
  slab_start_.clear();
  order_.clear();
  const Index participants = static_cast<Index>(input.scene.participants());
  for (Index number = 0; number < participants; ++number) {
    const Index node = input.scene.participant(number);
    if (in_limit(input, node)) order_.push_back(node);
  }
  const Index nodes = static_cast<Index>(order_.size());
  slabs_ = AxisCells{.count = 0};
  if (nodes > 0) {
    unsorted_.resize(order_.size());
    part_.resize(order_.size());
    slabs_ = divide(0, 0, nodes, slab_start_);
    slab_start_.push_back(nodes);
    for (Index slab = 0; slab < slabs_.count; ++slab) {
      divide_slab(slab_start_[place(slab)], slab_start_[place(slab) + 1]);
    }
  }
  bucket_start_.push_back(nodes);
}

std::span<const Index> BucketSort::nodes_in(Index first_bucket, Index last_bucket) const {
  const Index begin = bucket_start_[place(first_bucket)];
  const Index end = bucket_start_[place(last_bucket) + 1];
  return {order_.data() + begin, place(end - begin)};
}

void BucketSort::visit_slab(const Division& strips, const Box& cull, Index segment, const Box& box,
                            FoundRows& rows) const {
  if (strips.cells.count == 0 || !strips.cells.meets(cull.lo[1], cull.hi[1])) return;
  const Index last_strip = strips.first + strips.cells.of(cull.hi[1]);
  for (Index strip = strips.first + strips.cells.of(cull.lo[1]); strip <= last_strip; ++strip) {
    const Division& buckets = buckets_of(strip);
    if (buckets.cells.count == 0 || !buckets.cells.meets(cull.lo[2], cull.hi[2])) continue;
    const Index first = buckets.first + buckets.cells.of(cull.lo[2]);
    const Index last = buckets.first + buckets.cells.of(cull.hi[2]);
    rows.cell_visits += last - first + 1;
    // Buckets of one strip lie one after another, and so do their nodes.
    const std::span<const Index> nodes = nodes_in(first, last);
    rows.raw_visits += static_cast<Offset>(nodes.size());
    for (const Index node : nodes) {
      if (input_.test(segment, box, node)) rows.nodes->push_back(node);
    }
  }
}

void BucketSort::query(Index begin, Index end, FoundRows& rows) const {
  for (Index segment = begin; segment < end; ++segment) {
    const std::size_t row = rows.nodes->size();
    const Box cull = input_.test.culling_box(segment);
    if (input_.test.active(segment) && slabs_.count > 0 && slabs_.meets(cull.lo[0], cull.hi[0])) {
      const Box box = territory(input_.scene, segment);
      const Index last_slab = slabs_.of(cull.hi[0]);
      for (Index slab = slabs_.of(cull.lo[0]); slab <= last_slab; ++slab) {
        visit_slab(strips_of(slab), cull, segment, box, rows);
      }
      std::sort(rows.nodes->begin() + static_cast<std::ptrdiff_t>(row), rows.nodes->end());
    }
    rows.ends[segment - begin] = static_cast<Offset>(rows.nodes->size());
  }
}

Offset BucketSort::bytes() const {
  const std::size_t divisions = strips_of_slab_.size() + buckets_of_strip_.size();
  const std::size_t numbers = bucket_start_.size() + order_.size() + slab_start_.size() +
                              strip_start_.size() + unsorted_.size() + part_.size();
  return static_cast<Offset>(divisions * sizeof(Division) + numbers * sizeof(Index));
}

}  // namespace cellsearch
