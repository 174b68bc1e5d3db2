// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Seams: where the faces of two bodies go on as each other, side by side, without a common node.
//
//             m o--->             m slides on A, deep in it by what its penalty needs. At the seam it comes
//     A                 B         behind B's side B', too, but never was in the space in front of that: there
//     --------o  o--------        is A's body, which bears it. So it does not enter B', and B takes it over
//             |  |                from A as if both were one surface.
//          A' |  | B'             The other way round the rim node of B does not enter the front of what
//                                 slides: B', the only face that it could do so with, faces A's body.
//
// A seam is no wider than A holds a node beyond its rim (tolerances::lost_beyond_rim). B is no higher than A
// by more than m is deep in A and what counts as being right at a rim (tolerances::beside_rim). Higher ones
// are steps, and stop what slides.

#include <span>

#include "base/index.hpp"
#include "contact/enforcement/contact_pair.hpp"
#include "contact/surface/inside_outside.hpp"

namespace crumple::contact {

/// A node and the step that led to where it is.
struct NodeAt {
  const SurfaceAt* now = nullptr;
  Index place = no_index;  ///< in Surface::nodes
  double step = 0;         ///< [time]
};

/// True if face `b` goes on over a seam where the node is as face `a` does. The faces have no node in common.
bool goes_on_over_seam(const NodeAt& node, Index a, Index b);

/// By how much the node is deeper behind face `b` than behind face `a`; zero if it is not [length].
double deeper_by(const NodeAt& node, Index a, Index b);

/// True if one of the candidates of a node that is beyond the rim of face `a` has it right behind, and goes
/// on over a seam as `a` does.
bool is_taken_over_seam(const NodeAt& node, Index a, std::span<const Index> candidates);

/// True if a node that has just come behind face `side` came there through a seam at its rim, out of a face
/// that bore it (`remembered`: its pairs of the step before): it was not in front of `side`.
bool passes_side(const NodeAt& node, Index side, std::span<const Index> candidates,
                 std::span<const RememberedPair> remembered);

/// True if a node that has just come behind face `front` is at the rim of a seam, and all of its own faces
/// that could meet `front` face the body beyond the seam: it goes under the face beside `front`. O(segments)
/// if the node may not touch the segments of its own side.
bool passes_front(const NodeAt& node, Index front, std::span<const Index> candidates);

}  // namespace crumple::contact
