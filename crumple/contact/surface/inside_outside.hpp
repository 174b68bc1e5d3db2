// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"
#include "contact/surface/segment_shape.hpp"
#include "contact/surface/surface.hpp"

// Which segment a node belongs to, and on which side of the surface it is, from the mesh normals at the
// edges. Our reconstruction of the inside-outside algorithm of S.P. Wang & E. Nakamachi, Int. J. Numer. Meth.
// Engng 40 (1997) 3665-3685, extended to shells: docs/theory/contact.md has the definitions with pictures.

namespace crumple::contact {

/// The geometry that all these functions look at.
struct SurfaceAt {
  const Surface* surface = nullptr;
  Configuration x;

  SegmentShape shape(Index segment) const { return shape_of(*surface, x, segment); }
};

/// Mesh normal at edge k of a segment: the normalised sum of the unit normals of the sub-triangles that meet
/// there; the segment's own one at a free edge or junction. Points to the segment's positive side. In a fold
/// sharper than a right angle, where the sum degenerates, the same direction is taken from the bisector of
/// the two triangles; folded flat, it points away from the segments. `shape`: that of the segment.
Vec3 mesh_normal(const SurfaceAt& at, Index segment, const SegmentShape& shape, int k);

/// Signed place of `p` between a segment and its neighbour across shared edge k: positive on the segment's
/// side of the dividing plane, which holds the edge and the mesh normal, negative on the neighbour's
/// [length]. The neighbour sees the same number with the opposite sign, to the last bit. Zero on the plane,
/// and where the two are folded onto each other.
double inner_side(const SurfaceAt& at, Index segment, int k, const Vec3& p);

/// True if `p` is on the inner side of the dividing planes at all shared edges of the segment.
bool inside(const SurfaceAt& at, Index segment, const Vec3& p);

/// Direction that tells the sides of the surface apart at a point of a segment, for a node `away` from that
/// point: the normal of the sub-triangle on the face, the mesh normal at a shared edge, around a smooth node
/// the normal of the sub-triangle that `away` meets most squarely; zero where the surface is round (free
/// edge, junction, their nodes) and has no sides. A unit vector otherwise. `shape`: that of the segment.
Vec3 side_normal(const SurfaceAt& at, Index segment, const SegmentShape& shape, const NearestPoint& nearest,
                 const Vec3& away);

/// Normalised sum of the unit normals of the segments at a domain node of the surface, each on the side of
/// `side`.
Vec3 corner_normal(const SurfaceAt& at, Index node, const Vec3& side);

/// True unless the surface comes nearer to `node` just beyond the edge or corner of the segment where the
/// nearest point is: then the contact is the neighbour's. A node's own segment always is nearer.
bool nearest_around(const SurfaceAt& at, Index node, Index segment, const NearestPoint& nearest);

/// True if two segments have a node in common.
bool connected(const Surface& surface, Index a, Index b);

/// True if two segments have a node in common at which or an edge over which the surface is smooth, so that
/// the positive side of one is the positive side of the other.
bool same_sides(const Surface& surface, Index a, Index b);

/// For a point above two connected segments: true if segment `a` owns it, by the dividing plane of their
/// common edge; where they have none, or the point is on it, the nearer one, then the lower one.
bool owns_first(const SurfaceAt& at, Index a, Index b, const Vec3& p, double distance_a, double distance_b);

}  // namespace crumple::contact
