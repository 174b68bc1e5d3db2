// SPDX-License-Identifier: BSD-3-Clause
#include "queries/box_classes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

#include "parallel.hpp"

namespace cellsearch {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr std::uint8_t no_class = BoxClasses::most;
constexpr int blocks = 64;

/// Expansions may have made a box infinite. Cutting all boxes off at the largest number changes neither which
/// intersect nor which contain others, and gives every box a centre.
double cut(double x) {
  return std::clamp(x, -largest, largest);
}

double half_extent(const Box& box, int axis) {
  return 0.5 * cut(box.hi[axis]) - 0.5 * cut(box.lo[axis]);
}

double centre(const Box& box, int axis) {
  return 0.5 * cut(box.lo[axis]) + 0.5 * cut(box.hi[axis]);
}

/// The exponent as stored in a double: grows by one from each power of two to the next.
int exponent_of(const Box& box) {
  const double size = std::max({half_extent(box, 0), half_extent(box, 1), half_extent(box, 2)});
  return static_cast<int>((std::bit_cast<std::uint64_t>(size) >> 52) & 0x7ff);
}

}  // namespace

void BoxClasses::build(std::span<const Box> boxes, int threads) {
  sort(boxes, threads);
  centres_.resize(3 * order_.size());
  for_blocks(threads, most, [&](int k) { place_centres(boxes, classes_[static_cast<std::size_t>(k)]); });
  for (Class& its : classes_) {
    const std::size_t begin = 3 * static_cast<std::size_t>(its.begin);
    const std::size_t length = 3 * static_cast<std::size_t>(its.end) - begin;
    its.grid.build(std::span<const double>(centres_).subspan(begin, length), threads);
  }
  int larger = most;
  for (int k = most - 1; k >= 0; --k) {
    const Class& its = classes_[static_cast<std::size_t>(k)];
    next_[static_cast<std::size_t>(k)] = larger;
    if (its.begin < its.end) larger = k;
  }
}

void BoxClasses::sort(std::span<const Box> boxes, int threads) {
  const Index count = static_cast<Index>(boxes.size());
  const auto box_of = [&](Index i) -> const Box& { return boxes[static_cast<std::size_t>(i)]; };
  std::array<int, blocks> highest_of{};
  for_blocks(threads, blocks, [&](int block) {
    int highest = 0;
    const BlockRange range(count, block, blocks);
    for (Index i = range.begin; i < range.end; ++i) {
      if (!box_of(i).empty()) highest = std::max(highest, exponent_of(box_of(i)));
    }
    highest_of[static_cast<std::size_t>(block)] = highest;
  });
  const int lowest = *std::max_element(highest_of.begin(), highest_of.end()) - (most - 1);
  class_of_.resize(boxes.size());
  for_blocks(threads, blocks, [&](int block) {
    const BlockRange range(count, block, blocks);
    for (Index i = range.begin; i < range.end; ++i) {
      const Box& box = box_of(i);
      const int its = box.empty() ? no_class : std::max(exponent_of(box) - lowest, 0);
      class_of_[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(its);
    }
  });

  std::array<Index, most + 1> ends{};
  for (const std::uint8_t its : class_of_) ++ends[its];
  Index place = 0;
  for (std::size_t k = 0; k < most; ++k) {
    classes_[k].begin = place;
    place += ends[k];
    classes_[k].end = place;
    ends[k] = classes_[k].begin;
  }
  order_.resize(static_cast<std::size_t>(place));
  for (Index i = 0; i < count; ++i) {
    const std::uint8_t its = class_of_[static_cast<std::size_t>(i)];
    if (its != no_class) order_[static_cast<std::size_t>(ends[its]++)] = i;
  }
}

void BoxClasses::place_centres(std::span<const Box> boxes, Class& its) {
  its.centres = Box{};
  its.reach = {0.0, 0.0, 0.0};
  for (Index place = its.begin; place < its.end; ++place) {
    const Box& box = boxes[static_cast<std::size_t>(order_[static_cast<std::size_t>(place)])];
    double* xyz = centres_.data() + 3 * static_cast<std::size_t>(place);
    for (int axis = 0; axis < 3; ++axis) {
      xyz[axis] = centre(box, axis);
      // From the rounded centre, which need not be in the middle.
      const double reach = std::max(cut(box.hi[axis]) - xyz[axis], xyz[axis] - cut(box.lo[axis]));
      its.reach[axis] = std::max(its.reach[axis], reach);
    }
    its.centres.include(xyz);
  }
}

void BoxClasses::near(const Box& box, int size_class, Array<Index>& found) const {
  found.clear();
  const Class& its = classes_[static_cast<std::size_t>(size_class)];
  // The reach and this sum are rounded, each by half a unit at most; the slack is some times that.
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  constexpr double smallest = std::numeric_limits<double>::min();
  Box around;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = cut(box.lo[axis]);
    const double hi = cut(box.hi[axis]);
    const double reach = its.reach[axis];
    around.lo[axis] = cut((lo - reach) - (rounding * (std::fabs(lo) + reach) + smallest));
    around.hi[axis] = cut((hi + reach) + (rounding * (std::fabs(hi) + reach) + smallest));
  }
  if (!around.intersects(its.centres)) return;
  its.grid.collect(around, found);
  const Index* order = order_.data() + its.begin;
  for (Index& entry : found) entry = order[entry];
}

Offset BoxClasses::bytes() const {
  Offset sum = static_cast<Offset>(class_of_.size() + order_.size() * sizeof(Index) +
                                   centres_.size() * sizeof(double));
  for (const Class& its : classes_) sum += its.grid.bytes();
  return sum;
}

}  // namespace cellsearch
