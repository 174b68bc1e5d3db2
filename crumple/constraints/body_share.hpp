// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"

namespace crumple::constraints {

/// Share of their masses with which the nodes of a body have, in every rigid motion, at most the kinetic
/// energy of the body, whose inertia may have been given: what springs on the nodes may count on, so that the
/// stability of each node by itself is that of the body (own derivation, docs/theory/rigid_bodies.md). At
/// most 1; 1 where the inertia is that of the nodes.
double share_of_masses(const domain::RigidBody& body, const domain::NodeFields& nodes);

}  // namespace crumple::constraints
