// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>

#include "base/index.hpp"

namespace crumple::model {

/// The nodes of a solid: those of its eight corners, degenerate ones repeat some (see SolidElement), and of a
/// tetrahedron with ten nodes those in the middle of its sides. As a range eight or fourteen nodes.
class SolidNodes {
 public:
  static constexpr std::size_t corners = 8;
  static constexpr std::size_t middles = 6;
  using Corners = std::array<Index, corners>;
  using Middles = std::array<Index, middles>;  ///< between corners 1-2, 2-3, 3-1, 1-4, 2-4, 3-4

  SolidNodes() = default;
  SolidNodes(const Corners& corner) {  // NOLINT(google-explicit-constructor): eight nodes are a solid's
    std::copy(corner.begin(), corner.end(), all_.begin());
  }
  SolidNodes(std::initializer_list<Index> corner) {
    std::copy_n(corner.begin(), std::min(corner.size(), corners), all_.begin());
  }
  /// `corner` as those of a tetrahedron.
  SolidNodes(const Corners& corner, const Middles& middle) : SolidNodes(corner) {
    std::copy(middle.begin(), middle.end(), all_.begin() + corners);
    count_ = corners + middles;
  }

  bool has_middles() const { return count_ > corners; }
  Index middle(std::size_t side) const { return all_[corners + side]; }
  operator Corners() const {  // NOLINT(google-explicit-constructor): what looks at corners alone
    Corners found;
    std::copy_n(all_.begin(), corners, found.begin());
    return found;
  }

  std::size_t size() const { return count_; }
  Index& operator[](std::size_t i) { return all_[i]; }
  Index operator[](std::size_t i) const { return all_[i]; }
  const Index* begin() const { return all_.data(); }
  const Index* end() const { return all_.data() + count_; }
  Index* begin() { return all_.data(); }
  Index* end() { return all_.data() + count_; }
  friend bool operator==(const SolidNodes& a, const SolidNodes& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  std::array<Index, corners + middles> all_{};
  std::size_t count_ = corners;
};

/// Corners at the ends of the sides of a tetrahedron, as it has four; the order of the nodes in the middle.
inline constexpr std::array<std::array<std::size_t, 2>, SolidNodes::middles> sides_of_tetrahedron = {
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
/// The places of the four corners of a tetrahedron among the eight.
inline constexpr std::array<std::size_t, 4> corners_of_tetrahedron = {0, 1, 2, 4};

}  // namespace crumple::model
