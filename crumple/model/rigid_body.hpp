// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/index.hpp"

namespace crumple::model {

/// Mass properties that are given instead of those of the nodes (*PART_INERTIA).
struct RigidInertia {
  double mass = 0;                 ///< [mass]
  std::array<double, 3> centre{};  ///< centre of mass [length]
  /// About the centre in global axes: xx, xy, xz, yy, yz, zz components of the tensor [mass * length^2].
  std::array<double, 6> tensor{};
  std::array<double, 3> velocity{};          ///< at time zero, of the centre [length/time]
  std::array<double, 3> angular_velocity{};  ///< at time zero, global axes [1/time]
  bool velocity_from_nodes = false;          ///< IRIGID: initial velocities of the nodes replace these two
};

/// How a rigid body moves at time zero, whatever its nodes do (*INITIAL_VELOCITY_RIGID_BODY).
struct RigidMotion {
  std::array<double, 3> velocity{};          ///< of the centre of mass [length/time]
  std::array<double, 3> angular_velocity{};  ///< global axes [1/time]
};

/// Nodes that move as one: those of parts of rigid material, and others that are tied to them.
struct RigidBody {
  UserId id = 0;  ///< of the leading part, or the body's own
  std::string title;
  std::vector<Index> parts;                 ///< parts of rigid material, the leading one first; may be empty
  std::vector<Index> nodes;                 ///< all nodes, ascending, none twice
  std::array<bool, 3> fixed_translation{};  ///< of the centre of mass along each of held_axes
  std::array<bool, 3> fixed_rotation{};     ///< about each of held_axes
  /// Of unit length, right-handed, fixed in space; prescribed motions are along and about them as well.
  std::array<std::array<double, 3>, 3> held_axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::optional<RigidMotion> initial_motion{};  ///< goes before all other initial velocities
  std::optional<RigidInertia> inertia{};        ///< absent: of the masses at the nodes
  /// Nodes whose masses are added to a given inertia (IFLAG of *CONSTRAINED_EXTRA_NODES), ascending.
  std::vector<Index> added_nodes{};
};

/// Bounds of the motion of a rigid body along a direction (*CONSTRAINED_RIGID_BODY_STOPPERS). It stops where
/// it meets one, and is free to move away from it.
struct RigidBodyStopper {
  /// A curve over time, of the displacement or of the coordinate of the centre of mass.
  struct Bound {
    Index curve = no_index;        ///< in Model::curves; no_index: none
    bool is_displacement = false;  ///< since time zero; else the coordinate along the direction
  };
  Index body = no_index;              ///< in Model::rigid_bodies
  std::array<double, 3> direction{};  ///< of unit length, fixed in space
  Bound largest;                      ///< LCMAX
  Bound smallest;                     ///< LCMIN
  Index speed_curve = no_index;       ///< LCVMNX: largest speed along the direction; no_index: none
  double birth_time = 0;              ///< TB [time]
  double death_time = 1e21;           ///< TD [time]
};

}  // namespace crumple::model
