// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The surface of a contact: what can touch and be touched, with the geometry that all detectors share.
//
//     shells            segments on their mid-surface, with two sides and a thickness
//     faces of solids   segments with an outside, without thickness unless SLDTHK gives one; those between
//                       two solids sleep until the one in front has eroded
//     nodes             those of the segments, of beams, and nodes that are named one by one
//
//     corner 3         corner 2     A quadrilateral is four flat triangles from its edges to the mean c of
//            o---------o            its corners, a triangle is itself. The surface is continuous from
//            |\   2   /|            segment to segment, warped or not, and the nearest point on it follows
//            |  \   /  |            in closed form (segment_shape.hpp): C. Ericson, Real-Time Collision
//            | 3  c  1 |            Detection, 2005, 5.1.5.
//            |  /   \  |
//            |/   0   \|            Edges are shared by two segments that are oriented alike, free, or
//            o---------o            junctions of three and more (topology.hpp).
//     corner 0         corner 1
//
// Thickness, stiffness and orientation are those of the undeformed mesh, after LS-DYNA's rules where its
// manuals give them (segment_collector.hpp, orientation.hpp, sides.hpp).
//
// Files for geometry: inside_outside.hpp has mesh normals, dividing planes and which side of a surface a node
// is on; crossing.hpp whether it went through in a step; nearest_point_kernel.hpp the nearest point for many
// lanes; nearest_segment.hpp the nearest of many segments; kinematics.hpp the motion that a detector is
// given.
//
// Order of calls: build_surface() once, follow_erosion() before the search of every step. Indices of segments
// and nodes never change; erosion switches segments off and on (`active`).

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/index.hpp"
#include "contact/surface/joined_nodes.hpp"
#include "contact/surface/topology.hpp"
#include "contact/tolerances.hpp"
#include "domain/domain.hpp"
#include "math/vec3.hpp"
#include "model/model.hpp"

namespace crumple::contact {

using math::Vec3;

/// An element, by its block in Domain::blocks() and its place there.
struct ElementPlace {
  Index block = no_index;
  Index element = no_index;

  bool exists() const { return block != no_index; }
};

/// A beam whose nodes take part in a contact whether they have segments or not.
struct SurfaceBeam {
  std::array<Index, 2> node{};  ///< places in Surface::nodes
  ElementPlace place;
  double radius = 0;      ///< [length]
  double stiffness = 0;   ///< [force/length]
  Index part = no_index;  ///< of the model
};

/// Of tetrahedra with ten.
inline constexpr std::size_t most_nodes_of_solid = 10;

/// What takes part in a contact: the shells and the faces of the solids as segments, their nodes and nodes
/// without segments, and what the contact needs to know of them. Made at the start of the run; changes only
/// when elements erode or ties end, see follow_erosion(). A face is a segment with an outside, the side of
/// its normal: the face of a solid, or any segment of a contact with orientation.
struct Surface {
  std::vector<Index> nodes;                 ///< domain nodes, ascending
  std::vector<Index> place;                 ///< place in `nodes` of a domain node, or no_index
  std::vector<double> node_half_thickness;  ///< largest of its segments, by place [length]
  std::vector<double> node_stiffness;       ///< smallest of its segments, by place [force/length]
  std::vector<UserId> node_id;              ///< by place
  std::vector<std::uint8_t> node_side;      ///< bits: 1 on the first side of the contact, 2 on the second
  std::vector<std::uint8_t> lone;           ///< 1: takes part without a segment, by place
  std::vector<double> lone_half_thickness;  ///< of nodes without a segment and of beams, else 0 [length]
  std::vector<double> lone_stiffness;       ///< of nodes of beams, else the largest number [force/length]
  std::vector<SurfaceBeam> beams;           ///< none where nodes are named one by one
  std::vector<Index> node_part;  ///< part of the model, by place, or no_index: see parts_of_nodes()
  std::vector<Index> node_body;  ///< rigid body of the node, by place, or no_index

  std::vector<Index> connectivity;     ///< four domain nodes per segment; a triangle repeats its last node
  std::vector<double> half_thickness;  ///< contact thickness over two, per segment [length]
  std::vector<double> stiffness;       ///< penalty stiffness per segment [force/length]
  std::vector<double> area;            ///< of the reference geometry, per segment [length^2]
  std::vector<double> height;  ///< of a face that of its solid, or the root of its area; 0 of others [length]
  std::vector<UserId> segment_id;      ///< of the shell or solid
  std::vector<Index> segment_part;     ///< part of the model that it belongs to
  std::vector<std::uint8_t> face;      ///< 1: a face, whose outside is the side of the normal
  std::vector<double> release_depth;   ///< overlap from which on a node is let go [length]
  std::vector<std::uint8_t> of_solid;  ///< 1: of a solid, 0: of a shell
  std::vector<std::uint8_t>
      crushable;  ///< 1: of a solid whose material is crushed, see model::is_crushable()
  std::vector<std::uint8_t> segment_side;  ///< sides of the contact that it is on, bits as in node_side
  std::vector<std::uint8_t> touched_by;    ///< sides of the nodes that may touch it, bits as in node_side
  /// Domain nodes of the element behind, of faces alone: they are the first segments.
  std::vector<std::array<Index, most_nodes_of_solid>> nodes_behind;
  std::vector<ElementPlace> behind;  ///< the element that the segment belongs to
  std::vector<ElementPlace> ahead;   ///< the element that hides it as long as it has not eroded
  std::vector<std::uint8_t> active;  ///< 1 if the element behind is there and the one ahead is not
  std::vector<Index> segment_body;   ///< rigid body that has all nodes of the segment, or no_index
  std::vector<Index>
      node_weld;           ///< spot weld that holds the node now, by place, or no_index; empty without welds
  Index broken_welds = 0;  ///< at the last look
  JoinedNodes joined;      ///< by tied contacts
  bool some_crushable = false;  ///< there are such segments
  bool some_inactive = false;   ///< there are segments or nodes that touch nothing now
  Index eroded = 0;             ///< elements of the model that had failed at the last look

  double mean_edge = 0;               ///< over all segments [length]
  double largest_half_thickness = 0;  ///< [length]
  domain::ThicknessCut thickness_cut;
  Topology topology;

  Index segments() const { return static_cast<Index>(segment_id.size()); }
  Index node_count() const { return static_cast<Index>(nodes.size()); }
  /// The four domain nodes of a segment.
  const Index* segment(Index s) const { return connectivity.data() + static_cast<std::size_t>(s) * 4; }
  /// True if the node of that place takes part now: it belongs to a segment or stands alone.
  bool bears(Index node_place) const {
    return lone[node_place] != 0 || !topology.at_node(node_place).empty();
  }
  bool is_triangle(Index s) const { return segment(s)[2] == segment(s)[3]; }
  /// True if the domain node is one of the segment's.
  bool owns(Index s, Index node) const {
    const Index* own = segment(s);
    return own[0] == node || own[1] == node || own[2] == node || own[3] == node;
  }
  /// Distance at which a node and a segment begin to touch [length].
  double contact_distance(Index node_place, Index s) const {
    return node_half_thickness[node_place] + half_thickness[s];
  }
  bool is_face(Index s) const { return face[s] != 0; }
  /// Distance from which on a node in front of a face is remembered, before it touches; 0 of shells [length].
  double watch(Index s) const { return tolerances::watch_over_height * height[s]; }
  /// True if the domain node is one of the element behind a face.
  bool behind_has(Index s, Index node) const {
    return std::find(nodes_behind[s].begin(), nodes_behind[s].end(), node) != nodes_behind[s].end();
  }
  /// True if node and segment are on sides of the contact that touch each other.
  bool on_touching_sides(Index node_place, Index s) const {
    return (node_side[node_place] & touched_by[s]) != 0;
  }
  /// True if a weld holds the node and one of the segment's: it keeps them at their distance, while the rest
  /// of the segment turns about the partner.
  bool welded(Index node_place, Index s) const {
    if (node_weld.empty() || node_weld[node_place] == no_index) return false;
    const Index* own = segment(s);
    return std::any_of(own, own + 4,
                       [&](Index node) { return node_weld[place[node]] == node_weld[node_place]; });
  }
  /// True if a tied contact joins the node to one of the segment's, as if an element had both.
  bool joined_to(Index node_place, Index s) const {
    if (joined.empty()) return false;
    const auto others = joined.of(node_place);
    return std::any_of(others.begin(), others.end(), [&](Index node) { return owns(s, node); });
  }
  /// True if, besides, they are not of one rigid body, which never moves against itself, welded nor tied.
  bool may_touch(Index node_place, Index s) const {
    return on_touching_sides(node_place, s) &&
           (segment_body[s] == no_index || segment_body[s] != node_body[node_place]) &&
           !welded(node_place, s) && !joined_to(node_place, s);
  }
};

/// Collects segments and nodes of both sides of the contact. Throws Error if nothing can touch.
Surface build_surface(const model::Model& model, const domain::Domain& domain, const model::Contact& contact);

/// Takes segments out whose elements have eroded since the last call, and in those that eroded ones have
/// hidden; nodes whose weld has broken or whose tie has ended may touch their partners' segments from then
/// on. `contact` is the id of the surface's contact. A segment that is out touches nothing any more, its free
/// edges become those of its neighbours, and a node left without any segment touches nothing, either. Numbers
/// of segments and places of nodes stay as they are. False if there was nothing to do, which costs next to
/// nothing.
bool follow_erosion(Surface& surface, const domain::Domain& domain, UserId contact);

}  // namespace crumple::contact
