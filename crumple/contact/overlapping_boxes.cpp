// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlapping_boxes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/parallel.hpp"

namespace crumple::contact {
namespace {

using math::Vec3;
using BoxPair = std::array<Index, 2>;

/// Edge of a cell over the mean extent of boxes: each reaches a few cells, each cell has a few boxes.
constexpr double edge_over_extent = 2;
/// Boxes longer than so many cells would fill too many of them.
constexpr double large_over_edge = 8;
constexpr std::size_t most_large_boxes = 16;
constexpr Index buckets_per_chunk = 512;
/// Cells are numbered within these bounds from the middle of all boxes; beyond, they share the outermost.
constexpr double outermost_cell = 1 << 20;

double extent_of(const Box& box) {
  return std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
}

struct Cell {
  std::int32_t x, y, z;
  bool operator==(const Cell& other) const { return x == other.x && y == other.y && z == other.z; }
};

/// A box in single precision, rounded outwards: what separates most pairs is stored contiguously.
struct RoundedBox {
  explicit RoundedBox(const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = rounded(box.low[axis], -HUGE_VALF);
      high[axis] = rounded(box.high[axis], HUGE_VALF);
    }
  }

  static float rounded(double x, float towards) { return std::nextafter(static_cast<float>(x), towards); }

  /// Without branches, which the next pair would mispredict.
  bool overlaps(const RoundedBox& other) const {
    int apart = 0;
    for (int axis = 0; axis < 3; ++axis)
      apart |=
          static_cast<int>(low[axis] > other.high[axis]) | static_cast<int>(other.low[axis] > high[axis]);
    return apart == 0;
  }

  std::array<float, 3> low{};
  std::array<float, 3> high{};
};

struct CellEntry {
  RoundedBox rounded{Box{}};
  Cell cell{};
  Index box = 0;
};

class BoxGrid {
 public:
  explicit BoxGrid(std::span<const Box> boxes) : boxes_(boxes) {
    choose_edge();
    fill();
  }

  Index chunks() const { return pieces(static_cast<Index>(first_.size()) - 1, buckets_per_chunk); }

  /// Of the boxes that are not large.
  void append_pairs(Index chunk, std::vector<BoxPair>& pairs) const {
    const auto buckets = static_cast<Index>(first_.size()) - 1;
    const Index end = std::min((chunk + 1) * buckets_per_chunk, buckets);
    for (Index bucket = chunk * buckets_per_chunk; bucket < end; ++bucket) append_bucket(bucket, pairs);
  }

  /// Of the large ones with all.
  void append_large(std::vector<BoxPair>& pairs) const {
    for (const Index large : large_)
      for (Index other = 0; other < static_cast<Index>(boxes_.size()); ++other) {
        if (other == large || (is_large_[other] != 0 && other < large)) continue;
        if (boxes_[large].overlaps(boxes_[other]))
          pairs.push_back({std::min(large, other), std::max(large, other)});
      }
  }

 private:
  void choose_edge() {
    double sum = 0;
    for (const Box& box : boxes_) sum += extent_of(box);
    double edge = edge_over_extent * sum / static_cast<double>(boxes_.size());
    if (!(edge > 0)) edge = 1;
    is_large_.resize(boxes_.size());
    for (;; edge *= 2) {
      large_.clear();
      for (std::size_t i = 0; i < boxes_.size(); ++i)
        if (extent_of(boxes_[i]) > large_over_edge * edge) large_.push_back(static_cast<Index>(i));
      if (large_.size() <= most_large_boxes) break;
    }
    for (const Index large : large_) is_large_[large] = 1;
    inverse_edge_ = 1 / edge;
  }

  Cell cell_of(const Vec3& point) const {
    const auto number = [&](double x) {
      return static_cast<std::int32_t>(
          std::floor(std::clamp(x * inverse_edge_, -outermost_cell, outermost_cell)));
    };
    return {number(point.x), number(point.y), number(point.z)};
  }

  std::size_t bucket_of(const Cell& cell) const {
    const auto x = static_cast<std::uint32_t>(cell.x) * 73856093U;
    const auto y = static_cast<std::uint32_t>(cell.y) * 19349663U;
    const auto z = static_cast<std::uint32_t>(cell.z) * 83492791U;
    return (x ^ y ^ z) & mask_;
  }

  template <class Visit>
  void for_each_entry(const Visit& visit) const {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (is_large_[i] != 0) continue;
      const Cell low = cell_of(boxes_[i].low);
      const Cell high = cell_of(boxes_[i].high);
      for (std::int32_t x = low.x; x <= high.x; ++x)
        for (std::int32_t y = low.y; y <= high.y; ++y)
          for (std::int32_t z = low.z; z <= high.z; ++z) visit(Cell{x, y, z}, static_cast<Index>(i));
    }
  }

  /// Sorts by bucket, boxes ascending in each.
  void fill() {
    const std::size_t buckets = std::bit_ceil(2 * boxes_.size());
    mask_ = buckets - 1;
    first_.assign(buckets + 1, 0);
    for_each_entry([&](const Cell& cell, Index) { ++first_[bucket_of(cell) + 1]; });
    for (std::size_t b = 0; b < buckets; ++b) first_[b + 1] += first_[b];
    entries_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for_each_entry([&](const Cell& cell, Index box) {
      entries_[next[bucket_of(cell)]++] = {RoundedBox(boxes_[box]), cell, box};
    });
  }

  void append_bucket(Index bucket, std::vector<BoxPair>& pairs) const {
    for (std::size_t i = first_[bucket]; i < first_[bucket + 1]; ++i) {
      const CellEntry& entry = entries_[i];
      for (std::size_t j = i + 1; j < first_[bucket + 1]; ++j) {
        const CellEntry& other = entries_[j];
        if (!entry.rounded.overlaps(other.rounded) || !(other.cell == entry.cell)) continue;
        const Box& box = boxes_[entry.box];
        if (!box.overlaps(boxes_[other.box])) continue;
        const Vec3& low = boxes_[other.box].low;
        const Vec3 shared{std::max(box.low.x, low.x), std::max(box.low.y, low.y), std::max(box.low.z, low.z)};
        if (cell_of(shared) == entry.cell) pairs.push_back({entry.box, other.box});
      }
    }
  }

  std::span<const Box> boxes_;
  std::vector<Index> large_;  ///< ascending
  std::vector<std::uint8_t> is_large_;
  double inverse_edge_ = 1;  ///< of the cells [1/length]
  std::size_t mask_ = 0;
  std::vector<std::size_t> first_;  ///< of each bucket, and the end
  std::vector<CellEntry> entries_;
};

}  // namespace

std::vector<BoxPair> overlapping_boxes(std::span<const Box> boxes, int threads) {
  if (boxes.empty()) return {};
  const BoxGrid grid(boxes);
  std::vector<std::vector<BoxPair>> found(static_cast<std::size_t>(grid.chunks()) + 1);
  parallel_for(static_cast<Index>(found.size()), threads, [&](Index chunk) {
    if (chunk < grid.chunks())
      grid.append_pairs(chunk, found[static_cast<std::size_t>(chunk)]);
    else
      grid.append_large(found[static_cast<std::size_t>(chunk)]);
  });
  std::vector<BoxPair> pairs;
  for (const std::vector<BoxPair>& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  return pairs;
}

}  // namespace crumple::contact
