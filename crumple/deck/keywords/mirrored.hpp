// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <utility>

namespace crumple::deck {

/// Values at the corners of a mirrored shell or segment, in the order in which its normal is the image of the
/// old one. The side between the first two corners stays the first, since materials may have their axes along
/// it.
template <class T>
void mirror_face(std::array<T, 4>& corner, bool is_triangle) {
  std::swap(corner[0], corner[1]);
  if (!is_triangle) std::swap(corner[2], corner[3]);
}

/// The nodes of a mirrored solid in an order in which its volume is above zero again. Nodes that are equal
/// stay at their places in tetrahedra, pyramids and wedges.
template <class T>
void mirror_solid(std::array<T, 8>& node) {
  const bool is_tetrahedron =
      std::all_of(node.begin() + 4, node.end(), [&](const T& other) { return other == node[3]; });
  std::swap(node[0], node[1]);
  if (is_tetrahedron) return;
  for (const std::size_t i : {2, 4, 6}) std::swap(node[i], node[i + 1]);
}

/// The same of the nodes between the corners 1-2, 2-3, 3-1, 1-4, 2-4, 3-4 of a tetrahedron.
template <class T>
void mirror_middles(std::array<T, 6>& middle) {
  std::swap(middle[1], middle[2]);
  std::swap(middle[3], middle[4]);
}

}  // namespace crumple::deck
