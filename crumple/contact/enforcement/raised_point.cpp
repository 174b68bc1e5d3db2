// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/raised_point.hpp"

namespace crumple::contact {

std::array<Vec3, 4> turning_forces(std::span<const Vec3> corner, double height, const Vec3& force) {
  const std::size_t last = corner.size() - 1;
  const Vec3 d1 = corner[2] - corner[0];
  const Vec3 d2 = corner[last] - corner[1];
  const Vec3 area = cross(d1, d2);
  const double size = norm(area);
  std::array<Vec3, 4> forces{};
  if (!(size > 0)) return forces;
  const Vec3 normal = (1 / size) * area;
  const Vec3 along = (height / size) * (force - dot(force, normal) * normal);
  const Vec3 on_d1 = cross(d2, along);
  const Vec3 on_d2 = cross(along, d1);
  forces[0] -= on_d1;
  forces[1] -= on_d2;
  forces[2] += on_d1;
  forces[last] += on_d2;
  return forces;
}

}  // namespace crumple::contact
