// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Shapes for the generators of meshes.hpp, and closed meshes, shared by the tests of contact.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "math/vec3.hpp"
#include "support/meshes.hpp"

namespace crumple::test {

/// A place in the cube [-1, 1]^3 drawn out to the ball around the origin: shells of the cube become spheres
/// as they come near the surface, the middle stays a cube.
inline Point in_ball(double radius, const Point& cube) {
  const double largest = std::max({std::fabs(cube[0]), std::fabs(cube[1]), std::fabs(cube[2])});
  const double distance = std::hypot(cube[0], cube[1], cube[2]);
  if (distance == 0) return {0, 0, 0};
  // A cube of half the size of the one inside the ball at the middle, the sphere at the surface.
  constexpr double inner = 0.6;
  const double scale = (1 - largest) * inner + largest * largest / distance;
  return {radius * scale * cube[0], radius * scale * cube[1], radius * scale * cube[2]};
}

/// Adds a ball of `cells`^3 hexahedra around `centre` to `part`; returns its first node.
inline Index add_ball(model::Model& model, Index part, Index cells, double radius, const Point& centre) {
  return add_box(model, part, cells, cells, cells, [&](double u, double v, double w) {
    const Point x = in_ball(radius, {2 * u - 1, 2 * v - 1, 2 * w - 1});
    return Point{centre[0] + x[0], centre[1] + x[1], centre[2] + x[2]};
  });
}

/// Adds a tube of around x along quadrilaterals to `part`, closed around: place(u, v) gives the position with
/// u in [0, 1) around and v in [0, 1] along. Returns the first node; node (i, j) is first + j * around + i.
inline Index add_tube(model::Model& model, Index part, Index around, Index along,
                      const std::function<Point(double, double)>& place) {
  const Index first = model.nodes.count();
  for (Index j = 0; j <= along; ++j)
    for (Index i = 0; i < around; ++i) {
      model.nodes.id.push_back(model.nodes.count() + 1);
      model.nodes.position.push_back(place(static_cast<double>(i) / around, static_cast<double>(j) / along));
    }
  for (Index j = 0; j < along; ++j)
    for (Index i = 0; i < around; ++i) {
      const Index row = first + j * around;
      const Index next = (i + 1) % around;
      model.shells.push_back({.id = static_cast<UserId>(model.shells.size()) + 1,
                              .part = part,
                              .node = {row + i, row + next, row + around + next, row + around + i}});
    }
  return first;
}

/// Point of the unit circle at the share u of its circumference.
inline std::array<double, 2> on_circle(double u) {
  const double angle = 2 * std::numbers::pi * u;
  return {std::cos(angle), std::sin(angle)};
}

/// Point of the square with sides of length 2 around the origin, at the share u of its circumference.
inline std::array<double, 2> on_square(double u) {
  const double along = 8 * u;
  if (along < 2) return {1, along - 1};
  if (along < 4) return {3 - along, 1};
  if (along < 6) return {-1, 5 - along};
  return {along - 7, -1};
}

/// Gives all nodes from `first` on the velocity.
inline void set_moving(model::Model& model, Index first, const Point& velocity) {
  for (Index i = first; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i, .velocity = velocity, .angular_velocity = {}});
}

/// Holds all nodes in [first, last).
inline void hold(model::Model& model, Index first, Index last) {
  for (Index i = first; i < last; ++i)
    model.fixed_nodes.push_back(
        {.node = i, .translation = {true, true, true}, .rotation = {true, true, true}});
}

/// Adds a part of the solid section and material 0.
inline Index add_solid_part(model::Model& model) {
  const auto part = static_cast<Index>(model.parts.size());
  model.parts.push_back({.id = part + 1, .title = "solids", .solid_section = 0, .material = 0});
  return part;
}

/// Adds a part of the shell section and material 0.
inline Index add_shell_part(model::Model& model) {
  const auto part = static_cast<Index>(model.parts.size());
  model.parts.push_back({.id = part + 1, .title = "shells", .section = 0, .material = 0});
  return part;
}

/// Lets all parts touch each other and themselves, with a coefficient of friction.
inline model::Contact& touch_all(model::Model& model, double friction = 0) {
  std::vector<Index> parts(model.parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = static_cast<Index>(i);
  model.contacts.push_back(model::self_contact(1, "all", parts));
  model.contacts.back().static_friction = model.contacts.back().dynamic_friction = friction;
  return model.contacts.back();
}

}  // namespace crumple::test
