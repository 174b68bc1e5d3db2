// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// Mass, centre, inertia and motion of some nodes as one body, from their masses, rotary inertias, places and
/// velocities: both momenta are kept. The nodes (of the domain, ascending) stay as they are; see add_body().
/// Throws Error if they have no mass.
domain::RigidBody body_of_nodes(const domain::Domain& domain, UserId id, std::vector<Index> nodes);

/// Puts a body into the domain: from now on it moves its nodes. Returns its place in domain.rigid_bodies.
Index add_body(domain::Domain& domain, domain::RigidBody body);

/// Sets the nodes of a body free again, between two steps or within one before kick(). They keep their
/// places, velocities and angular velocities, of which the body's momenta are made.
void release_body(domain::Domain& domain, Index body);

/// The rigid bodies of a model. A step calls, in this order: kick(), then whatever prescribes velocities or
/// gives impulses, carry_nodes(), and place_nodes() when the nodes have drifted.
class RigidBodies {
 public:
  /// Makes the bodies of domain.rigid_bodies. The masses of the nodes must be there. Throws Error naming a
  /// body that cannot be.
  RigidBodies(const model::Model& model, domain::Domain& domain);

  /// Has contact count on no more of the nodes' masses than the bodies have in every motion
  /// (share_of_masses()): when all touches have been counted in domain.contact_weight.
  void weigh(domain::Domain& domain) const;

  /// Takes momenta from n-1/2 to n+1/2 by the forces on the nodes, and those on the centres, at time n.
  void kick(domain::Domain& domain, double interval) const;

  /// Gives the nodes the velocities of n+1/2 that bring them to their places at n+1; books kinetic energies
  /// and the work of what is prescribed. `interval` is that of the kick.
  void carry_nodes(domain::Domain& domain, double interval, double next_step) const;

  /// Moves the bodies to n+1 and puts their nodes, which are there to round-off, where they belong. Returns
  /// how far it moved any of them at most [length].
  double place_nodes(domain::Domain& domain) const;

  /// Of all active bodies at time n [energy].
  static double kinetic_energy(const domain::Domain& domain);

  /// Has NodeFields::acceleration of the nodes of bodies written.
  void keep_accelerations() { keep_acceleration_ = true; }

 private:
  std::vector<double> share_of_masses_;  ///< by body, as far as inertia has been given
  bool keep_acceleration_ = false;       ///< output asks for accelerations
};

}  // namespace crumple::constraints
