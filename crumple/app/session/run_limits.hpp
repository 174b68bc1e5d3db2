// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "domain/domain.hpp"
#include "model/control.hpp"

namespace crumple::app {

/// What limits of *CONTROL_TERMINATION compare with.
struct RunStart {
  double first_step = 0;  ///< [time]
  double total_mass = 0;  ///< without added mass [mass]
};

/// The reason to end a run before its end time, if a limit of the deck is passed: DTMIN (step below a share
/// of the first; with ERODE only where other elements than solids ask for it, as solids go), ENDENG (energy
/// ratio), ENDMAS (added mass). A sentence.
std::optional<std::string> passed_limit(const model::Control& control, const domain::Domain& domain,
                                        double next_step, const RunStart& start);

/// Which of the two ends that a deck always may have a run has come to: its end time, or before it the number
/// of cycles of ENDCYC.
std::string end_reached(const model::Control& control, const domain::Clock& clock);

}  // namespace crumple::app
