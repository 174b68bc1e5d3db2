// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/model.hpp"

namespace crumple::golden {

/// A short run in which much acts at once. Between them the cases have every formulation, most materials,
/// contact, erosion, walls, loads, thickness rules, rigid bodies, connections and equations of state.
struct Case {
  const char* name;
  model::Model (*make)();
  bool erodes = false;  ///< some of its elements fail
};

/// A law with isotropic and kinematic hardening.
model::PlasticKinematic kinematic_steel();

/// Those without shells.
const std::vector<Case>& solid_cases();

const std::vector<Case>& cases();

}  // namespace crumple::golden
