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
/// of the first), ENDENG (energy ratio), ENDMAS (added mass). A sentence.
std::optional<std::string> passed_limit(const model::Control& control, const domain::Domain& domain,
                                        double next_step, const RunStart& start);

}  // namespace crumple::app
