// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/kernel_list.hpp"
#include "elements/solid/solid_task.hpp"
#include "model/section.hpp"

namespace crumple::elements {

/// What preparation needs to know of a formulation.
struct ShellKind {
  int kind = -1;  ///< place in the list, -1 if it is not there
  const char* name = "";
  int planes = 1;  ///< points in plane
};

ShellKind shell_kind(model::ShellFormulation formulation);

/// The same of a formulation of solids.
struct SolidKind {
  int kind = -1;
  const char* name = "";
  int points = 1;
  KeptItem kept;          ///< of each element from step to step
  bool averages = false;  ///< dilatation averaged at the nodes before
};

SolidKind solid_kind(model::SolidFormulation formulation);

}  // namespace crumple::elements
