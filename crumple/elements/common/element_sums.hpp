// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"

namespace crumple::elements {

/// What a chunk tells of all its elements: nothing that depends on the order in which they are computed.
/// Energies are summed by group, see domain::GroupEnergy.
struct ElementSums {
  double shortest_step = 1e30;  ///< smallest stable step at time n [time]
  Index eroded = 0;             ///< elements that have failed now
};

}  // namespace crumple::elements
