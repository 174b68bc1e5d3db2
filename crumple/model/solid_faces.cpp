// SPDX-License-Identifier: BSD-3-Clause
#include "model/solid_faces.hpp"

#include <algorithm>
#include <utility>

namespace crumple::model {

namespace {

using Face = std::array<Index, 4>;

constexpr std::array<std::array<std::size_t, 4>, 6> corners = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

}  // namespace

Face key_of(Face face) {
  std::sort(face.begin(), face.end());
  // Which node of a triangle is given twice says nothing.
  const auto end = std::unique(face.begin(), face.end());
  std::fill(end, face.end(), *(end - 1));
  return face;
}

namespace {

/// Four triangles of each face: three at its corners, and one between the nodes in the middle of its sides.
std::vector<Face> quadratic_faces(const SolidNodes& node) {
  // Corners from outside, and the sides from each to the next.
  constexpr std::array<std::array<std::size_t, 3>, 4> corner = {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  constexpr std::array<std::array<std::size_t, 3>, 4> side = {{{2, 1, 0}, {0, 4, 3}, {1, 5, 4}, {2, 3, 5}}};
  std::vector<Face> faces;
  for (std::size_t face = 0; face < 4; ++face) {
    std::array<Index, 3> middle{};
    for (std::size_t k = 0; k < 3; ++k) middle[k] = node.middle(side[face][k]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index before = middle[(k + 2) % 3];
      faces.push_back({node[corners_of_tetrahedron[corner[face][k]]], middle[k], before, before});
    }
    faces.push_back({middle[0], middle[1], middle[2], middle[2]});
  }
  return faces;
}

}  // namespace

std::vector<Face> faces_of(const SolidElement& solid) {
  if (solid.node.has_middles()) return quadratic_faces(solid.node);
  std::vector<Face> faces;
  for (const auto& corner : corners) {
    Face face{};
    std::size_t count = 0;
    for (const std::size_t k : corner) {
      const auto end = face.begin() + static_cast<std::ptrdiff_t>(count);
      if (std::find(face.begin(), end, solid.node[k]) == end) face[count++] = solid.node[k];
    }
    if (count < 3) continue;
    if (count == 3) face[3] = face[2];
    faces.push_back(face);
  }
  return faces;
}

std::vector<SolidFace> all_faces(const std::vector<SolidElement>& solids, const std::vector<Index>& some) {
  std::vector<SolidFace> all;
  all.reserve(6 * some.size());
  for (const Index solid : some)
    for (const Face& face : faces_of(solids[static_cast<std::size_t>(solid)]))
      all.push_back({face, solid, no_index});
  std::vector<std::pair<Face, std::size_t>> keys;
  keys.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) keys.emplace_back(key_of(all[i].node), i);
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i].first != keys[i - 1].first) continue;
    SolidFace& one = all[keys[i - 1].second];
    SolidFace& other = all[keys[i].second];
    one.neighbour = other.solid;
    other.neighbour = one.solid;
  }
  return all;
}

std::vector<SolidFace> outer_faces(const std::vector<SolidElement>& solids, const std::vector<Index>& some) {
  std::vector<SolidFace> outer = all_faces(solids, some);
  std::erase_if(outer, [](const SolidFace& face) { return face.neighbour != no_index; });
  return outer;
}

}  // namespace crumple::model
