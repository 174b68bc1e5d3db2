// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/embedded_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "constraints/point_in_solid.hpp"

namespace crumple::constraints {
namespace {

using domain::Domain;
using domain::EmbeddedNode;
using domain::Embedding;
using math::Vec3;

/// How far outside a solid its nodes may lie [natural coordinates]: what is rounded in decks, or lies in the
/// curve of a surface. Their weights are above -0.01, so that no corner carries less than it has.
constexpr double inside_within = 0.01;

struct NodeBox {
  Vec3 low, high;
  void include(const Vec3& point) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
};

NodeBox box_of(const std::vector<Vec3>& points) {
  NodeBox box{points.front(), points.front()};
  for (const Vec3& point : points) box.include(point);
  return box;
}

/// Points in the cells of a regular grid.
class PointGrid {
 public:
  /// `wanted` is the size of a cell, made larger where there would be too many [length].
  PointGrid(const std::vector<Vec3>& points, double wanted) : box_(box_of(points)) {
    constexpr double most_along = 100;
    const Vec3 extent = box_.high - box_.low;
    cell_ = std::max(wanted, std::max({extent.x, extent.y, extent.z}) / most_along);
    for (int axis = 0; axis < 3; ++axis)
      count_[static_cast<std::size_t>(axis)] = cell_ > 0 ? static_cast<Index>(extent[axis] / cell_) + 1 : 1;
    first_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1, 0);
    for (const Vec3& point : points) ++first_[cell_at(point) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    point_.resize(points.size());
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      point_[next[cell_at(points[i])]++] = static_cast<Index>(i);
  }

  /// Calls visit(i) for each point in the cells that a box meets.
  template <class Visit>
  void visit(const NodeBox& box, const Visit& visit) const {
    for (int axis = 0; axis < 3; ++axis)
      if (box.high[axis] < box_.low[axis] || box.low[axis] > box_.high[axis]) return;
    const std::array<Index, 3> low = steps(box.low);
    const std::array<Index, 3> high = steps(box.high);
    for (Index k = low[2]; k <= high[2]; ++k)
      for (Index j = low[1]; j <= high[1]; ++j)
        for (Index i = low[0]; i <= high[0]; ++i) {
          const std::size_t cell = cell_of({i, j, k});
          for (Index at = first_[cell]; at < first_[cell + 1]; ++at) visit(point_[at]);
        }
  }

 private:
  std::array<Index, 3> steps(const Vec3& point) const {
    std::array<Index, 3> found{};
    for (int axis = 0; axis < 3; ++axis) {
      const Index last = count_[static_cast<std::size_t>(axis)] - 1;
      const double step = cell_ > 0 ? (point[axis] - box_.low[axis]) / cell_ : 0;
      found[static_cast<std::size_t>(axis)] =
          static_cast<Index>(std::clamp(step, 0.0, static_cast<double>(last)));
    }
    return found;
  }
  std::size_t cell_of(const std::array<Index, 3>& at) const {
    return (static_cast<std::size_t>(at[2]) * count_[1] + at[1]) * count_[0] + at[0];
  }
  std::size_t cell_at(const Vec3& point) const { return cell_of(steps(point)); }

  NodeBox box_;
  double cell_ = 0;
  std::array<Index, 3> count_{};
  std::vector<Index> first_;  ///< by cell, and one past the last: its run in point_
  std::vector<Index> point_;
};

/// The search for all couplings of a model, one after the other.
class EmbeddedSearch {
 public:
  EmbeddedSearch(const model::Model& model, const Domain& domain)
      : model_(model),
        nodes_(domain.nodes),
        place_(model.solids.size()),
        taken_(static_cast<std::size_t>(model.nodes.count()), 0) {
    for (std::size_t b = 0; b < domain.solids.size(); ++b)
      for (Index at = 0; at < domain.solids[b].elements; ++at)
        place_[domain.solids[b].element[at]] = {static_cast<Index>(domain.shells.size() + b), at};
  }

  Embedding find(const model::EmbeddedBeams& given);

 private:
  /// A node of a beam, and the best that has been found for it.
  struct Sought {
    Index node = no_index;  ///< of the model
    double beyond = inside_within;
    std::array<double, 8> weight{};  ///< of the corners of the first solid
    std::vector<Index> solids;       ///< of the model
  };

  std::vector<Sought> sought_nodes(const model::EmbeddedBeams& given, Embedding& found) const;
  void search(const model::EmbeddedBeams& given, std::vector<Sought>& sought) const;
  void try_solid(Index solid, const Vec3& point, Sought& sought) const;
  NodeBox box_of_solid(Index solid) const;
  double mean_size(const std::vector<Index>& solids) const;
  EmbeddedNode embedded(const Sought& sought) const;
  bool is_long(const Sought& a, const Sought& b) const;
  void note_long_beams(const model::EmbeddedBeams& given, const std::vector<Sought>& sought,
                       Embedding& found) const;

  Vec3 position(Index node) const { return nodes_.position[nodes_.domain_node[node]]; }

  const model::Model& model_;
  const domain::NodeFields& nodes_;
  std::vector<domain::SolidPlace> place_;  ///< by solid of the model
  std::vector<char> taken_;                ///< 1 for nodes that a coupling has, by node of the model
};

std::vector<EmbeddedSearch::Sought> EmbeddedSearch::sought_nodes(const model::EmbeddedBeams& given,
                                                                 Embedding& found) const {
  std::vector<char> of_solid(taken_.size(), 0);
  for (const Index solid : given.solids)
    for (const Index node : model_.solids[solid].node) of_solid[node] = 1;
  std::vector<Index> nodes;
  for (const Index beam : given.beams)
    nodes.insert(nodes.end(), model_.beams[beam].node.begin(), model_.beams[beam].node.end());
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<Sought> sought;
  for (const Index node : nodes)
    if (of_solid[node] != 0)
      ++found.shared;
    else if (taken_[node] != 0)
      ++found.elsewhere;
    else
      sought.emplace_back().node = node;
  return sought;
}

NodeBox EmbeddedSearch::box_of_solid(Index solid) const {
  const model::SolidElement& element = model_.solids[solid];
  NodeBox box{position(element.node[0]), position(element.node[0])};
  for (const Index node : element.node) box.include(position(node));
  // A margin in natural coordinates is at most as much of the box's extent.
  const Vec3 margin = inside_within * (box.high - box.low);
  const double along_all = std::max({margin.x, margin.y, margin.z});
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] -= along_all;
    box.high[axis] += along_all;
  }
  return box;
}

double EmbeddedSearch::mean_size(const std::vector<Index>& solids) const {
  double sum = 0;
  for (const Index solid : solids) {
    const NodeBox box = box_of_solid(solid);
    sum += norm(box.high - box.low);
  }
  return solids.empty() ? 0 : sum / static_cast<double>(solids.size());
}

void EmbeddedSearch::search(const model::EmbeddedBeams& given, std::vector<Sought>& sought) const {
  if (sought.empty()) return;
  std::vector<Vec3> points;
  points.reserve(sought.size());
  for (const Sought& each : sought) points.push_back(position(each.node));
  const PointGrid grid(points, mean_size(given.solids));
  for (const Index solid : given.solids) {
    const NodeBox box = box_of_solid(solid);
    grid.visit(box, [&](Index i) {
      for (int axis = 0; axis < 3; ++axis)
        if (points[i][axis] < box.low[axis] || points[i][axis] > box.high[axis]) return;
      try_solid(solid, points[i], sought[i]);
    });
  }
}

/// Keeps the solid if the point is in it, or less far outside than of those before.
void EmbeddedSearch::try_solid(Index solid, const Vec3& point, Sought& sought) const {
  const model::SolidElement& element = model_.solids[solid];
  std::array<double, 8> weight{};
  double beyond = 0;
  if (model::is_tetrahedron(element)) {
    std::array<Vec3, 4> corner;
    for (std::size_t k = 0; k < 4; ++k) corner[k] = position(element.node[model::corners_of_tetrahedron[k]]);
    const auto found = point_in_tetrahedron(corner, point);
    if (!found) return;
    for (std::size_t k = 0; k < 4; ++k) weight[model::corners_of_tetrahedron[k]] = found->weight[k];
    beyond = found->beyond;
  } else {
    std::array<Vec3, 8> corner;
    for (std::size_t k = 0; k < 8; ++k) corner[k] = position(element.node[k]);
    const auto found = point_in_hexahedron(corner, point);
    if (!found) return;
    weight = found->weight;
    beyond = found->beyond;
  }
  if (beyond == 0 && sought.beyond == 0 && !sought.solids.empty()) {
    sought.solids.push_back(solid);
  } else if (beyond < sought.beyond) {
    sought.beyond = beyond;
    sought.weight = weight;
    sought.solids = {solid};
  }
}

/// Corners that coincide are one, and those without weight are none.
EmbeddedNode EmbeddedSearch::embedded(const Sought& sought) const {
  EmbeddedNode made;
  made.node = nodes_.domain_node[sought.node];
  const model::SolidElement& element = model_.solids[sought.solids.front()];
  for (std::size_t k = 0; k < 8; ++k) {
    if (sought.weight[k] == 0) continue;
    const Index node = nodes_.domain_node[element.node[k]];
    const auto end = made.corner.begin() + made.corners;
    const auto known = std::find(made.corner.begin(), end, node);
    made.weight[static_cast<std::size_t>(known - made.corner.begin())] += sought.weight[k];
    if (known != end) continue;
    *known = node;
    ++made.corners;
  }
  for (const Index solid : sought.solids) made.hosts.push_back(place_[solid]);
  return made;
}

/// Whether there are solids between those of two nodes: no node is common to both.
bool EmbeddedSearch::is_long(const Sought& a, const Sought& b) const {
  for (const Index first : a.solids)
    for (const Index second : b.solids)
      for (const Index node : model_.solids[first].node)
        if (std::ranges::find(model_.solids[second].node, node) != model_.solids[second].node.end())
          return false;
  return true;
}

void EmbeddedSearch::note_long_beams(const model::EmbeddedBeams& given, const std::vector<Sought>& sought,
                                     Embedding& found) const {
  if (!given.between_nodes) return;
  const auto sought_of = [&](Index node) {
    const auto at = std::ranges::lower_bound(sought, node, {}, &Sought::node);
    return at == sought.end() || at->node != node || at->solids.empty() ? nullptr : &*at;
  };
  for (const Index beam : given.beams) {
    const Sought* const a = sought_of(model_.beams[beam].node[0]);
    const Sought* const b = sought_of(model_.beams[beam].node[1]);
    if (a != nullptr && b != nullptr && is_long(*a, *b)) found.long_beams.push_back(model_.beams[beam].id);
  }
}

Embedding EmbeddedSearch::find(const model::EmbeddedBeams& given) {
  Embedding found;
  found.id = given.id;
  std::vector<Sought> sought = sought_nodes(given, found);
  search(given, sought);
  for (const Sought& each : sought) {
    if (each.solids.empty()) {
      found.outside.push_back(model_.nodes.id[each.node]);
      continue;
    }
    taken_[each.node] = 1;
    found.nodes.push_back(embedded(each));
  }
  found.holds.assign(found.nodes.size(), 1);
  note_long_beams(given, sought, found);
  if (found.nodes.empty() && found.shared + found.elsewhere == 0)
    throw Error(found.name() + ": none of the nodes of its beams lies in one of its solids.");
  return found;
}

}  // namespace

void find_embedded_beams(const model::Model& model, Domain& domain) {
  if (model.embedded_beams.empty()) return;
  EmbeddedSearch search(model, domain);
  for (const model::EmbeddedBeams& given : model.embedded_beams)
    domain.embeddings.push_back(search.find(given));
}

}  // namespace crumple::constraints
