// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"

namespace crumple::elements {

/// What a chunk adds to the block.
struct ElementSums {
  double internal_energy = 0;   ///< increment [energy]
  double hourglass_energy = 0;  ///< increment [energy]
  double damping_energy = 0;    ///< of damping in proportion to stiffness, increment [energy]
  double shortest_step = 0;     ///< smallest stable step at time n [time]
  double eroded_internal = 0;   ///< internal energy of the elements that have failed now [energy]
  double eroded_hourglass = 0;  ///< the same of their hourglass energy [energy]
  Index eroded = 0;             ///< elements that have failed now
};

}  // namespace crumple::elements
