// SPDX-License-Identifier: BSD-3-Clause
#include "model/solid_faces.hpp"

#include <algorithm>
#include <map>

namespace crumple::model {

namespace {

using Face = std::array<Index, 4>;

constexpr std::array<std::array<std::size_t, 4>, 6> corners = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// The same for both solids of a face, whichever corner they begin with.
Face key_of(Face face) {
  std::sort(face.begin(), face.end());
  // Which node of a triangle is given twice says nothing.
  const auto end = std::unique(face.begin(), face.end());
  std::fill(end, face.end(), *(end - 1));
  return face;
}

}  // namespace

std::vector<Face> faces_of(const SolidElement& solid) {
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

std::vector<Face> outer_faces(const std::vector<SolidElement>& solids, const std::vector<Index>& some) {
  std::map<Face, int> users;
  for (const Index solid : some)
    for (const Face& face : faces_of(solids[static_cast<std::size_t>(solid)])) ++users[key_of(face)];
  std::vector<Face> outer;
  for (const Index solid : some)
    for (const Face& face : faces_of(solids[static_cast<std::size_t>(solid)]))
      if (users[key_of(face)] == 1) outer.push_back(face);
  return outer;
}

}  // namespace crumple::model
