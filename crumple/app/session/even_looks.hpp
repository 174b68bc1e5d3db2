// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/control.hpp"

namespace crumple::app {

/// When to look for what passes during a run, as bodies that go through each other, and costs too much for
/// every cycle: 50 times, evenly spaced over the end time, or over the cycles where the last cycle comes
/// first. In large models no more often than takes half a percent of the time: a look costs as much as 4 to 8
/// steps. Follows from cycles and times alone, never from the speed of the machine.
class EvenLooks {
 public:
  /// `segments`: of all contacts together.
  EvenLooks(const model::Control& control, Index segments);

  /// True if it is time to look now, which then counts as a look.
  bool due(const domain::Clock& clock);

  /// Declares the last look, for a restart.
  void declare(domain::StateList& list) {
    list.keep("last_contact_look", "-", domain::Entity::Run, last_cycle_);
  }

 private:
  double interval_ = 0;    ///< [time]
  long interval_cycles_;   ///< 0: no last cycle
  long least_cycles_ = 0;  ///< between two looks
  long last_cycle_ = 0;    ///< of the last look
};

}  // namespace crumple::app
