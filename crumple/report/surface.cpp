// SPDX-License-Identifier: BSD-3-Clause
#include "report/surface.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"

namespace crumple::report {

namespace {

constexpr int none = -1;
/// Corners of the faces of a solid, seen from outside; `none` ends a triangle.
using Corners = std::array<int, 4>;
constexpr std::array<Corners, 4> tetrahedron{
    {{0, 2, 1, none}, {0, 1, 3, none}, {1, 2, 3, none}, {2, 0, 3, none}}};
/// Three triangles at the corners of each face and one between them.
constexpr std::array<Corners, 16> quadratic_tetrahedron{{{0, 6, 4, none},
                                                         {2, 5, 6, none},
                                                         {1, 4, 5, none},
                                                         {6, 5, 4, none},
                                                         {0, 4, 7, none},
                                                         {1, 8, 4, none},
                                                         {3, 7, 8, none},
                                                         {4, 8, 7, none},
                                                         {1, 5, 8, none},
                                                         {2, 9, 5, none},
                                                         {3, 8, 9, none},
                                                         {5, 9, 8, none},
                                                         {2, 6, 9, none},
                                                         {0, 7, 6, none},
                                                         {3, 9, 7, none},
                                                         {6, 7, 9, none}}};
constexpr std::array<Corners, 5> pyramid{
    {{0, 3, 2, 1}, {0, 1, 4, none}, {1, 2, 4, none}, {2, 3, 4, none}, {3, 0, 4, none}}};
constexpr std::array<Corners, 5> wedge{
    {{0, 1, 2, none}, {3, 5, 4, none}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}};
constexpr std::array<Corners, 6> hexahedron{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// A type of VTK's cells that our files have.
struct CellType {
  int corners = 0;
  bool line = false;
  bool solid = false;
  std::span<const Corners> faces;
};

CellType type_of(std::int64_t number) {
  constexpr CellType vertex{1, false, false, {}};
  constexpr CellType line{2, true, false, {}};
  constexpr CellType triangle{3, false, false, {}};
  constexpr CellType quadrilateral{4, false, false, {}};
  switch (number) {
    case 1:
      return vertex;
    case 3:
      return line;
    case 5:
      return triangle;
    case 9:
      return quadrilateral;
    case 10:
      return {4, false, true, tetrahedron};
    case 24:
      return {10, false, true, quadratic_tetrahedron};
    case 12:
      return {8, false, true, hexahedron};
    case 13:
      return {6, false, true, wedge};
    case 14:
      return {5, false, true, pyramid};
    default:
      throw Error(fmt::format("Cells of VTK's type {} cannot be shown.", number));
  }
}

/// A face of a solid with its nodes in ascending order, by which its other side is found.
struct SolidFace {
  std::array<Index, 4> key{};
  Face face;
};

class SurfaceMaker {
 public:
  SurfaceMaker(const CellList& cells, Index points) : cells_(cells), points_(points) {}

  Surface make() {
    if (cells_.types.size() != cells_.offsets.size() || cells_.death.size() != cells_.offsets.size())
      throw Error("The cells of a frame have types and ends of different numbers.");
    std::int64_t start = 0;
    for (std::size_t cell = 0; cell < cells_.types.size(); ++cell) {
      add_cell(static_cast<Index>(cell), start);
      start = cells_.offsets[cell];
    }
    match_solid_faces();
    number_anew();
    return std::move(surface_);
  }

 private:
  void add_cell(Index cell, std::int64_t start) {
    const CellType type = type_of(cells_.types[cell]);
    const std::int64_t end = cells_.offsets[cell];
    if (start < 0 || end - start != type.corners ||
        end > static_cast<std::int64_t>(cells_.connectivity.size()))
      throw Error(fmt::format("Cell {} of a frame has a wrong number of nodes.", cell));
    const std::span<const std::int64_t> nodes =
        std::span(cells_.connectivity).subspan(start, static_cast<std::size_t>(type.corners));
    for (const std::int64_t node : nodes)
      if (node < 0 || node >= points_)
        throw Error(fmt::format("Cell {} of a frame has a node that does not exist.", cell));
    const auto node = [&](int corner) { return static_cast<Index>(nodes[corner]); };
    if (type.solid)
      for (const Corners& corners : type.faces) {
        const Index last = node(corners[3] == none ? corners[2] : corners[3]);
        const Face face{{node(corners[0]), node(corners[1]), node(corners[2]), last}, cell, no_index};
        solid_faces_.push_back({face.node, face});
        std::sort(solid_faces_.back().key.begin(), solid_faces_.back().key.end());
      }
    else if (type.line)
      surface_.lines.push_back({{node(0), node(1), node(1), node(1)}, cell, no_index});
    else if (type.corners > 1)
      surface_.faces.push_back({{node(0), node(1), node(2), node(type.corners - 1)}, cell, no_index});
  }

  void match_solid_faces() {
    // A triangle's key holds one node twice, and whichever it is, its other side must have the same key.
    for (SolidFace& side : solid_faces_) {
      auto& key = side.key;
      const auto end = std::unique(key.begin(), key.end());
      std::fill(end, key.end(), no_index);
    }
    std::stable_sort(solid_faces_.begin(), solid_faces_.end(),
                     [](const SolidFace& a, const SolidFace& b) { return a.key < b.key; });
    std::vector<Face> seen;
    for (std::size_t i = 0; i < solid_faces_.size();) {
      std::size_t end = i + 1;
      while (end < solid_faces_.size() && solid_faces_[end].key == solid_faces_[i].key) ++end;
      // A side that is folded to a line has nothing to show.
      if (solid_faces_[i].key[2] == no_index) {
        i = end;
        continue;
      }
      if (end - i == 2) {
        add_inner(seen, solid_faces_[i].face, solid_faces_[i + 1].face);
      } else {
        for (std::size_t side = i; side < end; ++side) seen.push_back(solid_faces_[side].face);
      }
      i = end;
    }
    std::stable_sort(seen.begin(), seen.end(), [](const Face& a, const Face& b) { return a.cell < b.cell; });
    surface_.faces.insert(surface_.faces.end(), seen.begin(), seen.end());
  }

  void add_inner(std::vector<Face>& seen, Face first, Face second) const {
    const Index first_death = cells_.death[first.cell];
    const Index second_death = cells_.death[second.cell];
    if (first_death == second_death) return;
    Face& lasting = first_death > second_death ? first : second;
    lasting.behind = first_death > second_death ? second.cell : first.cell;
    seen.push_back(lasting);
  }

  void number_anew() {
    std::vector<Index> node_place(points_, no_index);
    std::vector<Index> cell_place(cells_.types.size(), no_index);
    for (auto* list : {&surface_.faces, &surface_.lines})
      for (const Face& face : *list) {
        for (const Index node : face.node) node_place[node] = 0;
        cell_place[face.cell] = 0;
        if (face.behind != no_index) cell_place[face.behind] = 0;
      }
    const auto number = [](std::vector<Index>& place, std::vector<Index>& used) {
      for (std::size_t i = 0; i < place.size(); ++i)
        if (place[i] != no_index) {
          place[i] = static_cast<Index>(used.size());
          used.push_back(static_cast<Index>(i));
        }
    };
    number(node_place, surface_.nodes);
    number(cell_place, surface_.cells);
    for (auto* list : {&surface_.faces, &surface_.lines})
      for (Face& face : *list) {
        for (Index& node : face.node) node = node_place[node];
        face.cell = cell_place[face.cell];
        if (face.behind != no_index) face.behind = cell_place[face.behind];
      }
  }

  const CellList& cells_;
  Index points_;
  Surface surface_;
  std::vector<SolidFace> solid_faces_;
};

}  // namespace

Surface make_surface(const CellList& cells, Index points) {
  return SurfaceMaker(cells, points).make();
}

}  // namespace crumple::report
