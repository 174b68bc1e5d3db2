// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/index.hpp"

namespace crumple::model {

/// Fixed degrees of freedom of a node, in global axes: true is held at zero (*BOUNDARY_SPC).
struct FixedNode {
  Index node = no_index;
  std::array<bool, 3> translation{};
  std::array<bool, 3> rotation{};
};

/// Velocity of a node at time zero. Later entries for the same node replace earlier ones.
struct InitialVelocity {
  Index node = no_index;
  std::array<double, 3> velocity{};          ///< [length/time]
  std::array<double, 3> angular_velocity{};  ///< [1/time]
};

/// A force on a node: force times the curve's ordinate at the present time. Without a curve it acts in full
/// from time zero on.
struct NodalLoad {
  Index node = no_index;
  std::array<double, 3> force{};   ///< [force]
  std::array<double, 3> moment{};  ///< [force * length]
  Index curve = no_index;          ///< in Model::curves; abscissa [time], ordinate a factor
};

/// A pressure on a segment, which follows its motion: pressure times the curve's ordinate at the time since
/// its arrival (*LOAD_SEGMENT, *LOAD_SHELL). Positive against the normal.
struct PressureLoad {
  std::array<Index, 4> node{no_index, no_index, no_index, no_index};  ///< a triangle repeats its third node
  double pressure = 0;                                                ///< [stress]
  Index curve = no_index;  ///< in Model::curves; abscissa [time], ordinate a factor
  double arrival = 0;      ///< AT: no load before [time]
  Index shell = no_index;  ///< in Model::shells: the load ends when this shell erodes
};

/// Motion of a node or of a rigid body along or about one global axis (*BOUNDARY_PRESCRIBED_MOTION): scale
/// times the curve's ordinate at the time since birth.
struct PrescribedMotion {
  enum class Kind { Velocity, Acceleration, Displacement };
  Index node = no_index;  ///< in Model::nodes; or a body
  Index body = no_index;  ///< in Model::rigid_bodies: translation of its centre of mass
  int axis = 0;           ///< 0, 1, 2 for x, y, z
  bool rotation = false;  ///< about the axis, in radians, instead of along it
  Kind kind = Kind::Velocity;
  Index curve = no_index;  ///< in Model::curves; abscissa [time]
  double scale = 1;
  double birth = 0;     ///< free before [time]
  double death = 1e28;  ///< free from then on [time]
};

/// Acceleration of the frame of reference along a global axis (*LOAD_BODY): masses feel the opposite.
struct BodyLoad {
  int axis = 0;            ///< 0, 1, 2 for x, y, z
  Index curve = no_index;  ///< in Model::curves; abscissa [time], ordinate [length/time^2]
  double scale = 1;
};

/// Damping of all motion in proportion to mass (*DAMPING_GLOBAL).
struct MassDamping {
  Index curve = no_index;                      ///< in Model::curves; abscissa [time], ordinate [1/time]
  double constant = 0;                         ///< without a curve [1/time]
  std::array<double, 3> translation{1, 1, 1};  ///< factors on it, by global axis
  std::array<double, 3> rotation{1, 1, 1};
};

/// Force on the centre of mass of a rigid body, or moment on the body (*LOAD_RIGID_BODY), global axes.
struct RigidBodyLoad {
  Index body = no_index;           ///< in Model::rigid_bodies
  std::array<double, 3> force{};   ///< [force]
  std::array<double, 3> moment{};  ///< [force * length]
  Index curve = no_index;          ///< in Model::curves; abscissa [time], ordinate a factor
};

/// What a rigid wall looks like. Plane, Flat: a plane, infinite or a rectangle. The others are closed
/// surfaces that are stopped at from outside.
enum class WallShape { Plane, Flat, Prism, Cylinder, Sphere };

/// How a wall moves: along `direction`, by a curve of its velocity or displacement over time.
struct WallMotion {
  Index curve = no_index;  ///< in Model::curves; abscissa [time], ordinate [length/time] or [length]
  bool is_displacement = false;
  std::array<double, 3> direction{};  ///< what the curve's ordinate is multiplied with [-]
};

/// A surface that nodes may not cross (*RIGIDWALL_PLANAR, *RIGIDWALL_GEOMETRIC). At rest unless it has a
/// curve, or a mass.
struct RigidWall {
  UserId id = 0;
  std::string title;
  std::vector<Index> nodes;        ///< the nodes that the wall stops
  std::array<double, 3> point{};   ///< on the plane; corner of a rectangle or of the front of a prism; centre
                                   ///< of the end of a cylinder or of a sphere [length]
  std::array<double, 3> normal{};  ///< unit normal, towards the side where the nodes are; axis of a cylinder
  double friction = 0;             ///< Coulomb coefficient; a value of 1 or more sticks, as in LS-DYNA
  WallShape shape = WallShape::Plane;
  std::array<double, 3> edge{};  ///< l: unit vector along a rectangle's or prism's first edge; m = normal x l
  std::array<double, 3> lengths{};  ///< along l, m and against the normal, of a cylinder along it (the
                                    ///< first); 0 is infinite [length]
  double radius = 0;                ///< of a cylinder or a sphere [length]
  WallMotion motion{};
  double mass = 0;              ///< of a plane that slides along its normal, pushed by nodes; 0: none [mass]
  double initial_velocity = 0;  ///< of a wall with mass, along its normal [length/time]
  double birth_time = 0;        ///< [time]
  double death_time = 1e20;     ///< [time]
};

}  // namespace crumple::model
