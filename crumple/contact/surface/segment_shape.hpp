// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "base/index.hpp"
#include "contact/surface/surface.hpp"
#include "math/vec3.hpp"

namespace crumple::contact {

/// Positions at time n, or `back` before: x - back v, with the velocities of the step that led to time n.
struct Configuration {
  const Vec3* position = nullptr;  ///< by domain node [length]
  const Vec3* velocity = nullptr;  ///< likewise [length/time]
  double back = 0;                 ///< [time]

  Vec3 operator[](Index node) const {
    return back == 0 ? position[node] : position[node] - back * velocity[node];
  }
};

/// The mid-surface of a segment: a triangle, or a quadrilateral as the four flat triangles that join its
/// edges to the mean of its corners. The surface is continuous from segment to segment, warped or not, and
/// the nearest point is found in closed form (own choice). Sub-triangle k stands on edge k.
struct SegmentShape {
  std::array<Vec3, 4> corner;  ///< the last of a triangle is the third [length]
  Vec3 centre;                 ///< [length]
  bool triangle = false;
};

/// The segment where its nodes are.
inline SegmentShape shape_of(const Surface& surface, const Configuration& x, Index segment) {
  SegmentShape shape;
  const Index* nodes = surface.segment(segment);
  for (int k = 0; k < 4; ++k) shape.corner[k] = x[nodes[k]];
  shape.triangle = nodes[2] == nodes[3];
  shape.centre = shape.triangle
                     ? (1.0 / 3.0) * (shape.corner[0] + shape.corner[1] + shape.corner[2])
                     : 0.25 * ((shape.corner[0] + shape.corner[1]) + (shape.corner[2] + shape.corner[3]));
  return shape;
}

/// Where on a segment a point was found.
enum class Feature {
  Face,
  Edge,
  Corner,
};

/// The point of a segment that is nearest to a given one.
struct NearestPoint {
  Vec3 point;                    ///< sum of weight[i] corner[i] [length]
  std::array<double, 4> weight;  ///< of the four nodes; their sum is 1
  double distance_squared = 0;   ///< [length^2]
  Feature feature = Feature::Face;
  int local = 0;  ///< number of the edge or corner within the segment, on the face of the sub-triangle
};

/// Weights of the corners of a triangle; exactly zero where the nearest point is on its rim.
struct Barycentric {
  double a = 0;
  double b = 0;
  double c = 0;
};

/// The nearest point of a quadrilateral, if it is on sub-triangle `k` with these weights: two of its corners
/// and the centre.
NearestPoint nearest_on(int k, const Barycentric& weight, const Vec3& point, double distance_squared);

/// Nearest point of the segment to `p`; of several equally near ones that of the lowest sub-triangle. The
/// nearest point of a triangle follows from the regions of its corners, edges and face (C. Ericson,
/// Real-Time Collision Detection, 2005, section 5.1.5).
NearestPoint nearest_point(const SegmentShape& shape, const Vec3& p);

/// Distance of a point of the segment from the nearest of its edges [length].
double distance_to_edges(const SegmentShape& shape, const Vec3& point);

/// Normal of the segment as a whole, its length twice the projected area: the product of the diagonals.
inline Vec3 area_normal(const SegmentShape& shape) {
  return cross(shape.corner[2] - shape.corner[0], shape.corner[3] - shape.corner[1]);
}

/// Axes that turn with the segment: the first along edge 0, the third along the normal. Zero until known.
struct Frame {
  Vec3 first;
  Vec3 second;
  Vec3 third;

  bool is_known() const { return dot(third, third) > 0; }
  Vec3 to_local(const Vec3& a) const { return {dot(a, first), dot(a, second), dot(a, third)}; }
  Vec3 to_global(const Vec3& a) const { return a.x * first + a.y * second + a.z * third; }
};

/// Axes that turn with a segment: along its first edge, across it, and along its normal.
Frame frame_of(const SegmentShape& shape);

}  // namespace crumple::contact
