// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/enforcement/touch.hpp"
#include "contact/surface/statistics.hpp"
#include "domain/domain.hpp"

namespace crumple::contact {

/// What is known of the touches of a step once they have their forces: each detector goes over its own once,
/// because in a large model touches come from memory.
struct TouchNotes {
  domain::ContactReport& report;
  double step = 0;  ///< that led here [time]
  long cycle = 0;
  std::vector<Penetration>& penetrations;  ///< of the touches with a force
  double stored_energy = 0;                ///< by all penalties now [energy]

  /// Force that passivity withheld from a touch.
  void note_withheld(const Touch& touch, UserId node, UserId segment) const;
  /// A normal force; `offset` is what the contact distance is reduced by.
  void note_force(const Touch& touch, UserId node, double offset) const;
};

}  // namespace crumple::contact
