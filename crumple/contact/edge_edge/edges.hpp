// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/index.hpp"
#include "contact/edge_edge/edge_geometry.hpp"
#include "contact/surface/beams.hpp"
#include "contact/surface/sides.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// The edges of a contact: those of its shells and the sharp ones of its solids, whether they take part or
/// not, and its beams. A beam along the edge of a shell and that edge are one. Numbers never change; what
/// takes part changes when elements erode, see refresh().
struct Edges {
  std::vector<Index> nodes;  ///< two domain nodes per edge, the lower first; edges ascending
  std::vector<std::array<Index, 4>> of_segment;  ///< edge k of a segment, no_index where it has none
  std::vector<Index> first_segment;              ///< rows of segment_at_edge, and one past the last
  std::vector<Index> segment_at_edge;            ///< active or not, ascending in each row
  std::vector<std::uint8_t> sharp;  ///< 1 where two faces of solids meet in an edge that stands out
  std::vector<Index> body;          ///< rigid body that has both nodes, or no_index

  std::vector<std::uint8_t> side;      ///< of its segments and beams, bits as in Surface::node_side
  std::vector<std::uint8_t> active;    ///< 1 if it takes part now
  std::vector<std::uint8_t> bare;      ///< 1 of a beam with no segment at it, whose ends no node search sees
  std::vector<double> half_thickness;  ///< the largest of its segments, or the radius of its beam [length]
  std::vector<double> stiffness;       ///< smallest of its segments and beams [force/length]
  std::vector<double> height;          ///< of the solids at it, 0 of others [length]
  std::vector<double> area;            ///< likewise; of a beam its length times its diameter [length^2]
  std::vector<UserId> id;              ///< of a shell or beam that it belongs to
  std::vector<Index> part;             ///< of that in the model, or no_index
  std::vector<Index> taking_part;      ///< the active ones, ascending
  std::vector<Index> first_at_node;    ///< rows of edge_at_node, by place in Surface::nodes
  std::vector<Index> edge_at_node;     ///< active ones, ascending in each row

  double mean_length = 0;             ///< over all edges, undeformed [length]
  double largest_half_thickness = 0;  ///< over all edges [length]

  Index count() const { return static_cast<Index>(body.size()); }
  EdgeNodes ends(Index edge) const {
    const std::size_t at = 2 * static_cast<std::size_t>(edge);
    return {nodes[at], nodes[at + 1]};
  }
  bool has(Index edge, Index node) const {
    const EdgeNodes own = ends(edge);
    return own[0] == node || own[1] == node;
  }
  bool share_node(Index one, Index other) const {
    const EdgeNodes own = ends(one);
    return has(other, own[0]) || has(other, own[1]);
  }
  /// True if one rigid body has both: they never move against each other.
  bool same_body(Index one, Index other) const { return body[one] != no_index && body[one] == body[other]; }
  /// True if they are on sides of the contact that touch each other, and neither of one rigid body nor tied.
  bool may_touch(const Surface& surface, Index one, Index other) const {
    return !same_body(one, other) && !joined(surface, one, other) &&
           ((touched_by(kind, side[one]) & side[other]) != 0 ||
            (touched_by(kind, side[other]) & side[one]) != 0);
  }
  /// True if a tied contact joins nodes of the two.
  bool joined(const Surface& surface, Index one, Index other) const {
    if (surface.joined.empty()) return false;
    const EdgeNodes own = ends(one);
    return std::any_of(own.begin(), own.end(), [&](Index node) {
      const auto others = surface.joined.of(surface.place[node]);
      return std::any_of(others.begin(), others.end(), [&](Index b) { return has(other, b); });
    });
  }
  double contact_distance(Index one, Index other) const {
    return half_thickness[one] + half_thickness[other];
  }
  /// Of the nearest points of two edges [length].
  double distance(Index one, Index other, const Configuration& x) const {
    return nearest_points(edge_shape(ends(one), x), edge_shape(ends(other), x)).distance;
  }
  std::span<const Index> segments_at(Index edge) const {
    return std::span(segment_at_edge)
        .subspan(first_segment[edge], first_segment[edge + 1] - first_segment[edge]);
  }
  /// Active edges at the node of that place.
  std::span<const Index> at_node(Index place) const {
    return std::span(edge_at_node)
        .subspan(first_at_node[place], first_at_node[place + 1] - first_at_node[place]);
  }
  /// True if the edges have nodes that an edge or a segment joins.
  bool next_neighbours(const Surface& surface, Index one, Index other) const;

  std::vector<ContactBeam> beams;
  std::vector<Index> edge_of_beam;
  model::ContactEdges which = model::ContactEdges::None;
  model::ContactKind kind = model::ContactKind::SingleSurface;
};

/// Collects the edges of the shells of the surface and the beams of the contact, whose nodes are nodes of the
/// surface.
Edges build_edges(const model::Model& model, const domain::Domain& domain, const model::Contact& contact,
                  const Surface& surface);

/// Finds out anew which edges take part, and what they have of their elements, after elements have eroded.
void refresh(Edges& edges, const Surface& surface, const domain::Domain& domain);

}  // namespace crumple::contact
