// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/index.hpp"
#include "contact/surface/segment_shape.hpp"
#include "contact/surface/surface.hpp"

namespace crumple::contact {

/// Finds the nearest of some segments to a point, however far away it is: a tree of bounding boxes, halved at
/// the median of their centres (J.L. Bentley, Comm. ACM 18 (1975) 509-517, the k-d tree, for boxes).
/// Building costs O(N log^2 N), a question O(log N) for points near the surface. Coordinates are those of the
/// time of building.
class NearestSegment {
 public:
  /// `surface` and the positions that `x` looks at must outlive this object.
  NearestSegment(const Surface& surface, const Configuration& x, std::vector<Index> segments);

  struct Found {
    Index segment = no_index;
    NearestPoint nearest{};
  };

  /// The nearest segment that does not have the domain node `node`. Of equally near ones, as beside a common
  /// edge, the one that faces `normal` most squarely: a face of a solid from its outside, a shell from any
  /// side; then the lowest. `face` says that the normal is the outward one of a solid, too. Its number is
  /// no_index if there is none.
  Found find(Index node, const Vec3& normal, bool face) const;

 private:
  struct Box {
    Vec3 low;
    Vec3 high;
  };
  struct Branch {
    Box box;
    Index first = 0;  ///< segments of a leaf, in segments_
    Index last = 0;
    Index right = no_index;  ///< second half; the first half follows its parent; no_index: a leaf
  };

  Index build(Index first, Index last);
  Box box_of(Index segment) const;
  double distance_to(Index branch, const Vec3& p) const;
  double facing(Index segment, const Vec3& normal, bool face) const;
  Found nearest(Index node) const;

  const Surface* surface_;
  Configuration x_;
  std::vector<Index> segments_;
  std::vector<Vec3> centre_;  ///< by number of the segment
  std::vector<Branch> branches_;
};

}  // namespace crumple::contact
