// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "base/index.hpp"
#include "deck/format/report.hpp"
#include "model/model.hpp"

namespace crumple::deck {

// Supports, loads and prescribed motions as the deck has them: what they refer to by the user's ids.

/// What *BOUNDARY_SPC holds of a node or of every node of a set.
struct RawFixed {
  UserId target = 0;
  bool is_set = false;
  std::array<bool, 3> translation{};
  std::array<bool, 3> rotation{};
  Where where;
  UserId system = 0;      ///< CID; 0 is global axes
  bool is_timed = false;  ///< BIRTH_DEATH
  double birth = 0;
  double death = 1e28;
};

/// A force or a moment on a node or on every node of a set.
struct RawNodalLoad {
  UserId target = 0;
  bool is_set = false;
  int direction = 0;  ///< DOF: 1-3 forces, 5-7 moments; 4 and 8 along and about the normal of a plane
  UserId curve = 0;
  double scale = 1;
  UserId system = 0;              ///< CID: axes of the direction; 0 is global ones
  std::array<UserId, 3> plane{};  ///< M1, M2, M3
  Where where;
};

/// A pressure on a segment, or on a shell.
struct RawPressureLoad {
  std::array<UserId, 4> node{};
  UserId shell = 0;        ///< the nodes are this shell's; 0: they are given
  UserId shell_set = 0;    ///< on all shells of a set
  UserId segment_set = 0;  ///< on all segments of a set
  UserId curve = 0;
  double scale = 1;
  double arrival = 0;
  Where where;
};

/// A charge whose node is still an id.
struct RawAirBlast {
  model::AirBlast blast;
  UserId node = 0;  ///< NIDBO; 0 is none
  int units = 0;    ///< UNIT
  Where where;
  Where more_where;  ///< of the second card
};

/// Segments that a blast loads.
struct RawBlastSegment {
  UserId blast = 0;  ///< BID
  std::array<UserId, 4> node{};
  UserId segment_set = 0;  ///< on all segments of a set; 0: the nodes are given
  double scale = 1;
  Where where;
};

/// A control volume whose segments and curves are still ids.
struct RawControlVolume {
  model::ControlVolume volume;
  UserId set = 0;
  bool is_parts = false;  ///< the set is one of parts, all shells of which are segments
  /// Of the curves in the order of the filling's members; 0 is none.
  std::array<UserId, 6> curves{};
  bool vents_fabric = false;  ///< gas leaves through *MAT_FABRIC as that says
  int fabric_venting = 0;     ///< OPT: how it leaves where FVOPT of the fabric is 0; 0 not at all
  Where where;                ///< of the card with the set
  Where gas_where;            ///< of the card with the curves
  Where more_where;           ///< of the next one
};

struct RawPrescribedMotion {
  enum class Target { Node, NodeSet, Body };
  Target target = Target::Node;
  UserId id = 0;
  UserId curve = 0;
  model::PrescribedMotion motion;
  UserId vector = 0;  ///< VID in the place of an axis; 0 is none
  Where where;
};

struct RawBodyLoad {
  model::BodyLoad load;
  UserId curve = 0;
  UserId relaxation_curve = 0;  ///< LCIDDR, instead in a dynamic relaxation; 0 is none
  UserId system = 0;            ///< CID; 0 is global axes
  Where where;
};

/// *CONTROL_DYNAMIC_RELAXATION.
struct RawRelaxation {
  int flag = 0;  ///< IDRFLG
  model::RelaxationSettings settings;
  Where where;
};

/// Forces of inertia by rotation, along a vector, or on some of the masses.
struct RawInertiaField {
  enum class On { All, Part, PartSet, NodeSet, NodeRange };
  model::InertiaField field;
  UserId curve = 0;
  UserId relaxation_curve = 0;  ///< LCIDDR, DRLCID or LCDR, instead in a dynamic relaxation; 0 is none
  UserId system = 0;            ///< CID, of acceleration and spin; 0 is global axes
  On on = On::All;              ///< All: but for what *LOAD_BODY_PARTS says
  UserId target = 0;
  UserId last = 0;  ///< of a range
  Where where;
};

/// *LOAD_BODY_PARTS: the only parts that *LOAD_BODY acts on.
struct RawBodyLoadParts {
  UserId part_set = 0;
  Where where;
};

/// A direction in space.
struct RawVector {
  UserId id = 0;
  std::array<double, 3> vector{};
  UserId system = 0;  ///< CID, of the components; 0 is global axes
  Where where;
};

struct RawMassDamping {
  model::MassDamping damping;
  UserId curve = 0;  ///< 0 is none
  Where where;
  UserId target = 0;  ///< a part, or a part set; 0 is all
  bool is_set = false;
};

/// *DAMPING_PART_STIFFNESS.
struct RawStiffnessDamping {
  model::StiffnessDamping damping;
  UserId target = 0;  ///< a part, or a part set
  bool is_set = false;
  Where where;
};

struct RawRelativeDamping {
  model::RelativeDamping damping;
  UserId body = 0;
  UserId parts = 0;
  UserId curve = 0;  ///< 0 is none
  Where where;
};

/// A segment set whose faces of solids do not reflect waves.
struct RawViscousBoundary {
  UserId set = 0;
  bool normal = true;
  bool tangential = true;
  Where where;
};

/// Mass that is spread over the nodes of a part or of the parts of a set.
struct RawPartMass {
  UserId target = 0;
  bool is_set = false;
  double added = 0;
  double final_mass = 0;
  Where where;
};

struct RawRigidBodyLoad {
  UserId body = 0;
  int direction = 0;  ///< as in RawNodalLoad
  UserId curve = 0;
  double scale = 1;
  Where where;
  UserId system = 0;
  std::array<UserId, 3> plane{};
};

}  // namespace crumple::deck
