// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "base/index.hpp"
#include "math/vec3.hpp"

namespace crumple::domain {

/// Wall time of each stage of the cycle, summed over the run [s]. The names are those of run.json.
struct StageTimes {
  double elements = 0;
  double contact_search = 0;
  double contact_local = 0;
  double contact_forces = 0;
  double constraints = 0;
  double integrate = 0;
  double output = 0;
};

/// What a contact interface did so far.
struct ContactReport {
  UserId id = 0;
  std::string method;            ///< of the global search
  long searches = 0;             ///< global searches
  long candidates = 0;           ///< candidate pairs of all searches together
  Index active_pairs = 0;        ///< node-segment pairs with a force, now
  double penetration = 0;        ///< largest now [length]
  double worst_penetration = 0;  ///< largest of the run [length]
  UserId worst_node = 0;         ///< where that was
  double energy = 0;             ///< normal: stored and dissipated [energy]
  double friction_energy = 0;    ///< dissipated [energy]
};

/// What a rigid wall did so far.
struct WallReport {
  UserId id = 0;
  math::Vec3 force;         ///< on the wall, in the last step [force]
  double normal_force = 0;  ///< its part along the wall's normal [force]
  math::Vec3 impulse;       ///< on the wall, of the whole run [force * time]
  double energy = 0;        ///< taken from the model [energy]
};

/// The element that governs the step.
struct ControllingElement {
  UserId element = 0;
  UserId part = 0;
};

}  // namespace crumple::domain
