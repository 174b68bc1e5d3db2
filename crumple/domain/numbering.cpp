// SPDX-License-Identifier: BSD-3-Clause
#include "domain/numbering.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

namespace crumple::domain {
namespace {

constexpr double cells_per_axis = 1 << 20;

/// Spreads the lower 21 bits of a number so that two zero bits follow each.
std::uint64_t spread(std::uint64_t bits) {
  bits &= 0x1fffff;
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

struct Bounds {
  std::array<double, 3> minimum{};
  double edge = 1;  ///< longest edge of the bounding box
};

Bounds bounds_of(const model::Nodes& nodes) {
  Bounds bounds;
  double edge = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    for (const auto& x : nodes.position) {
      low = std::min(low, x[axis]);
      high = std::max(high, x[axis]);
    }
    bounds.minimum[axis] = low;
    edge = std::max(edge, high - low);
  }
  bounds.edge = edge > 0 ? edge : 1.0;
  return bounds;
}

template <class Element>
std::uint64_t morton_code(const model::Model& model, const Element& element, const Bounds& bounds) {
  std::uint64_t code = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double centre = 0;
    const double share = 1 / static_cast<double>(element.node.size());
    for (const Index node : element.node) centre += share * model.nodes.position[node][axis];
    const double scaled = (centre - bounds.minimum[axis]) / bounds.edge * (cells_per_axis - 1);
    code |= spread(static_cast<std::uint64_t>(scaled)) << axis;
  }
  return code;
}

/// Elements of each part along the curve.
template <class Element>
std::vector<std::vector<Index>> by_part(const model::Model& model, const std::vector<Element>& elements,
                                        const Bounds& bounds) {
  std::vector<std::pair<std::uint64_t, Index>> order;
  order.reserve(elements.size());
  for (Index e = 0; e < static_cast<Index>(elements.size()); ++e)
    order.emplace_back(morton_code(model, elements[e], bounds), e);
  std::sort(order.begin(), order.end());
  std::vector<std::vector<Index>> parts(model.parts.size());
  for (const auto& [code, element] : order) parts[elements[element].part].push_back(element);
  return parts;
}

}  // namespace

Numbering number_for_locality(const model::Model& model) {
  Numbering numbering;
  const Bounds bounds = bounds_of(model.nodes);
  numbering.shells_by_part = by_part(model, model.shells, bounds);
  numbering.solids_by_part = by_part(model, model.solids, bounds);
  numbering.beams_by_part = by_part(model, model.beams, bounds);
  numbering.discretes_by_part = by_part(model, model.discretes, bounds);

  numbering.domain_node.assign(model.nodes.position.size(), no_index);
  const auto number = [&](Index node) {
    if (numbering.domain_node[node] != no_index) return;
    numbering.domain_node[node] = static_cast<Index>(numbering.model_node.size());
    numbering.model_node.push_back(node);
  };
  const auto number_elements = [&](const auto& parts, const auto& elements) {
    for (const auto& part : parts)
      for (const Index element : part)
        for (const Index node : elements[element].node) number(node);
  };
  number_elements(numbering.shells_by_part, model.shells);
  number_elements(numbering.solids_by_part, model.solids);
  number_elements(numbering.beams_by_part, model.beams);
  number_elements(numbering.discretes_by_part, model.discretes);
  for (Index node = 0; node < model.nodes.count(); ++node) number(node);
  return numbering;
}

}  // namespace crumple::domain
