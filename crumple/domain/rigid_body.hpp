// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "base/index.hpp"
#include "math/rotation.hpp"
#include "math/vec3.hpp"

namespace crumple::domain {

/// Nodes that move as one. As for nodes, the place belongs to time n and the velocities to n - 1/2, or to
/// n + 1/2 once the momenta have been kicked.
struct RigidBody {
  UserId id = 0;
  Index part = no_index;           ///< the leading part; no_index for a group of nodes
  bool has_given_inertia = false;  ///< its mass is not that of its elements
  bool active = true;              ///< false: its nodes are free again
  std::vector<Index> nodes;        ///< domain nodes, ascending
  std::vector<math::Vec3> arm;     ///< of each node from the centre, in the body's axes [length]
  double mass = 0;                 ///< [mass]
  math::Vec3 principal_inertia;    ///< about the body's axes [mass * length^2]
  math::Matrix3 held_axes = math::unit_matrix();  ///< columns: the directions of what is fixed or held
  std::array<bool, 3> fixed_translation{};        ///< along each of them
  std::array<bool, 3> fixed_rotation{};           ///< about each of them

  math::Vec3 centre;            ///< centre of mass at time n [length]
  math::Quaternion turn;        ///< from the body's axes to the global ones at time n
  math::Quaternion next_turn;   ///< the same at time n + 1
  math::Vec3 velocity;          ///< of the centre [length/time]
  math::Vec3 angular_momentum;  ///< about the centre, global axes [mass * length^2 / time]
  math::Vec3 angular_velocity;  ///< of the step between two times, as the nodes have it [1/time]
  math::Vec3 spin;              ///< the angular velocity that goes with the momentum at time n [1/time]
  math::Vec3 acceleration;      ///< of the centre at time n [length/time^2]
  math::Vec3 force;           ///< on the centre besides those on the nodes, cleared by the integrator [force]
  math::Vec3 moment;          ///< the same [force * length]
  double kinetic_energy = 0;  ///< at time n, in product form [energy]
  math::Vec3 reaction;        ///< of what is prescribed, in the last step, walls not counted [force]
  math::Vec3 reaction_moment;  ///< the same, about the centre [force * length]
  double deferred_work = 0;    ///< half of the work of prescribed motion, which the energy of n + 1 shows

  // Within a step, between the kick of the momenta and the placing of the nodes.
  std::array<bool, 3> held_translation{};  ///< fixed, or prescribed
  std::array<bool, 3> held_rotation{};
  math::Vec3 prescribed_velocity;  ///< components along held_axes; zero where fixed
  math::Vec3 prescribed_spin;      ///< components about held_axes
  math::Vec3 previous_velocity;    ///< v(n-1/2)
  math::Vec3 previous_spin;        ///< of the momentum of n - 1/2 at the place of time n
  math::Vec3 previous_momentum;    ///< angular, of n - 1/2
  math::Vec3 impulse;              ///< of all forces of this step but the reactions [force * time]
  math::Vec3 angular_impulse;      ///< about the centre
};

}  // namespace crumple::domain
