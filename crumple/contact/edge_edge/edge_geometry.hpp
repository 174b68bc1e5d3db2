// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "base/index.hpp"
#include "contact/surface/segment_shape.hpp"
#include "math/vec3.hpp"

namespace crumple::contact {

/// The two domain nodes of an edge.
using EdgeNodes = std::array<Index, 2>;

struct EdgeShape {
  Vec3 start;  ///< [length]
  Vec3 end;    ///< [length]

  Vec3 along() const { return end - start; }
  Vec3 at(double fraction) const { return start + fraction * along(); }
};

/// The edge where its nodes are.
inline EdgeShape edge_shape(const EdgeNodes& nodes, const Configuration& x) {
  return {x[nodes[0]], x[nodes[1]]};
}

/// The points of two edges that are nearest to each other.
struct NearestOnEdges {
  std::array<double, 2> fraction{};  ///< of the way from the start to the end, of either edge; 0 to 1
  Vec3 away;                         ///< from the point of the second edge to that of the first [length]
  double distance = 0;               ///< [length]

  /// True if the point of that edge (0 or 1) lies between its ends.
  bool inside(int edge) const { return fraction[edge] > 0 && fraction[edge] < 1; }
  bool both_inside() const { return inside(0) && inside(1); }
};

/// In closed form (C. Ericson, Real-Time Collision Detection, 2005, section 5.1.9). Of parallel edges one of
/// the nearest pairs of points.
NearestOnEdges nearest_points(const EdgeShape& first, const EdgeShape& second);

/// Fraction of the way from start to end of the point of an edge that is nearest to `p`, 0 to 1.
double nearest_fraction(const EdgeShape& edge, const Vec3& p);

/// Sine of the angle between two edges; 0 if one has no length.
double sine_between(const EdgeShape& first, const EdgeShape& second);

/// Six times the volume of the tetrahedron of the four ends. Its sign tells on which side of the second edge
/// the first one passes: as `away` times the product of the two directions.
double signed_volume(const EdgeShape& first, const EdgeShape& second);

/// If two edges went through each other in the step that led to `now`, in which all nodes moved along
/// straight lines: the unit vector, perpendicular to both as they are now, that points to the side of the
/// second edge from which the first one came. Zero if they did not, or went back again. `step` is the length
/// of the step [time].
Vec3 passed_from(const EdgeNodes& first, const EdgeNodes& second, const Configuration& now, double step);

/// Bound on the distance that any points of two edges moved relative to each other in a step [length].
double relative_motion(const EdgeNodes& first, const EdgeNodes& second, const Vec3* velocity, double step);

}  // namespace crumple::contact
