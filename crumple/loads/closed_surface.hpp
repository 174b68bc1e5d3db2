// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "base/index.hpp"
#include "domain/node_fields.hpp"
#include "math/vec3.hpp"

namespace crumple::loads {

/// A closed surface of bilinear segments, the volume in it and the gradient of the volume with respect to the
/// places of its nodes: what a unit of pressure inside puts on them, so that pressure times the growth of the
/// volume is the work of these forces. Both are exact for the bilinear surface, and do not depend on where
/// the origin is (docs/theory/airbags.md). Sums are in an order that no number of threads changes.
class ClosedSurface {
 public:
  /// Segments in nodes of the domain, counter-clockwise from outside; a triangle repeats its third one.
  explicit ClosedSurface(const std::vector<std::array<Index, 4>>& segments);

  /// Finds volume, area and gradients for the nodes' present positions.
  void measure(const domain::NodeFields& fields, int threads);

  double volume() const { return volume_; }  ///< [length^3]
  double area() const { return area_; }      ///< sum of the sizes of the vector areas [length^2]

  const std::vector<Index>& nodes() const { return nodes_; }  ///< domain nodes, ascending
  /// Gradient with respect to the place of each of nodes() [length^2].
  const std::vector<math::Vec3>& gradients() const { return gradients_; }

 private:
  std::vector<std::array<Index, 4>> segments_;
  std::vector<Index> nodes_;
  std::vector<Index> first_corner_;               ///< of each node, into corners_; one more than nodes
  std::vector<Index> corners_;                    ///< 4 times the segment plus the corner
  std::vector<std::array<math::Vec3, 4>> parts_;  ///< of the gradients, by segment and corner
  std::vector<math::Vec3> gradients_;
  std::vector<std::array<double, 2>> sums_;  ///< volume and area of each piece of segments
  double volume_ = 0;
  double area_ = 0;
};

/// Sum of the sizes of the segments' vector areas; the same for any number of threads [length^2].
double present_area(const std::vector<std::array<Index, 4>>& segments, const domain::NodeFields& fields,
                    int threads);

/// Integral of a corner's shape function times the normal over a bilinear segment, for each corner
/// [length^2]. Their sum is the vector area.
std::array<math::Vec3, 4> corner_areas(const std::array<math::Vec3, 4>& x, bool is_triangle);

}  // namespace crumple::loads
