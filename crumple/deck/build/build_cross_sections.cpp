// SPDX-License-Identifier: BSD-3-Clause
// Cuts through the model: of planes the elements that they cut at time zero, and the nodes on their tail
// side.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "deck/build/build.hpp"
#include "deck/format/vector.hpp"

namespace crumple::deck {

namespace {

Vector scaled(const Vector& a, double factor) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

/// A plane, or the piece of one that its extents leave.
class CutPlane {
 public:
  CutPlane(const RawCutPlane& raw, double tolerance)
      : point_(raw.point),
        normal_(scaled(raw.normal, 1 / length_of(raw.normal))),
        tolerance_(tolerance),
        radius_(raw.radius) {
    if (radius_ > 0 || (raw.length == 0 && raw.width == 0)) return;
    const Vector across = cross(normal_, raw.edge);
    width_axis_ = scaled(across, 1 / length_of(across));
    length_axis_ = cross(width_axis_, normal_);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    length_ = raw.length > 0 ? raw.length : infinite;
    width_ = raw.width > 0 ? raw.width : infinite;
    finite_ = true;
  }

  /// Nodes in the plane are on the side of the tail.
  bool is_ahead(const Vector& x) const { return distance(x) > tolerance_; }

  /// Whether the mean of the points where the plane meets the lines between nodes on both sides lies in it.
  bool cuts(const std::vector<Vector>& corners) const {
    Vector sum{};
    int points = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        if (is_ahead(corners[i]) == is_ahead(corners[j])) continue;
        const double a = distance(corners[i]);
        const double share = a / (a - distance(corners[j]));
        const Vector line = difference(corners[j], corners[i]);
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += corners[i][axis] + share * line[axis];
        ++points;
      }
    return points > 0 && contains(scaled(sum, 1.0 / points));
  }

 private:
  double distance(const Vector& x) const { return dot(difference(x, point_), normal_); }

  bool contains(const Vector& x) const {
    const Vector from = difference(x, point_);
    if (radius_ > 0) return length_of(from) <= radius_;
    if (!finite_) return true;
    const double along = dot(from, length_axis_);
    const double across = dot(from, width_axis_);
    const bool in_length = std::isinf(length_) || (along >= 0 && along <= length_);
    const bool in_width = std::isinf(width_) || (across >= 0 && across <= width_);
    return in_length && in_width;
  }

  Vector point_;
  Vector normal_;
  double tolerance_;
  double radius_;
  bool finite_ = false;
  Vector length_axis_{};
  Vector width_axis_{};
  double length_ = 0;
  double width_ = 0;
};

bool check_plane(const RawCrossSection& raw, Build& build) {
  const RawCutPlane& plane = *raw.plane;
  if (!(length_of(plane.normal) > 0)) {
    build.report.error(
        raw.where, "direction",
        "the head of the normal (XCH, YCH, ZCH) lies at its tail (XCT, YCT, ZCT); give a second "
        "point");
    return false;
  }
  const bool finite = plane.radius == 0 && (plane.length > 0 || plane.width > 0);
  if (finite && !(length_of(cross(plane.normal, plane.edge)) > 0)) {
    build.report.error(plane.edge_where, "direction",
                       "LENL and LENM need an edge: (XHEV, YHEV, ZHEV) must not lie on the normal");
    return false;
  }
  return true;
}

/// Coordinates that differ by less are the same: round-off of a mesh of this size.
double tolerance_of(const Build& build) {
  constexpr double relative = 1e-9;
  double largest = 0;
  for (const auto& x : build.model.nodes.position) largest = std::max(largest, length_of(x));
  return relative * largest;
}

/// Parts that a plane cuts, by index.
std::optional<std::vector<char>> parts_of(const RawCrossSection& raw, Build& build) {
  std::vector<char> wanted(build.model.parts.size(), raw.plane->part_set == 0 ? 1 : 0);
  if (raw.plane->part_set == 0) return wanted;
  const Index set = build.find(Item::PartSet, {raw.plane->part_set, "PSID", raw.where});
  if (set == no_index) return std::nullopt;
  for (const Index part : build.model.part_sets[static_cast<std::size_t>(set)].parts)
    wanted[static_cast<std::size_t>(part)] = 1;
  return wanted;
}

void cut(const RawCrossSection& raw, Build& build, model::CrossSection& section) {
  if (!check_plane(raw, build)) return;
  const std::optional<std::vector<char>> wanted = parts_of(raw, build);
  if (!wanted) return;
  const CutPlane plane(*raw.plane, tolerance_of(build));
  std::vector<char> behind(build.model.nodes.id.size(), 0);
  const auto take = [&](const auto& elements, std::vector<Index>& into) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const auto& element = elements[i];
      if (element.part == no_index || (*wanted)[static_cast<std::size_t>(element.part)] == 0) continue;
      std::vector<Vector> corners;
      for (const Index node : element.node)
        if (node != no_index) corners.push_back(build.model.nodes.position[static_cast<std::size_t>(node)]);
      if (!plane.cuts(corners)) continue;
      into.push_back(static_cast<Index>(i));
      for (const Index node : element.node)
        if (node != no_index && !plane.is_ahead(build.model.nodes.position[static_cast<std::size_t>(node)]))
          behind[static_cast<std::size_t>(node)] = 1;
    }
  };
  take(build.model.shells, section.shells);
  take(build.model.solids, section.solids);
  take(build.model.beams, section.beams);
  take(build.model.discretes, section.discretes);
  for (std::size_t node = 0; node < behind.size(); ++node)
    if (behind[node] != 0) section.nodes.push_back(static_cast<Index>(node));
  if (section.nodes.empty())
    build.report.warning(raw.where, "empty",
                         fmt::format("cross-section {} cuts no element; its force is zero", raw.id));
}

void collect(const RawCrossSection& raw, Build& build, model::CrossSection& section) {
  const auto members = [&](UserId set, std::string_view field, Item item, const auto& members_of) {
    if (set == 0) return std::vector<Index>{};
    const Index index = build.find(item, {set, field, raw.where});
    return index == no_index ? std::vector<Index>{} : members_of(static_cast<std::size_t>(index));
  };
  const model::Model& model = build.model;
  section.nodes =
      members(raw.nodes, "NSID", Item::NodeSet, [&](std::size_t set) { return model.node_sets[set].nodes; });
  section.shells = members(raw.shells, "SSID", Item::ShellSet,
                           [&](std::size_t set) { return model.shell_sets[set].shells; });
  section.solids =
      members(raw.solids, "HSID", Item::SolidSet, [&](std::size_t set) { return build.solid_sets[set]; });
  section.beams =
      members(raw.beams, "BSID", Item::BeamSet, [&](std::size_t set) { return build.beam_sets[set]; });
  section.discretes = members(raw.discretes, "DSID", Item::DiscreteSet,
                              [&](std::size_t set) { return build.discrete_sets[set]; });
  if (raw.shells == 0 && raw.solids == 0 && raw.beams == 0 && raw.discretes == 0)
    build.report.warning(raw.where, "empty",
                         fmt::format("cross-section {} has no elements; its force is zero", raw.id));
}

}  // namespace

void build_cross_sections(Build& build) {
  for (std::size_t i = 0; i < build.deck.cross_sections.size(); ++i) {
    const RawCrossSection& raw = build.deck.cross_sections[i];
    build.enter(Item::CrossSection, {raw.id, "CSID", raw.where}, i);
    model::CrossSection section;
    section.id = raw.id;
    section.title = raw.title;
    if (raw.plane)
      cut(raw, build, section);
    else
      collect(raw, build, section);
    build.model.output.cross_sections.push_back(std::move(section));
  }
}

}  // namespace crumple::deck
