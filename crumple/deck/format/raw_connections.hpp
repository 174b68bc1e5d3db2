// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/index.hpp"
#include "deck/format/report.hpp"
#include "model/model.hpp"

namespace crumple::deck {

// Rigid bodies and what joins them and nodes, as the cards say it.

/// Mass properties of a rigid part, or of a nodal rigid body.
struct RawInertia {
  model::RigidInertia inertia;
  UserId centre_node = 0;  ///< the centre is this node's place; 0: it is given
  Where where;
};

/// Two rigid bodies that are one.
struct RawRigidMerge {
  UserId leading = 0;
  UserId merged = 0;
  Where where;
};

/// *INITIAL_VELOCITY_RIGID_BODY.
struct RawRigidVelocity {
  UserId body = 0;
  UserId system = 0;  ///< coordinate system of both; 0 is global axes
  model::RigidMotion motion;
  Where where;
};

/// Nodes that are tied to a rigid part.
struct RawExtraNodes {
  UserId part = 0;
  UserId target = 0;  ///< a node, or a node set
  bool is_set = false;
  bool adds_mass = false;  ///< to a given inertia
  Where where;
};

/// Nodes of a set as a rigid body of their own.
struct RawNodalBody {
  UserId id = 0;
  std::string title;
  UserId node_set = 0;
  model::RigidMaterial held{};
  UserId held_system = 0;  ///< as in RawMaterial
  std::optional<RawInertia> inertia{};
  Where where;
};

/// A weld of two nodes, of the nodes of a set, or of those and the first node.
struct RawWeld {
  model::SpotWeld weld;
  std::array<UserId, 2> node{};
  UserId node_set = 0;
  Where where;
  Where limits_where;  ///< of a second card
};

struct RawRivet {
  UserId id = 0;
  std::array<UserId, 2> node{};
  double failure_time = 0;
  Where where;
};

/// *CONSTRAINED_LINEAR_GLOBAL.
struct RawEquation {
  struct Term {
    UserId node = 0;
    int component = 0;  ///< from 0
    double factor = 0;
    Where where;
  };
  UserId id = 0;
  std::vector<Term> terms;
  Where where;
};

/// *CONSTRAINED_ADAPTIVITY: the first node is in the middle of the others.
struct RawMidNode {
  std::array<UserId, 3> node{};
  Where where;
};

/// *DEFORMABLE_TO_RIGID: parts that are rigid from the start on.
struct RawRigidPart {
  UserId target = 0;  ///< a part, or a part set
  bool is_set = false;
  UserId leading = 0;  ///< LRB: the part that they are merged into; 0 is none
  Where where;
};

/// *CONSTRAINED_GLOBAL: nodes on a plane are held.
struct RawHeldPlane {
  int translation_code = 0;  ///< TC
  int rotation_code = 0;     ///< RC
  int axis = 0;              ///< along the normal
  std::array<double, 3> point{};
  double tolerance = 0;  ///< [length]; 0 takes ours
  Where where;
};

/// *BOUNDARY_SPC_SYMMETRY_PLANE: nodes of some parts that lie near a plane are held as by symmetry.
struct RawSymmetryPlane {
  UserId target = 0;  ///< a part or a part set
  bool is_set = false;
  std::array<double, 3> point{};
  std::array<double, 3> normal{};  ///< of any length
  double tolerance = 0;            ///< [length]; 0 is the default
  Where where;
};

/// *CONSTRAINED_RIGID_BODY_STOPPERS.
struct RawStopper {
  UserId part = 0;
  UserId largest = 0;   ///< LCMAX: a curve; below zero of the displacement
  UserId smallest = 0;  ///< LCMIN, likewise
  UserId speed = 0;     ///< LCVMNX
  int direction = 0;    ///< DIR, 1 to 4
  UserId vector = 0;    ///< VID, of DIR = 4
  double birth = 0;
  double death = 1e21;
  Where where;
};

/// *CONSTRAINED_INTERPOLATION.
struct RawInterpolation {
  struct Independent {
    UserId id = 0;  ///< a node, or a node set
    model::Interpolation::Independent weights;
    Where where;
  };
  model::Interpolation interpolation;
  UserId dependent = 0;
  bool of_sets = false;
  std::vector<Independent> independent;
  Where where;
};

/// *CONSTRAINED_BEAM_IN_SOLID, or *CONSTRAINED_LAGRANGE_IN_SOLID of beams.
struct RawEmbeddedBeams {
  /// A part or a part set, as a field of the card names it.
  struct Side {
    UserId id = 0;
    bool is_set = false;
    std::string_view field;
  };
  UserId id = 0;
  Side beams;
  Side solids;
  double end_time = 0;
  bool between_nodes = false;
  Where where;
};

struct RawConstrainedSet {
  UserId node_set = 0;
  std::array<bool, 3> direction{};
  double failure_time = 0;
  Where where;
};

/// A joint between two rigid bodies.
struct RawJoint {
  model::Joint joint;
  std::array<UserId, 6> node{};  ///< zero where the kind needs none
  Where where;
};

/// Resistance of a joint: curves by id, in the order of the coordinates.
struct RawJointStiffness {
  model::JointStiffness stiffness;
  std::array<UserId, 2> body{};    ///< parts or nodal rigid bodies
  std::array<UserId, 2> system{};  ///< coordinate systems
  std::array<UserId, 3> curve{};   ///< 0 is none
  std::array<UserId, 3> damping_curve{};
  std::array<UserId, 3> friction_curve{};
  Where where;
  Where curves_where;
  Where friction_where;
};

}  // namespace crumple::deck
