// SPDX-License-Identifier: BSD-3-Clause
// Solids.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "deck/build/build.hpp"
#include "deck/format/vector.hpp"

namespace crumple::deck {

namespace {

using Corners = std::array<Vector, 8>;

/// Places of the corners in the parent cube, in units of half its side.
constexpr std::array<std::array<int, 3>, 8> corner_of_cube = {
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

double triple_product(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Determinant of the Jacobian of the trilinear map at a point of the parent cube [-1, 1]^3.
double jacobian(const Corners& x, const Vector& at) {
  std::array<Vector, 3> tangent{};
  for (std::size_t corner = 0; corner < 8; ++corner)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double slope = 0.125;
      for (std::size_t other = 0; other < 3; ++other) {
        const double place = corner_of_cube[corner][other];
        slope *= other == axis ? place : 1 + place * at[other];
      }
      for (std::size_t i = 0; i < 3; ++i) tangent[axis][i] += slope * x[corner][i];
    }
  return triple_product(tangent[0], tangent[1], tangent[2]);
}

struct Shape {
  double volume = 0;
  double least_jacobian = 0;  ///< at the points of the rule
};

/// By Gauss' rule with 2 x 2 x 2 points, which is exact: the Jacobian is quadratic in each coordinate.
Shape shape_of(const Corners& x) {
  const double gauss_point = std::sqrt(1.0 / 3);
  Shape shape;
  for (std::size_t point = 0; point < 8; ++point) {
    Vector at{};
    for (std::size_t i = 0; i < 3; ++i) at[i] = corner_of_cube[point][i] * gauss_point;
    const double value = jacobian(x, at);
    shape.volume += value;
    shape.least_jacobian = point == 0 ? value : std::min(shape.least_jacobian, value);
  }
  return shape;
}

/// Corners at the same node must hang together by edges of the cube, else the element is folded onto itself.
bool repeats_neighbours_only(const std::array<Index, 8>& node) {
  static constexpr std::array<std::array<std::size_t, 3>, 8> neighbours = {
      {{1, 3, 4}, {0, 2, 5}, {1, 3, 6}, {0, 2, 7}, {0, 5, 7}, {1, 4, 6}, {2, 5, 7}, {3, 4, 6}}};
  // Every corner takes the least place among its equals that it can reach; eight rounds reach all.
  std::array<std::size_t, 8> least{0, 1, 2, 3, 4, 5, 6, 7};
  for (int round = 0; round < 8; ++round)
    for (std::size_t i = 0; i < 8; ++i)
      for (const std::size_t j : neighbours[i])
        if (node[i] == node[j]) least[i] = std::min(least[i], least[j]);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (node[i] == node[j] && least[i] != least[j]) return false;
  return true;
}

/// LS-DYNA's tetrahedron N1, N2, N3, N4, N4, N4, N4, N4 has N4 in the face of N1 to N3: as a hexahedron that
/// face is warped through the middle of the tetrahedron, and half the volume is lost. N3 and N4 four times is
/// the whole.
void unfold_tetrahedron(model::SolidNodes& node) {
  const bool folded = std::all_of(node.begin() + 4, node.end(), [&](Index n) { return n == node[3]; });
  if (folded) node[3] = node[2];
}

/// Nodes that do not make a hexahedron, wedge, pyramid or tetrahedron. True if they do.
bool check_repetitions(const model::SolidElement& solid, const Where& where, Report& report) {
  std::array<Index, 8> node = solid.node;
  std::sort(node.begin(), node.end());
  const auto distinct = std::unique(node.begin(), node.end()) - node.begin();
  if (distinct < 4) {
    report.error(
        where, "repeated",
        fmt::format("solid {} has {} different nodes only, expected at least four", solid.id, distinct));
    return false;
  }
  if (repeats_neighbours_only(solid.node)) return true;
  report.error(
      where, "repeated",
      fmt::format("solid {} has a node twice at corners that are not neighbours; a wedge is N1, N2, N3, N4, "
                  "N5, N5, N6, N6, a pyramid ends in N5 four times, a tetrahedron in N4 five times",
                  solid.id));
  return false;
}

/// A solid of a section that is for tetrahedra. True if it is one, or may have four or eight nodes.
bool check_formulation(const model::SolidElement& solid, const Where& where, Build& build) {
  const model::Part& part = build.model.parts[static_cast<std::size_t>(solid.part)];
  const model::SolidSection& section =
      build.model.solid_sections[static_cast<std::size_t>(part.solid_section)];
  if (!model::is_tetrahedral(section.formulation) && !solid.node.has_middles()) return true;
  if (model::is_tetrahedron(solid) && solid.node.has_middles() != model::is_quadratic(section.formulation)) {
    build.report.error(
        where, "formulation",
        solid.node.has_middles()
            ? fmt::format(
                  "solid {} has ten nodes, which only ELFORM 16 and 17 compute; section {} of its part "
                  "has another formulation",
                  solid.id, section.id)
            : fmt::format(
                  "solid {} has four nodes, but section {} of its part has a formulation for ten, ELFORM "
                  "16 or 17; put tetrahedra of four nodes into a part with ELFORM 13 or 10",
                  solid.id, section.id));
    return false;
  }
  if (model::is_tetrahedron(solid)) return true;
  build.report.error(
      where, "formulation",
      fmt::format("solid {} is no tetrahedron, but section {} of its part has a formulation for tetrahedra, "
                  "{}; put other solids into a part of their own",
                  solid.id, section.id,
                  model::is_quadratic(section.formulation)
                      ? "ELFORM 16 or 17; expected two cards, the second with N1 to N10"
                      : "ELFORM 10 or 13; expected N1, N2, N3, N4, N4, N4, N4, N4"));
  return false;
}

bool is_cohesive(const model::SolidElement& solid, const Build& build) {
  const model::Part& part = build.model.parts[static_cast<std::size_t>(solid.part)];
  return model::is_cohesive(
      build.model.solid_sections[static_cast<std::size_t>(part.solid_section)].formulation);
}

/// ESORT makes wedges and tetrahedra of degenerate hexahedra, each computed by a formulation of its own.
void check_sorting(const model::SolidElement& solid, const Where& where, Build& build) {
  const model::Part& part = build.model.parts[static_cast<std::size_t>(solid.part)];
  const model::SolidSection& section =
      build.model.solid_sections[static_cast<std::size_t>(part.solid_section)];
  if (!build.deck.sorts_solids || model::is_tetrahedral(section.formulation)) return;
  if (model::is_cohesive(section.formulation)) return;
  std::array<Index, 8> node = solid.node;
  std::sort(node.begin(), node.end());
  if (std::adjacent_find(node.begin(), node.end()) == node.end()) return;
  build.report.unsupported(
      where, "sorting",
      fmt::format(
          "solid {} repeats nodes, and ESORT ({}) wants it computed as the tetrahedron or wedge that it is, "
          "not as a hexahedron; put tetrahedra into a part with ELFORM 10, or take ESORT = 0",
          solid.id, build.report.place(*build.deck.sorts_solids)));
}

/// Volume that is not above zero, or corners turned inside out.
void check_shape(const model::SolidElement& solid, const Where& where, Build& build) {
  Corners x;
  for (std::size_t i = 0; i < 8; ++i)
    x[i] = build.model.nodes.position[static_cast<std::size_t>(solid.node[i])];
  double longest = 0;
  for (const Vector& a : x)
    for (const Vector& b : x) longest = std::max(longest, length_of(difference(a, b)));
  const Shape shape = shape_of(x);
  constexpr double flat = 1e-9;
  if (std::fabs(shape.volume) <= flat * longest * longest * longest)
    build.report.error(
        where, "volume",
        fmt::format("solid {} has no volume; check the order of its nodes and their coordinates", solid.id));
  else if (shape.volume < 0)
    build.report.error(
        where, "negative volume",
        fmt::format(
            "solid {} has the negative volume {:.4g}; N1 to N4 run counter-clockwise seen from the side of "
            "N5 to N8: exchange N1-N4 with N5-N8, of a wedge N1 with N2 and N3 with N4, of a pyramid N2 with "
            "N4, of a tetrahedron N2 with N3",
            solid.id, shape.volume));
  else if (!(shape.least_jacobian > 0))
    build.report.warning(
        where, "distorted",
        fmt::format("solid {} is so distorted that one of its corners is turned inside out; its "
                    "results will be poor",
                    solid.id));
}

/// Faces of a cohesive solid that are no quadrilaterals or triangles, whose middle surface has no area, or of
/// which the upper one lies below the lower one. It may have no volume.
void check_layer(const model::SolidElement& solid, const Where& where, Build& build) {
  std::array<Vector, 4> middle{};
  std::array<Vector, 4> apart{};
  for (const std::size_t first : {0U, 4U}) {
    std::array<Index, 4> face{solid.node[first], solid.node[first + 1], solid.node[first + 2],
                              solid.node[first + 3]};
    std::sort(face.begin(), face.end());
    if (std::unique(face.begin(), face.end()) - face.begin() < 3) {
      build.report.error(where, "face",
                         fmt::format("cohesive solid {} has a face with fewer than three nodes; N1 to N4 are "
                                     "one face, N5 to N8 the other",
                                     solid.id));
      return;
    }
  }
  double longest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector& lower = build.model.nodes.position[static_cast<std::size_t>(solid.node[k])];
    const Vector& upper = build.model.nodes.position[static_cast<std::size_t>(solid.node[k + 4])];
    apart[k] = difference(upper, lower);
    for (std::size_t i = 0; i < 3; ++i) middle[k][i] = 0.5 * (lower[i] + upper[i]);
    longest = std::max(longest, length_of(difference(middle[k], middle[0])));
  }
  const Vector one = difference(middle[2], middle[0]);
  const Vector other = difference(middle[3], middle[1]);
  const Vector normal{one[1] * other[2] - one[2] * other[1], one[2] * other[0] - one[0] * other[2],
                      one[0] * other[1] - one[1] * other[0]};
  const double area = length_of(normal);
  constexpr double flat = 1e-9;
  if (area <= flat * longest * longest) {
    build.report.error(where, "area",
                       fmt::format("cohesive solid {} has no area; check the order of its nodes and their "
                                   "coordinates",
                                   solid.id));
    return;
  }
  double thickness = 0;
  for (const Vector& a : apart)
    for (std::size_t i = 0; i < 3; ++i) thickness += 0.25 * a[i] * normal[i] / area;
  if (thickness < -flat * longest)
    build.report.error(
        where, "negative volume",
        fmt::format("cohesive solid {} has the negative thickness {:.4g}; N1 to N4 run "
                    "counter-clockwise seen from the side of N5 to N8: exchange N1-N4 with N5-N8",
                    solid.id, thickness));
}

/// Nodes of a tetrahedron with ten that are not where the order of the card says: each is nearest to the
/// middle of its own side.
void check_middles(const model::SolidElement& solid, const Where& where, Build& build) {
  const auto position = [&](Index node) {
    return build.model.nodes.position[static_cast<std::size_t>(node)];
  };
  const auto middle_of = [&](std::size_t side) {
    const auto [one, other] = model::sides_of_tetrahedron[side];
    const Vector a = position(solid.node[model::corners_of_tetrahedron[one]]);
    const Vector b = position(solid.node[model::corners_of_tetrahedron[other]]);
    return Vector{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
  };
  for (std::size_t side = 0; side < model::SolidNodes::middles; ++side) {
    const Vector x = position(solid.node.middle(side));
    const double own = length_of(difference(x, middle_of(side)));
    for (std::size_t other = 0; other < model::SolidNodes::middles; ++other) {
      if (other == side || length_of(difference(x, middle_of(other))) > own) continue;
      const auto [first, second] = model::sides_of_tetrahedron[side];
      build.report.error(
          where, "order",
          fmt::format("N{} of solid {} is not in the middle of the side from N{} to N{}; N5 to N10 are those "
                      "between N1 and N2, N2 and N3, N3 and N1, N1 and N4, N2 and N4, N3 and N4",
                      side + 5, solid.id, first + 1, second + 1));
      return;
    }
  }
}

/// The nodes in the middle of the sides; false, with a message, if one of them is not there.
bool add_middles(const RawSolid& raw, model::SolidElement& solid, Build& build) {
  static constexpr std::array<std::string_view, 6> fields = {"N5", "N6", "N7", "N8", "N9", "N10"};
  model::SolidNodes::Middles middle{};
  for (std::size_t i = 0; i < middle.size(); ++i) {
    middle[i] = build.find(Item::Node, {raw.middle[i], fields[i], raw.nodes_where});
    if (middle[i] == no_index) return false;
  }
  solid.node = model::SolidNodes(solid.node, middle);
  return true;
}

}  // namespace

void build_solids(Build& build) {
  static constexpr std::array<std::string_view, 8> fields = {"N1", "N2", "N3", "N4", "N5", "N6", "N7", "N8"};
  std::vector<model::SolidElement>& solids = build.model.solids;
  solids.reserve(build.deck.solids.size());
  build.solids_of_part.assign(build.model.parts.size(), 0);
  for (const RawSolid& raw : build.deck.solids) {
    if (build.is_dropped(raw.part)) continue;
    model::SolidElement solid;
    solid.id = raw.id;
    solid.part = find_part_of(build, ElementKind::Solid, {raw.part, "PID", raw.where});
    bool complete = solid.part != no_index;
    for (std::size_t i = 0; i < 8; ++i) {
      const bool again = i > 0 && raw.node[i] == raw.node[i - 1];
      solid.node[i] =
          again ? solid.node[i - 1] : build.find(Item::Node, {raw.node[i], fields[i], raw.nodes_where});
      complete = complete && solid.node[i] != no_index;
    }
    build.enter(Item::Solid, {raw.id, "EID", raw.where}, solids.size());
    if (complete) unfold_tetrahedron(solid.node);
    if (complete && raw.middle[0] != 0) complete = add_middles(raw, solid, build);
    if (complete && check_repetitions(solid, raw.nodes_where, build.report)) {
      if (check_formulation(solid, raw.nodes_where, build)) {
        if (is_cohesive(solid, build))
          check_layer(solid, raw.nodes_where, build);
        else
          check_shape(solid, raw.nodes_where, build);
        if (solid.node.has_middles()) check_middles(solid, raw.nodes_where, build);
      }
      check_sorting(solid, raw.nodes_where, build);
      ++build.solids_of_part[static_cast<std::size_t>(solid.part)];
    }
    solids.push_back(solid);
  }
}

void build_interiors(Build& build) {
  for (const RawInterior& raw : build.deck.interiors) {
    const Index set = build.find(Item::PartSet, {raw.part_set, raw.field, raw.where});
    if (set == no_index) continue;
    const RawSet& attributes = build.deck.part_sets[static_cast<std::size_t>(set)];
    model::InteriorContact interior;
    if (attributes.attributes[0] > 0) interior.scale = attributes.attributes[0];
    if (attributes.attributes[1] > 0) interior.relative_volume = std::min(attributes.attributes[1], 1.0);
    interior.modulus = std::max(attributes.attributes[2], 0.0);
    for (const Index part : build.model.part_sets[static_cast<std::size_t>(set)].parts) {
      model::Part& of = build.model.parts[static_cast<std::size_t>(part)];
      if (of.solid_section != no_index)
        of.interior = interior;
      else
        build.report.warning(
            raw.where, "interior",
            fmt::format("part {} has no solids: interior contact does nothing there", of.id));
    }
  }
}

}  // namespace crumple::deck
