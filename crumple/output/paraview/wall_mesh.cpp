// SPDX-License-Identifier: BSD-3-Clause
#include "output/paraview/wall_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/to_vec3.hpp"

namespace crumple::output {

using math::to_vec3;
using math::Vec3;

namespace {

constexpr int sectors = 48;
constexpr int rings = 24;

/// Where the model begins and ends along an axis, seen from a point.
struct Extent {
  double first = 0;
  double last = 0;
};
Extent extent_of(const model::Nodes& nodes, const Vec3& point, const Vec3& axis) {
  Extent extent;
  for (const auto& position : nodes.position) {
    const double along = dot(to_vec3(position) - point, axis);
    extent.first = std::min(extent.first, along);
    extent.last = std::max(extent.last, along);
  }
  return extent;
}

/// The extent of a wall along one of its axes: its own length, or the model's.
Extent along(const model::RigidWall& wall, const model::Nodes& nodes, std::size_t length, const Vec3& axis) {
  if (wall.lengths[length] > 0) return {0, wall.lengths[length]};
  return extent_of(nodes, to_vec3(wall.point), axis);
}

WallMesh box_mesh(const model::RigidWall& wall, const model::Nodes& nodes) {
  const Vec3 normal = to_vec3(wall.normal);
  const Vec3 l = to_vec3(wall.edge);
  const Vec3 m = cross(normal, l);
  const Extent length = along(wall, nodes, 0, l);
  const Extent breadth = along(wall, nodes, 1, m);
  const bool flat = wall.shape == model::WallShape::Flat;
  // An endless prism begins at its front.
  const double depth = flat ? 0 : along(wall, nodes, 2, -normal).last;
  WallMesh mesh;
  for (const double back : {0.0, depth})
    for (const auto& [a, b] : {std::pair{length.first, breadth.first}, std::pair{length.last, breadth.first},
                               std::pair{length.last, breadth.last}, std::pair{length.first, breadth.last}})
      mesh.points.push_back(to_vec3(wall.point) + a * l + b * m - back * normal);
  mesh.faces = {{0, 1, 2, 3}};
  if (flat) {
    mesh.points.resize(4);
    return mesh;
  }
  mesh.faces.push_back({7, 6, 5, 4});
  for (Index k = 0; k < 4; ++k) mesh.faces.push_back({k, k + 4, (k + 1) % 4 + 4, (k + 1) % 4});
  return mesh;
}

/// Two unit vectors across an axis.
std::pair<Vec3, Vec3> across(const Vec3& axis) {
  const Vec3 first = normalised(cross(axis, std::fabs(axis.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  return {first, cross(axis, first)};
}

Vec3 on_circle(const std::pair<Vec3, Vec3>& directions, int sector) {
  const double angle = 2 * std::numbers::pi * sector / sectors;
  return std::cos(angle) * directions.first + std::sin(angle) * directions.second;
}

WallMesh cylinder_mesh(const model::RigidWall& wall, const model::Nodes& nodes) {
  const Vec3 axis = to_vec3(wall.normal);
  const Extent length = along(wall, nodes, 0, axis);
  const auto directions = across(axis);
  WallMesh mesh;
  std::vector<Index> first_end;
  std::vector<Index> last_end;
  for (int k = 0; k < sectors; ++k) {
    const Vec3 rim = to_vec3(wall.point) + wall.radius * on_circle(directions, k);
    mesh.points.push_back(rim + length.first * axis);
    mesh.points.push_back(rim + length.last * axis);
    const Index next = (k + 1) % sectors;
    mesh.faces.push_back({2 * k, 2 * next, 2 * next + 1, 2 * k + 1});
    first_end.push_back(2 * (sectors - 1 - k));
    last_end.push_back(2 * k + 1);
  }
  if (wall.lengths[0] > 0) {
    mesh.faces.push_back(first_end);
    mesh.faces.push_back(last_end);
  }
  return mesh;
}

WallMesh sphere_mesh(const model::RigidWall& wall) {
  const Vec3 axis = {0, 0, 1};
  const auto directions = across(axis);
  const Vec3 centre = to_vec3(wall.point);
  WallMesh mesh;
  for (int ring = 1; ring < rings; ++ring) {
    const double polar = std::numbers::pi * ring / rings;
    for (int k = 0; k < sectors; ++k)
      mesh.points.push_back(
          centre + wall.radius * (std::cos(polar) * axis + std::sin(polar) * on_circle(directions, k)));
  }
  const Index top = (rings - 1) * sectors;
  mesh.points.push_back(centre + wall.radius * axis);
  mesh.points.push_back(centre - wall.radius * axis);
  for (int k = 0; k < sectors; ++k) {
    const Index next = (k + 1) % sectors;
    mesh.faces.push_back({top, k, next});
    for (int ring = 0; ring + 2 < rings; ++ring) {
      const Index here = ring * sectors;
      mesh.faces.push_back({here + k, here + sectors + k, here + sectors + next, here + next});
    }
    mesh.faces.push_back({top + 1, top - sectors + next, top - sectors + k});
  }
  return mesh;
}

}  // namespace

WallMesh wall_mesh(const model::RigidWall& wall, const model::Nodes& nodes) {
  switch (wall.shape) {
    case model::WallShape::Flat:
    case model::WallShape::Prism:
      return box_mesh(wall, nodes);
    case model::WallShape::Cylinder:
      return cylinder_mesh(wall, nodes);
    case model::WallShape::Sphere:
      return sphere_mesh(wall);
    default:
      return {};
  }
}

}  // namespace crumple::output
