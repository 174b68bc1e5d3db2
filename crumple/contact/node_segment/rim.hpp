// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The rim of a face of a solid: which nodes may go behind the face over it, and what a node behind the face
// feels that slides off over it.

#include "base/index.hpp"
#include "contact/enforcement/contact_pair.hpp"
#include "contact/node_segment/seam.hpp"
#include "contact/surface/nearest_segment.hpp"
#include "contact/surface/segment_shape.hpp"
#include "math/vec3.hpp"

namespace crumple::contact {

/// True if a face or shell of the node reaches in over the rim of a face, where that is nearest to the node:
/// one that faces it, if there are such. Else the node passes beside the face, though it comes behind its
/// plane. Nodes without any may be over the rim by round-off.
bool reaches_over_rim(const NodeAt& node, Index face, const SegmentShape& shape, const NearestPoint& nearest);

/// True if the node is on the plane of a face or in front of it, and right beside its rim: should it come
/// behind that plane, it came through the face. At a rim that stands out no normal of the surface tells.
bool stands_at_rim(const NodeAt& node, Index segment, const SegmentShape& shape, const NearestPoint& nearest);

/// Share s of its contact that a node behind a face keeps at the distance `beyond` its rim, along the face
/// [length]; `side`: root of the face's area [length]. It is 1 until tolerances::fades_beyond_rim of the side
/// and 0 from lost_beyond_rim on, and level at both.
double share_beyond_rim(double beyond, double side);

/// Turns the force on a node that slides off a face outwards, so that it has the potential s(b) U(d), with
/// the penetration d along the normal of the face and the distance b beyond its rim: what the spring holds
/// pushes the node off, as a round rim does, and is not lost (own derivation, docs/theory/contact.md).
/// `away`: from the nearest point of the face to the node [length].
void push_off_rim(const Vec3& away, const Vec3& normal, double side, ContactPair& pair);

}  // namespace crumple::contact
