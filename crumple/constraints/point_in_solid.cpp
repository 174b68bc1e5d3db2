// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/point_in_solid.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::constraints {
namespace {

using math::Vec3;

/// Natural coordinates this near to a face are on it [-]: decks round coordinates.
constexpr double on_a_face = 1e-8;
/// Distance of the point that Newton's method has found from the given one, over the size of the solid [-].
constexpr double found_within = 1e-9;
/// Steps of Newton's method: it halves its error where corners coincide, else it needs five or so.
constexpr int most_steps = 60;
/// Natural coordinates are kept between this and its opposite on the way.
constexpr double farthest = 2;

constexpr std::array<std::array<double, 3>, 8> natural = {
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

std::array<double, 8> trilinear(const Vec3& at) {
  std::array<double, 8> weight{};
  for (std::size_t k = 0; k < 8; ++k)
    weight[k] = 0.125 * (1 + natural[k][0] * at.x) * (1 + natural[k][1] * at.y) * (1 + natural[k][2] * at.z);
  return weight;
}

Vec3 mean(const std::array<Vec3, 8>& corner, const std::array<double, 8>& weight) {
  Vec3 sum;
  for (std::size_t k = 0; k < 8; ++k) sum += weight[k] * corner[k];
  return sum;
}

/// The derivatives of the map by the natural coordinates.
std::array<Vec3, 3> tangents(const std::array<Vec3, 8>& corner, const Vec3& at) {
  std::array<Vec3, 3> tangent;
  for (std::size_t k = 0; k < 8; ++k) {
    const double x = 1 + natural[k][0] * at.x;
    const double y = 1 + natural[k][1] * at.y;
    const double z = 1 + natural[k][2] * at.z;
    tangent[0] += (0.125 * natural[k][0] * y * z) * corner[k];
    tangent[1] += (0.125 * natural[k][1] * z * x) * corner[k];
    tangent[2] += (0.125 * natural[k][2] * x * y) * corner[k];
  }
  return tangent;
}

double largest(const Vec3& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// Natural coordinates of the point, or what Newton's method ends with.
Vec3 solve(const std::array<Vec3, 8>& corner, const Vec3& point) {
  constexpr double no_change = 1e-15;
  Vec3 at;
  for (int step = 0; step < most_steps; ++step) {
    const Vec3 gap = point - mean(corner, trilinear(at));
    const std::array<Vec3, 3> tangent = tangents(corner, at);
    const Vec3 yz = cross(tangent[1], tangent[2]);
    const double volume = dot(tangent[0], yz);
    if (volume == 0) break;
    const Vec3 change = (1 / volume) * Vec3{dot(gap, yz), dot(gap, cross(tangent[2], tangent[0])),
                                            dot(gap, cross(tangent[0], tangent[1]))};
    for (int axis = 0; axis < 3; ++axis) at[axis] = std::clamp(at[axis] + change[axis], -farthest, farthest);
    if (largest(change) < no_change) break;
  }
  return at;
}

}  // namespace

std::optional<PointInSolid<8>> point_in_hexahedron(const std::array<Vec3, 8>& corner, const Vec3& point) {
  Vec3 at = solve(corner, point);
  for (int axis = 0; axis < 3; ++axis)
    if (std::fabs(std::fabs(at[axis]) - 1) < on_a_face) at[axis] = std::copysign(1.0, at[axis]);
  PointInSolid<8> found;
  found.weight = trilinear(at);
  found.beyond = std::max(0.0, largest(at) - 1);
  double size = 0;
  for (const Vec3& x : corner) size = std::max(size, norm(x - corner[0]));
  // What was put on a face may be off by as much as that.
  if (!(norm(mean(corner, found.weight) - point) <= (found_within + on_a_face) * size)) return std::nullopt;
  return found;
}

std::optional<PointInSolid<4>> point_in_tetrahedron(const std::array<Vec3, 4>& corner, const Vec3& point) {
  const Vec3 a = corner[1] - corner[0];
  const Vec3 b = corner[2] - corner[0];
  const Vec3 c = corner[3] - corner[0];
  const double volume = dot(a, cross(b, c));
  if (volume == 0) return std::nullopt;
  const Vec3 p = point - corner[0];
  PointInSolid<4> found;
  found.weight[1] = dot(p, cross(b, c)) / volume;
  found.weight[2] = dot(p, cross(c, a)) / volume;
  found.weight[3] = dot(p, cross(a, b)) / volume;
  found.weight[0] = 1 - found.weight[1] - found.weight[2] - found.weight[3];
  double sum = 0;
  double least = 0;
  for (double& weight : found.weight) {
    if (std::fabs(weight) < 0.5 * on_a_face) weight = 0;
    sum += weight;
    least = std::min(least, weight);
  }
  for (double& weight : found.weight) weight /= sum;
  found.beyond = -2 * least;
  return found;
}

}  // namespace crumple::constraints
