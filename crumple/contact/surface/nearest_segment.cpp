// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/nearest_segment.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

/// Segments of a leaf.
constexpr Index most_in_leaf = 4;

double squared(double a) {
  return a * a;
}

}  // namespace

NearestSegment::NearestSegment(const Surface& surface, const Configuration& x, std::vector<Index> segments)
    : surface_(&surface),
      x_(x),
      segments_(std::move(segments)),
      centre_(static_cast<std::size_t>(surface.segments())) {
  for (const Index segment : segments_) centre_[segment] = shape_of(surface, x_, segment).centre;
  branches_.reserve(segments_.size());
  if (!segments_.empty()) build(0, static_cast<Index>(segments_.size()));
}

NearestSegment::Box NearestSegment::box_of(Index segment) const {
  Box box;
  const Index* nodes = surface_->segment(segment);
  box.low = box.high = x_[nodes[0]];
  for (int k = 1; k < 4; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], x_[nodes[k]][axis]);
      box.high[axis] = std::max(box.high[axis], x_[nodes[k]][axis]);
    }
  return box;
}

Index NearestSegment::build(Index first, Index last) {
  const auto here = static_cast<Index>(branches_.size());
  Branch branch;
  branch.first = first;
  branch.last = last;
  branch.box = box_of(segments_[first]);
  for (Index i = first + 1; i < last; ++i) {
    const Box box = box_of(segments_[i]);
    for (int axis = 0; axis < 3; ++axis) {
      branch.box.low[axis] = std::min(branch.box.low[axis], box.low[axis]);
      branch.box.high[axis] = std::max(branch.box.high[axis], box.high[axis]);
    }
  }
  branches_.push_back(branch);
  if (last - first <= most_in_leaf) return here;
  const Vec3 size = branch.box.high - branch.box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto before = [&](Index a, Index b) {
    const double of_a = centre_[a][axis];
    const double of_b = centre_[b][axis];
    return of_a != of_b ? of_a < of_b : a < b;
  };
  const Index middle = first + (last - first) / 2;
  std::nth_element(segments_.begin() + first, segments_.begin() + middle, segments_.begin() + last, before);
  build(first, middle);
  const Index right = build(middle, last);
  branches_[here].right = right;
  return here;
}

/// Squared, of a point from the box.
double NearestSegment::distance_to(Index branch, const Vec3& p) const {
  const Box& box = branches_[branch].box;
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis)
    sum += squared(std::max({0.0, box.low[axis] - p[axis], p[axis] - box.high[axis]}));
  return sum;
}

NearestSegment::Found NearestSegment::nearest(Index node) const {
  Found best;
  if (branches_.empty()) return best;
  const Vec3 p = x_[node];
  std::vector<Index> open{0};
  while (!open.empty()) {
    const Index at = open.back();
    open.pop_back();
    const Branch& branch = branches_[at];
    if (best.segment != no_index && distance_to(at, p) > best.nearest.distance_squared) continue;
    if (branch.right == no_index) {
      for (Index i = branch.first; i < branch.last; ++i) {
        if (surface_->owns(segments_[i], node)) continue;
        const NearestPoint found = nearest_point(shape_of(*surface_, x_, segments_[i]), p);
        if (best.segment == no_index || found.distance_squared < best.nearest.distance_squared)
          best = {segments_[i], found};
      }
      continue;
    }
    // The nearer half is looked at first.
    const Index left = at + 1;
    const bool left_first = distance_to(left, p) <= distance_to(branch.right, p);
    open.push_back(left_first ? branch.right : left);
    open.push_back(left_first ? left : branch.right);
  }
  return best;
}

/// Least where a segment faces the normal.
double NearestSegment::facing(Index segment, const Vec3& normal, bool face) const {
  const Vec3 own = area_normal(shape_of(*surface_, x_, segment));
  const double size = norm(own);
  const double along = size > 0 ? dot(own, normal) / size : 0;
  return face && surface_->is_face(segment) ? along : -std::fabs(along);
}

NearestSegment::Found NearestSegment::find(Index node, const Vec3& normal, bool face) const {
  Found best = nearest(node);
  if (best.segment == no_index) return best;
  const Vec3 p = x_[node];
  const Box box = box_of(best.segment);
  const Vec3 size = box.high - box.low;
  const double limit = best.nearest.distance_squared + tolerances::equally_near_squared * dot(size, size);
  double least = facing(best.segment, normal, face);
  std::vector<Index> open{0};
  while (!open.empty()) {
    const Index at = open.back();
    open.pop_back();
    const Branch& branch = branches_[at];
    if (distance_to(at, p) > limit) continue;
    if (branch.right != no_index) {
      open.push_back(branch.right);
      open.push_back(at + 1);
      continue;
    }
    for (Index i = branch.first; i < branch.last; ++i) {
      const Index segment = segments_[i];
      if (surface_->owns(segment, node)) continue;
      const double here = facing(segment, normal, face);
      if (here > least || (here == least && segment >= best.segment)) continue;
      const NearestPoint found = nearest_point(shape_of(*surface_, x_, segment), p);
      if (found.distance_squared > limit) continue;
      best = {segment, found};
      least = here;
    }
  }
  return best;
}

}  // namespace crumple::contact
