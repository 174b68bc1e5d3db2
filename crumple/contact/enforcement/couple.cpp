// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/couple.hpp"

#include "contact/tolerances.hpp"

namespace crumple::contact {

Couple::Couple(std::span<const Vec3> nodes, Bearing bearing) {
  const std::size_t group = bearing == Bearing::All ? nodes.size() : nodes.size() / 2;
  std::array<Vec3, 2> mean;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    mean[i / group] += (1.0 / static_cast<double>(group)) * nodes[i];
  double xx = 0;
  double yy = 0;
  double zz = 0;
  double xy = 0;
  double yz = 0;
  double zx = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vec3 r = nodes[i] - mean[i / group];
    arm_[i] = r;
    xx += r.y * r.y + r.z * r.z;
    yy += r.z * r.z + r.x * r.x;
    zz += r.x * r.x + r.y * r.y;
    xy -= r.x * r.y;
    yz -= r.y * r.z;
    zx -= r.z * r.x;
  }
  const double cofactor_xx = yy * zz - yz * yz;
  const double cofactor_xy = yz * zx - xy * zz;
  const double cofactor_zx = xy * yz - yy * zx;
  const double determinant = xx * cofactor_xx + xy * cofactor_xy + zx * cofactor_zx;
  const double trace = xx + yy + zz;
  if (determinant <= tolerances::collinear * trace * trace * trace) return;
  const double scale = 1 / determinant;
  inverse_ = {scale * cofactor_xx, scale * (zz * xx - zx * zx), scale * (xx * yy - xy * xy),
              scale * cofactor_xy, scale * (xy * zx - xx * yz), scale * cofactor_zx};
}

Vec3 Couple::turn(const Vec3& moment) const {
  const auto& [xx, yy, zz, xy, yz, zx] = inverse_;
  return {xx * moment.x + xy * moment.y + zx * moment.z, xy * moment.x + yy * moment.y + yz * moment.z,
          zx * moment.x + yz * moment.y + zz * moment.z};
}

Couple::Forces Couple::forces(const Vec3& moment) const {
  const Vec3 a = turn(moment);
  Forces found;
  for (std::size_t i = 0; i < found.size(); ++i) found[i] = cross(a, arm_[i]);
  return found;
}

// The sum of the squares is m.J^-1.m with m = arm x f, at most the trace of that form in f.
double Couple::largest_square(const Vec3& arm) const {
  return dot(arm, arm) * (inverse_[0] + inverse_[1] + inverse_[2]) - dot(arm, turn(arm));
}

}  // namespace crumple::contact
