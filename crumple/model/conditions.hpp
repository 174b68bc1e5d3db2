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

/// Degrees of freedom of a node that are held along and about axes of their own, or for a part of the run
/// alone (*BOUNDARY_SPC with CID, BIRTH or DEATH).
struct LocalSupport {
  Index node = no_index;
  std::array<std::array<double, 3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< right-handed unit axes
  std::array<bool, 3> translation{};                                             ///< along each of them
  std::array<bool, 3> rotation{};                                                ///< about each of them
  double birth = 0;                                                              ///< free before [time]
  double death = 1e28;                                                           ///< free from then on [time]

  /// Whether it acts as long as any run: DEATH is never, or its default.
  bool lasts() const { return birth <= 0 && death >= 1e20; }
};

/// Velocity of a node at time zero. Later entries for the same node replace earlier ones.
struct InitialVelocity {
  Index node = no_index;
  std::array<double, 3> velocity{};          ///< [length/time]
  std::array<double, 3> angular_velocity{};  ///< [1/time]
};

/// Stress of a point of an element at time zero.
struct InitialPointStress {
  double place = 0;  ///< of shells, through the thickness: -1 the lower, 1 the upper surface [-]
  std::array<double, 6> stress{};  ///< xx, yy, zz, xy, yz, zx in global axes [stress]
  double plastic_strain = 0;       ///< effective [-]
  /// Centre of the yield surface of *MAT_PLASTIC_KINEMATIC: xx, yy, xy, yz, zx, of shells along the side from
  /// the first to the second node and the normal, of solids in global axes [stress].
  std::array<double, 5> back_stress{};
};

/// Stresses of an element at time zero (*INITIAL_STRESS_SHELL, _SOLID).
struct InitialStress {
  Index element = no_index;  ///< in Model::shells or Model::solids
  int planes = 1;            ///< of shells: points in plane, each with points through the thickness
  bool has_back_stress = false;
  double volume = 0;  ///< of solids: that of their mass; 0 is the present one [length^3]
  std::vector<InitialPointStress> points;
};

/// Three nodes whose plane a load follows: it acts along (x2 - x1) x (x3 - x1).
struct FollowedPlane {
  std::array<Index, 3> node{no_index, no_index, no_index};
  bool given() const { return node[0] != no_index; }
};

/// A force on a node: force times the curve's ordinate at the present time. Without a curve it acts in full
/// from time zero on.
struct NodalLoad {
  Index node = no_index;
  std::array<double, 3> force{};   ///< [force]
  std::array<double, 3> moment{};  ///< [force * length]
  Index curve = no_index;          ///< in Model::curves; abscissa [time], ordinate a factor
  FollowedPlane plane{};           ///< if given, x of force and moment is along its normal; y and z are zero
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

/// A face of a solid that waves leave as if the solid went on behind it (*BOUNDARY_NON_REFLECTING).
struct ViscousSegment {
  std::array<Index, 4> node{no_index, no_index, no_index, no_index};  ///< a triangle repeats its third node
  Index solid = no_index;  ///< in Model::solids: its density and wave speeds; ends when it erodes
  bool normal = true;      ///< takes dilatational waves (AD = 0)
  bool tangential = true;  ///< takes shear waves (AS = 0)
};

/// Motion of a node or of a rigid body along or about one axis (*BOUNDARY_PRESCRIBED_MOTION): scale times the
/// curve's ordinate at the time since birth.
struct PrescribedMotion {
  enum class Kind { Velocity, Acceleration, Displacement };
  Index node = no_index;  ///< in Model::nodes; or a body
  Index body = no_index;  ///< in Model::rigid_bodies: translation of its centre of mass
  int axis = 0;           ///< 0, 1, 2 for x, y, z; of a body those of RigidBody::held_axes
  bool rotation = false;  ///< about the axis, in radians, instead of along it
  Kind kind = Kind::Velocity;
  Index curve = no_index;  ///< in Model::curves; abscissa [time]
  double scale = 1;
  double birth = 0;                   ///< free before [time]
  double death = 1e28;                ///< free from then on [time]
  std::array<double, 3> direction{};  ///< of nodes: unit vector in the place of the axis; zero is the axis
  bool holds_plane = false;  ///< with a direction: no motion across (or rotation about what is across)
  /// Of nodes: they go round the axis through `centre`, by the angle or angular velocity of the curve [rad].
  bool goes_round = false;
  std::array<double, 3> centre{};  ///< [length]
  bool keeps_radius = true;        ///< else the distance from the axis is free

  bool has_direction() const { return direction != std::array<double, 3>{}; }
};

/// Acceleration of the frame of reference along a global axis (*LOAD_BODY): masses feel the opposite.
struct BodyLoad {
  int axis = 0;            ///< 0, 1, 2 for x, y, z
  Index curve = no_index;  ///< in Model::curves; abscissa [time], ordinate [length/time^2]
  double scale = 1;
};

/// Forces of inertia of a frame that accelerates and turns, on some of the masses (*LOAD_BODY with parts,
/// along a vector or by rotation, *LOAD_GRAVITY_PART): -m (f a + f^2 w x (w x (x - c))), f being the curve's
/// ordinate.
struct InertiaField {
  Index curve = no_index;                ///< in Model::curves; abscissa [time], ordinate a factor
  std::array<double, 3> acceleration{};  ///< a [length/time^2]
  std::array<double, 3> spin{};          ///< w [1/time]
  std::array<double, 3> centre{};        ///< c [length]
  bool of_all = true;                    ///< all masses; false: of the parts and nodes below
  std::vector<Index> parts;              ///< in Model::parts: the mass of their elements
  std::vector<Index> nodes;              ///< in Model::nodes, ascending: their whole mass
};

/// Damping of all motion in proportion to mass (*DAMPING_GLOBAL, *DAMPING_PART_MASS).
struct MassDamping {
  Index curve = no_index;                      ///< in Model::curves; abscissa [time], ordinate [1/time]
  double constant = 0;                         ///< without a curve [1/time]
  double scale = 1;                            ///< on the curve
  std::array<double, 3> translation{1, 1, 1};  ///< factors on it, by global axis
  std::array<double, 3> rotation{1, 1, 1};
  std::vector<Index> parts{};  ///< in Model::parts: of their masses; empty: of all
};

/// Damping of the motion of parts against a rigid body (*DAMPING_RELATIVE).
struct RelativeDamping {
  Index body = no_index;       ///< in Model::rigid_bodies
  double frequency = 0;        ///< at which an oscillation is damped by `share` [1/time]
  double share = 0;            ///< of critical damping, without a curve [-]
  Index curve = no_index;      ///< in Model::curves, of the share; abscissa [time]
  std::vector<Index> parts{};  ///< in Model::parts
};

/// Mass that is spread over the nodes of some parts in proportion to what they have (*ELEMENT_MASS_PART).
struct PartMass {
  std::vector<Index> parts;  ///< in Model::parts, together
  double added = 0;          ///< [mass]
  double final_mass = 0;     ///< in the place of `added`, the mass that the parts have then; 0 is none [mass]
};

/// Force on the centre of mass of a rigid body, or moment on the body (*LOAD_RIGID_BODY), global axes.
struct RigidBodyLoad {
  Index body = no_index;           ///< in Model::rigid_bodies
  std::array<double, 3> force{};   ///< [force]
  std::array<double, 3> moment{};  ///< [force * length]
  Index curve = no_index;          ///< in Model::curves; abscissa [time], ordinate a factor
  FollowedPlane plane{};           ///< as in NodalLoad
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
