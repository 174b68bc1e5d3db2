// SPDX-License-Identifier: BSD-3-Clause
#include "queries/spatial_order.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "cellsearch/box.hpp"
#include "queries/radix_sort.hpp"

namespace cellsearch {
namespace {

constexpr int bits = 21;
constexpr std::size_t few = 16;  // points in one cell that may stay in any order

/// Moves bit i of a number below 2^21 to bit 3 i, by doubling the gaps (Morton 1966).
std::uint64_t spread(std::uint64_t x) {
  x = (x | (x << 32)) & 0x001f00000000ffffu;
  x = (x | (x << 16)) & 0x001f0000ff0000ffu;
  x = (x | (x << 8)) & 0x100f00f00f00f00fu;
  x = (x | (x << 4)) & 0x10c30c30c30c30c3u;
  return (x | (x << 2)) & 0x1249249249249249u;
}

const double* point(std::span<const double> xyz, Index i) {
  return xyz.data() + 3 * static_cast<std::size_t>(i);
}

}  // namespace

std::span<const Index> SpatialOrder::sort(std::span<const double> xyz) {
  const std::size_t count = xyz.size() / 3;
  items_.resize(count);
  scratch_.resize(count);
  for (std::size_t i = 0; i < count; ++i) items_[i] = {0, static_cast<Index>(i)};
  sort_range(xyz, 0, count);
  order_.resize(count);
  for (std::size_t i = 0; i < count; ++i) order_[i] = items_[i].point;
  return order_;
}

bool SpatialOrder::encode(std::span<const double> xyz, std::size_t begin, std::size_t end) {
  Box box;
  for (std::size_t i = begin; i < end; ++i) box.include(point(xyz, items_[i].point));
  double extent = 0.0;
  for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, box.hi[axis] - box.lo[axis]);
  constexpr double cells = static_cast<double>(1 << bits);
  const double per_length = cells / extent;
  if (!(extent > 0.0) || !(per_length < 1e300)) return false;
  for (std::size_t i = begin; i < end; ++i) {
    const double* its = point(xyz, items_[i].point);
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double place = (its[axis] - box.lo[axis]) * per_length;
      code |= spread(static_cast<std::uint64_t>(std::min(place, cells - 1.0))) << axis;
    }
    items_[i].code = code;
  }
  return true;
}

void SpatialOrder::sort_range(std::span<const double> xyz, std::size_t begin, std::size_t end) {
  if (begin == end || !encode(xyz, begin, end)) return;
  sort_by_code(begin, end);
  for (std::size_t run = begin; run < end;) {
    const std::uint64_t code = items_[run].code;
    std::size_t next = run + 1;
    while (next < end && items_[next].code == code) ++next;
    // The run is 2^21 times smaller than this range, so this cannot go deep.
    if (next - run > few) sort_range(xyz, run, next);
    run = next;
  }
}

void SpatialOrder::sort_by_code(std::size_t begin, std::size_t end) {
  const std::span<Item> items(items_.data() + begin, end - begin);
  if (items.size() < 512) {
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
      return a.code != b.code ? a.code < b.code : a.point < b.point;
    });
    return;
  }
  const std::span<Item> scratch(scratch_.data() + begin, end - begin);
  radix_sort(items, scratch, [](const Item& item) { return item.code; });
}

Offset SpatialOrder::bytes() const {
  return static_cast<Offset>((items_.size() + scratch_.size()) * sizeof(Item) +
                             order_.size() * sizeof(Index));
}

}  // namespace cellsearch
