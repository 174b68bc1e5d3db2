// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/index.hpp"
#include "contact/topology.hpp"
#include "domain/domain.hpp"
#include "math/vec3.hpp"
#include "model/model.hpp"

namespace crumple::contact {

using math::Vec3;

/// What takes part in a contact: the shells and the outer faces of the solids as segments, their nodes, and
/// what the contact needs to know of them. Made at the start of the run; changes only when elements erode,
/// see drop_eroded().
struct Surface {
  std::vector<Index> nodes;                 ///< domain nodes, ascending
  std::vector<Index> place;                 ///< place in `nodes` of a domain node, or no_index
  std::vector<double> node_half_thickness;  ///< largest of its segments, by place [length]
  std::vector<double> node_stiffness;       ///< smallest of its segments, by place [force/length]
  std::vector<UserId> node_id;              ///< by place

  std::vector<Index> connectivity;     ///< four domain nodes per segment; a triangle repeats its last node
  std::vector<double> half_thickness;  ///< contact thickness over two, per segment [length]
  std::vector<double> stiffness;       ///< penalty stiffness per segment [force/length]
  std::vector<double> area;            ///< of the reference geometry, per segment [length^2]
  std::vector<double> height;          ///< of a face that of its solid behind it; 0 of shells [length]
  std::vector<UserId> segment_id;      ///< of the shell or solid
  std::vector<std::uint8_t> of_solid;  ///< 1: a face of a solid, whose outside is the side of the normal
  /// Domain nodes of that solid, of faces alone: they are the first segments.
  std::vector<std::array<Index, 8>> solid_nodes;
  std::vector<std::uint8_t> active;  ///< 0 where the element has eroded
  std::vector<Index> block;          ///< of the element, in Domain::blocks()
  std::vector<Index> element;        ///< its place in the block
  std::vector<Index> segment_body;   ///< rigid body that has all nodes of the segment, or no_index
  std::vector<Index> node_body;      ///< rigid body of the node, by place, or no_index
  Index eroded = 0;                  ///< elements of the model that had failed at the last look

  double mean_edge = 0;               ///< over all segments [length]
  double largest_half_thickness = 0;  ///< [length]
  Topology topology;

  Index segments() const { return static_cast<Index>(segment_id.size()); }
  Index node_count() const { return static_cast<Index>(nodes.size()); }
  /// The four domain nodes of a segment.
  const Index* segment(Index s) const { return connectivity.data() + static_cast<std::size_t>(s) * 4; }
  /// True if the node of that place still belongs to a segment.
  bool bears(Index node_place) const { return !topology.at_node(node_place).empty(); }
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
  bool is_face(Index s) const { return of_solid[s] != 0; }
  /// Distance from which on a node in front of a face is remembered, before it touches; 0 of shells [length].
  double watch(Index s) const { return 0.1 * height[s]; }
  /// True if the domain node is one of the solid behind a face.
  bool solid_has(Index s, Index node) const {
    return std::find(solid_nodes[s].begin(), solid_nodes[s].end(), node) != solid_nodes[s].end();
  }
  /// True if one rigid body has both: they never move against each other.
  bool same_body(Index node_place, Index s) const {
    return segment_body[s] != no_index && segment_body[s] == node_body[node_place];
  }
};

/// Collects the shells and the outer faces of the solids of the parts of `contact`. Contact thickness of
/// shells: the smaller of the true thickness times SFST and 0.4 of the shortest edge, or SST where given
/// (LS-DYNA's rule for single-surface contact); faces have none. A face that a shell of the contact covers is
/// left to the shell. Penalty stiffness with bulk modulus K and area A of the reference geometry: SLSFAC SFS
/// K A / (largest diagonal) of shells, SLSFAC SFS K A^2 / V of faces of solids with the volume V (Hallquist,
/// LS-DYNA Theory Manual, chapter on contact). Throws Error if there is no segment.
Surface build_surface(const model::Model& model, const domain::Domain& domain,
                      const model::SingleSurfaceContact& contact);

/// Takes segments out whose elements have eroded since the last call: they touch nothing any more, their free
/// edges become those of their neighbours, and a node left without any segment touches nothing, either.
/// Numbers of segments and places of nodes stay as they are. False if there was nothing to do, which costs
/// next to nothing.
bool drop_eroded(Surface& surface, const domain::Domain& domain);

}  // namespace crumple::contact
