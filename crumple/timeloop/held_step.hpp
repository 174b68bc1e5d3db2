// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "domain/state_list.hpp"

namespace crumple::timeloop {

/// A step that does not swing. A stable step that swings with the vibration of the element that sets it would
/// feed that vibration: a square, swinging by 0.1 %, won a fifth of its energy in 20 000 cycles
/// (docs/theory/time_integration.md). So the step falls at once to what is allowed, and rises only when the
/// least that was allowed for some vibrations is clearly more.
class HeldStep {
 public:
  /// The step after cycle `cycle`, `last` being the one before it (0: none), of which `allowed` is stable
  /// [time].
  double next(long cycle, double last, double allowed);

  void declare(domain::StateList& list);

 private:
  double least_ = 0;   ///< allowed since the last multiple of `window` cycles [time]
  double before_ = 0;  ///< in the window before that [time]
};

}  // namespace crumple::timeloop
