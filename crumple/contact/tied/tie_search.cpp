// SPDX-License-Identifier: BSD-3-Clause
#include "contact/tied/tie_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "contact/surface/nearest_segment.hpp"
#include "contact/surface/sides.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

using domain::Tie;
using domain::TiedNode;

/// The nodes of the first side as nodes, all of the second as segments.
model::Contact as_contact(const model::TiedContact& tied) {
  model::Contact contact;
  contact.id = tied.id;
  contact.kind = model::ContactKind::NodesToSurface;
  contact.side = tied.side;
  return contact;
}

/// Search for one tied contact.
class TieSearch {
 public:
  TieSearch(const model::Model& model, domain::Domain& domain, const model::TiedContact& tied)
      : model_(model),
        domain_(domain),
        tied_(tied),
        surface_(build_surface(model, domain, as_contact(tied))),
        x_{domain.nodes.position.data(), domain.nodes.velocity.data(), 0} {
    measure_thickness();
    measure_normals();
  }

  /// `taken` has 1 for the domain nodes that ties by constraint have already.
  void find(std::vector<char>& taken, Tie& tie);

 private:
  struct Pair {
    Index place = no_index;
    NearestSegment::Found found;
  };

  void measure_thickness();
  void measure_normals();
  void measure_areas(const std::vector<Pair>& pairs);
  double stiffness(Index place, Index segment) const;
  double shell_thickness(Index segment) const;
  double tolerance(Index place, Index segment) const;
  TiedNode tied_node(const Pair& pair) const;

  const model::Model& model_;
  domain::Domain& domain_;
  const model::TiedContact& tied_;
  Surface surface_;
  Configuration x_;
  std::vector<double> thickness_;  ///< of shells at the nodes, by place [length]
  std::vector<Vec3> normal_;       ///< of the first side at the nodes, by place, of any length
  std::vector<char> on_face_;      ///< 1: that is an outward normal, by place
  std::vector<double> area_;       ///< share of the nodes in the first side, by place [length^2]
  std::vector<double> bedding_;    ///< least stiffness over area of the nodes' segments there [stress/length]
};

double given_thickness(const model::ContactSide& side, double true_thickness) {
  return side.contact_thickness > 0 ? side.contact_thickness : side.thickness_scale * true_thickness;
}

void TieSearch::measure_thickness() {
  thickness_.assign(surface_.nodes.size(), 0.0);
  for (const model::ShellElement& shell : model_.shells) {
    const std::array<double, 4> at_nodes = model::shell_thickness(model_, shell);
    for (std::size_t k = 0; k < 4; ++k) {
      const Index place = surface_.place[domain_.nodes.domain_node[shell.node[k]]];
      if (place != no_index) thickness_[place] = std::max(thickness_[place], at_nodes[k]);
    }
  }
}

void TieSearch::measure_normals() {
  normal_.assign(surface_.nodes.size(), Vec3{});
  on_face_.assign(surface_.nodes.size(), 1);
  for (Index s = 0; s < surface_.segments(); ++s) {
    if ((surface_.segment_side[s] & first_side) == 0 || surface_.active[s] == 0) continue;
    const Vec3 normal = normalised(area_normal(shape_of(surface_, x_, s)));
    const int corners = surface_.is_triangle(s) ? 3 : 4;
    for (int k = 0; k < corners; ++k) {
      const Index place = surface_.place[surface_.segment(s)[k]];
      normal_[place] += normal;
      if (!surface_.is_face(s)) on_face_[place] = 0;
    }
  }
}

/// Of the segments of the first side that are tied with all their nodes: those beside the joint do not count,
/// unless a node has no others.
void TieSearch::measure_areas(const std::vector<Pair>& pairs) {
  std::vector<char> tied(surface_.nodes.size(), 0);
  for (const Pair& pair : pairs) tied[pair.place] = 1;
  area_.assign(surface_.nodes.size(), 0.0);
  bedding_.assign(surface_.nodes.size(), std::numeric_limits<double>::max());
  std::vector<double> of_all(surface_.nodes.size(), 0.0);
  for (Index s = 0; s < surface_.segments(); ++s) {
    if ((surface_.segment_side[s] & first_side) == 0 || surface_.active[s] == 0) continue;
    const Index* nodes = surface_.segment(s);
    const bool whole =
        std::all_of(nodes, nodes + 4, [&](Index node) { return tied[surface_.place[node]] != 0; });
    const int corners = surface_.is_triangle(s) ? 3 : 4;
    for (int k = 0; k < corners; ++k) {
      const Index place = surface_.place[nodes[k]];
      of_all[place] += surface_.area[s] / corners;
      if (!whole) continue;
      area_[place] += surface_.area[s] / corners;
      bedding_[place] = std::min(bedding_[place], surface_.stiffness[s] / surface_.area[s]);
    }
  }
  for (std::size_t i = 0; i < area_.size(); ++i)
    if (area_[i] == 0) area_[i] = of_all[i];
}

/// That of the softer side, in proportion to the area of the node, so that springs stretch alike under a
/// constant stress. A node without area has that of the segment.
double TieSearch::stiffness(Index place, Index segment) const {
  if (!(area_[place] > 0)) return std::min(surface_.node_stiffness[place], surface_.stiffness[segment]);
  return std::min(bedding_[place], surface_.stiffness[segment] / surface_.area[segment]) * area_[place];
}

/// Zero for faces of solids.
double TieSearch::shell_thickness(Index segment) const {
  const ElementPlace& place = surface_.behind[segment];
  if (place.block >= static_cast<Index>(domain_.shells.size())) return 0;
  const Index shell = domain_.shells[place.block].element[place.element];
  const std::array<double, 4> at_nodes = model::shell_thickness(model_, model_.shells[shell]);
  return 0.25 * ((at_nodes[0] + at_nodes[1]) + (at_nodes[2] + at_nodes[3]));
}

double TieSearch::tolerance(Index place, Index segment) const {
  if (tied_.tolerance > 0) return tied_.tolerance;
  const SegmentShape shape = shape_of(surface_, x_, segment);
  const double smaller =
      std::min(norm(shape.corner[2] - shape.corner[0]), norm(shape.corner[3] - shape.corner[1]));
  const double of_node = given_thickness(tied_.side[0], thickness_[place]);
  const double of_segment = given_thickness(tied_.side[1], shell_thickness(segment));
  return std::max(tolerances::tied_over_thickness * (of_node + of_segment),
                  tolerances::tied_over_diagonal * smaller);
}

TiedNode TieSearch::tied_node(const Pair& pair) const {
  const auto& [place, found] = pair;
  const Index s = found.segment;
  TiedNode tied;
  tied.node = surface_.nodes[place];
  std::copy_n(surface_.segment(s), 4, tied.corner.begin());
  tied.weight = found.nearest.weight;
  tied.area = area_[place];
  tied.stiffness = stiffness(place, s);
  tied.block = surface_.behind[s].block;
  tied.element = surface_.behind[s].element;
  tied.segment = surface_.segment_id[s];
  if (tied_.method == model::TieMethod::Constraint) return tied;
  // What is left over beside the normal goes into the weights: the diagonals span the segment's plane.
  const SegmentShape shape = shape_of(surface_, x_, s);
  const Vec3 normal = normalised(area_normal(shape));
  const Vec3 away = x_[tied.node] - found.nearest.point;
  tied.height = dot(away, normal);
  const Vec3 aside = away - tied.height * normal;
  const Vec3 first = shape.corner[2] - shape.corner[0];
  const Vec3 second = shape.corner[3] - shape.corner[1];
  const Vec3 product = cross(first, second);
  const double size = dot(product, product);
  const double along_first = dot(cross(aside, second), product) / size;
  const double along_second = dot(cross(first, aside), product) / size;
  tied.weight[0] -= along_first;
  tied.weight[2] += along_first;
  tied.weight[1] -= along_second;
  tied.weight[3] += along_second;
  if (!surface_.is_face(s) && tied.height < 0) tied.side = -1;
  return tied;
}

void TieSearch::find(std::vector<char>& taken, Tie& tie) {
  std::vector<Index> segments;
  for (Index s = 0; s < surface_.segments(); ++s)
    if ((surface_.segment_side[s] & second_side) != 0 && surface_.active[s] != 0) segments.push_back(s);
  tie.segments = static_cast<Index>(segments.size());
  const bool constraint = tied_.method == model::TieMethod::Constraint;
  const NearestSegment nearest(surface_, x_, std::move(segments));
  std::vector<Pair> pairs;
  for (Index place = 0; place < surface_.node_count(); ++place) {
    if ((surface_.node_side[place] & first_side) == 0) continue;
    const Index node = surface_.nodes[place];
    if (constraint && taken[node] != 0) {
      ++tie.tied_elsewhere;
      continue;
    }
    const NearestSegment::Found found = nearest.find(node, normal_[place], on_face_[place] != 0);
    if (found.segment == no_index) continue;
    const double distance = std::sqrt(found.nearest.distance_squared);
    if (distance > tolerance(place, found.segment)) {
      tie.untied.push_back({surface_.node_id[place], distance});
      continue;
    }
    pairs.push_back({place, found});
    if (constraint) taken[node] = 1;
  }
  measure_areas(pairs);
  tie.nodes.reserve(pairs.size());
  for (const Pair& pair : pairs) tie.nodes.push_back(tied_node(pair));
  std::stable_sort(tie.untied.begin(), tie.untied.end(),
                   [](const auto& a, const auto& b) { return a.distance > b.distance; });
}

/// Finds what one tied contact ties; throws Error if that is nothing.
Tie find_tie(const model::Model& model, domain::Domain& domain, const model::TiedContact& tied,
             std::vector<char>& taken) {
  Tie tie;
  tie.id = tied.id;
  tie.method = tied.method;
  TieSearch(model, domain, tied).find(taken, tie);
  if (tie.nodes.empty() && tie.tied_elsewhere == 0)
    throw Error(tie.name() + " ties nothing: the nearest of its nodes, " +
                (tie.untied.empty()
                     ? "if it had any,"
                     : std::to_string(tie.untied.back().node) + ", is " +
                           std::to_string(tie.untied.back().distance) + " away from its segment, which") +
                " is too far. Give a larger distance by negative SST and MST.");
  tie.holds.assign(tie.nodes.size(), 1);
  return tie;
}

/// Puts tied nodes onto their segments; those whose segments are moved by other ties go along, whatever the
/// order of the ties.
void put_onto_segments(const model::Model& model, domain::Domain& domain) {
  domain::NodeFields& nodes = domain.nodes;
  const AlignedArray<Vec3> before = nodes.position;
  bool moved = true;
  for (int round = 0; moved && round < tolerances::longest_chain_of_ties; ++round) {
    moved = false;
    for (const Tie& tie : domain.ties) {
      if (tie.method != model::TieMethod::Constraint) continue;
      for (const TiedNode& tied : tie.nodes) {
        Vec3 foot;
        for (std::size_t k = 0; k < 4; ++k) foot += tied.weight[k] * nodes.position[tied.corner[k]];
        moved = moved || norm(foot - nodes.position[tied.node]) > 0;
        nodes.position[tied.node] = nodes.reference[tied.node] = foot;
      }
    }
  }
  for (Tie& tie : domain.ties)
    for (const TiedNode& tied : tie.nodes) {
      const double move = norm(nodes.position[tied.node] - before[tied.node]);
      if (move <= tie.largest_move) continue;
      tie.largest_move = move;
      tie.moved_node = model.nodes.id[nodes.model_node[tied.node]];
    }
}

}  // namespace

void find_ties(const model::Model& model, domain::Domain& domain) {
  std::vector<char> taken(static_cast<std::size_t>(domain.nodes.count()), 0);
  domain.ties.resize(model.tied_contacts.size());
  // Gaps are measured when all that constraints move is in its place.
  for (const bool constraint : {true, false}) {
    for (std::size_t i = 0; i < model.tied_contacts.size(); ++i)
      if ((model.tied_contacts[i].method == model::TieMethod::Constraint) == constraint)
        domain.ties[i] = find_tie(model, domain, model.tied_contacts[i], taken);
    if (constraint) put_onto_segments(model, domain);
  }
}

}  // namespace crumple::contact
