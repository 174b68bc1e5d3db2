// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple::model {

/// Behaviour of solids with an equation of state in tension, where their pressure cut-off is not zero.
enum class Spall {
  None,      ///< the pressure stays at its bound
  Stress,    ///< rubble as soon as the largest principal stress reaches minus the bound
  Pressure,  ///< rubble as soon as the pressure reaches the bound
};

}  // namespace crumple::model
