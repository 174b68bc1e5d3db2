// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple::model {

/// Damping of the elements of a part in proportion to their elastic stiffness (*DAMPING_PART_STIFFNESS). One
/// of both is zero.
struct StiffnessDamping {
  double share = 0;  ///< of critical damping at the highest frequency of each element [-]
  double beta = 0;   ///< Rayleigh's: the factor on the stiffness [time]
};

}  // namespace crumple::model
