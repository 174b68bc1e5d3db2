// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/triangle_inertia.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::elements {

namespace {

using math::Vec3;
struct InPlane {
  double x = 0, y = 0;
};

/// Corners in the plane of the triangle.
std::array<InPlane, 3> in_plane(const std::array<Vec3, 3>& corner) {
  const Vec3 along = normalised(corner[1] - corner[0]);
  const Vec3 normal = normalised(cross(corner[1] - corner[0], corner[2] - corner[0]));
  const Vec3 across = cross(normal, along);
  std::array<InPlane, 3> flat;
  for (std::size_t i = 0; i < 3; ++i)
    flat[i] = {dot(corner[i] - corner[0], along), dot(corner[i] - corner[0], across)};
  return flat;
}

/// Velocity w across the plane and angular velocities of the three nodes.
struct NodeMotion {
  std::array<double, 3> w{}, about_x{}, about_y{};
};

/// Transverse shear rates of the element: the kinematics of shell/triangle.hpp.
InPlane shear(const std::array<InPlane, 3>& p, const NodeMotion& now) {
  const auto along = [&](std::size_t i, std::size_t j) {
    return now.w[j] - now.w[i] + 0.5 * (p[j].x - p[i].x) * (now.about_y[i] + now.about_y[j]) -
           0.5 * (p[j].y - p[i].y) * (now.about_x[i] + now.about_x[j]);
  };
  const double g12 = along(0, 1);
  const double g13 = along(0, 2);
  const double c = (g13 - along(1, 2) - g12) / 3;
  const double g31 = g13 - c;
  const double g32 = g13 - g12 - 2 * c;
  const double x31 = p[2].x - p[0].x;
  const double y31 = p[2].y - p[0].y;
  const double x32 = p[2].x - p[1].x;
  const double y32 = p[2].y - p[1].y;
  const double twice_area = x31 * y32 - x32 * y31;
  return {(y32 * g31 - y31 * g32) / twice_area, (x31 * g32 - x32 * g31) / twice_area};
}

/// Largest eigenvalue of a sum of dyads.
class DyadSum {
 public:
  void add(const InPlane& v) {
    xx_ += v.x * v.x;
    yy_ += v.y * v.y;
    xy_ += v.x * v.y;
  }
  double largest() const {
    return 0.5 * (xx_ + yy_) + std::sqrt(0.25 * (xx_ - yy_) * (xx_ - yy_) + xy_ * xy_);
  }

 private:
  double xx_ = 0, yy_ = 0, xy_ = 0;
};

}  // namespace

double triangle_inertia(const std::array<Vec3, 3>& corner, double own, double shear_speed, double rate) {
  const std::array<InPlane, 3> flat = in_plane(corner);
  DyadSum of_motion;
  DyadSum of_turning;
  for (std::size_t node = 0; node < 3; ++node) {
    NodeMotion moves;
    moves.w[node] = 1;
    of_motion.add(shear(flat, moves));
    NodeMotion turns;
    turns.about_x[node] = 1;
    of_turning.add(shear(flat, turns));
    turns = {};
    turns.about_y[node] = 1;
    of_turning.add(shear(flat, turns));
  }
  // A node has a third of the mass.
  const double factor = 3 * shear_speed * shear_speed / rate;
  constexpr double least = 0.1;
  return (own + factor * of_turning.largest()) / std::max(1 - factor * of_motion.largest(), least);
}

}  // namespace crumple::elements
