// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/node_fields.hpp"

namespace crumple::constraints {

/// What resists a change of one of the six velocities of a node, with what it carries: mass (components 0 to
/// 2) or rotary inertia (3 to 5) [mass, or mass * length^2].
inline double mass_along(const domain::NodeFields& nodes, Index node, int component) {
  return component < 3 ? nodes.moving_mass(node) : nodes.moving_inertia(node);
}

/// One over that; zero for what is fixed or has no mass.
inline double inverse_mass_along(const domain::NodeFields& nodes, Index node, int component) {
  const unsigned fixed =
      component < 3 ? domain::fixed_translation(component) : domain::fixed_rotation(component - 3);
  const double mass = mass_along(nodes, node, component);
  return (nodes.fixed[node] & fixed) != 0 || !(mass > 0) ? 0 : 1 / mass;
}

}  // namespace crumple::constraints
