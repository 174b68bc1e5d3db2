// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/control.hpp"

namespace crumple::app {

/// When to search for what passes during a run, as bodies that go through each other, and costs too much for
/// every cycle: 50 times, evenly spaced over the end time, or over the cycles where the last cycle comes
/// first. In large models no more often than takes half a percent of the time: an inspection costs as much as
/// 4 to 8 steps. Follows from cycles and times alone, never from the speed of the machine.
class InspectionTimes {
 public:
  /// `segments`: of all contacts together.
  InspectionTimes(const model::Control& control, Index segments);

  /// True if an inspection is due now, which then counts as made.
  bool due(const domain::Clock& clock);

  /// Declares the last inspection, for a restart.
  void declare(domain::StateList& list) {
    list.keep("last_contact_inspection", "-", domain::Entity::Run, last_cycle_);
  }

 private:
  double interval_ = 0;    ///< [time]
  long interval_cycles_;   ///< 0: no last cycle
  long least_cycles_ = 0;  ///< between two inspections
  long last_cycle_ = 0;    ///< of the last inspection
};

}  // namespace crumple::app
