// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// What takes part in a contact: the shells as segments, their nodes, and what the contact needs to know of
/// them. Made at the start of the run; changes only when elements erode, see drop_eroded().
struct Surface {
  std::vector<Index> nodes;                 ///< domain nodes, ascending
  std::vector<Index> place;                 ///< place in `nodes` of a domain node, or no_index
  std::vector<double> node_half_thickness;  ///< largest of its segments, by place [length]
  std::vector<double> node_stiffness;       ///< smallest of its segments, by place [force/length]
  std::vector<UserId> node_id;              ///< by place

  std::vector<Index> connectivity;     ///< four domain nodes per segment; a triangle repeats its last node
  std::vector<double> half_thickness;  ///< contact thickness over two, per segment [length]
  std::vector<double> stiffness;       ///< penalty stiffness per segment [force/length]
  std::vector<UserId> segment_id;      ///< of the shell
  std::vector<std::uint8_t> active;    ///< 0 where the shell has eroded
  std::vector<Index> blocks;           ///< domain blocks whose shells are the segments, one after another
  Index eroded = 0;                    ///< number of segments that are not active

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
};

/// Collects the shells of the parts of `contact`. Contact thickness: the smaller of the true thickness times
/// SFST and 0.4 of the shortest edge, or SST where given (LS-DYNA's rule for single-surface contact).
/// Penalty stiffness: SLSFAC SFS K A / (largest diagonal), with bulk modulus K and area A of the reference
/// geometry (Hallquist, LS-DYNA Theory Manual, chapter on contact, shells). Throws Error if there is no
/// shell.
Surface build_surface(const model::Model& model, const domain::Domain& domain,
                      const model::SingleSurfaceContact& contact);

/// Takes segments out whose shells have eroded since the last call: they touch nothing any more, their free
/// edges become those of their neighbours, and a node left without any segment touches nothing, either.
/// Numbers of segments and places of nodes stay as they are. False if there was nothing to do, which costs
/// next to nothing.
bool drop_eroded(Surface& surface, const domain::Domain& domain);

}  // namespace crumple::contact
