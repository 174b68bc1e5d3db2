// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "base/index.hpp"
#include "deck/format/report.hpp"
#include "model/model.hpp"

namespace crumple::deck {

// Loads and prescribed motions as the deck has them: what they refer to by the user's ids.

/// A force or a moment on a node or on every node of a set.
struct RawNodalLoad {
  UserId target = 0;
  bool is_set = false;
  int direction = 0;  ///< DOF: 1-3 forces, 5-7 moments
  UserId curve = 0;
  double scale = 1;
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

/// A control volume whose segments and curves are still ids.
struct RawControlVolume {
  model::ControlVolume volume;
  UserId set = 0;
  bool is_parts = false;  ///< the set is one of parts, all shells of which are segments
  /// Of the curves in the order of the filling's members; 0 is none.
  std::array<UserId, 6> curves{};
  Where where;       ///< of the card with the set
  Where gas_where;   ///< of the card with the curves
  Where more_where;  ///< of the next one
};

struct RawPrescribedMotion {
  enum class Target { Node, NodeSet, Body };
  Target target = Target::Node;
  UserId id = 0;
  UserId curve = 0;
  model::PrescribedMotion motion;
  Where where;
};

struct RawBodyLoad {
  model::BodyLoad load;
  UserId curve = 0;
  Where where;
};

struct RawMassDamping {
  model::MassDamping damping;
  UserId curve = 0;  ///< 0 is none
  Where where;
};

struct RawRigidBodyLoad {
  UserId body = 0;
  int direction = 0;  ///< DOF: 1-3 forces, 5-7 moments
  UserId curve = 0;
  double scale = 1;
  Where where;
};

}  // namespace crumple::deck
