// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/run_limits.hpp"

#include <fmt/core.h>

#include <cmath>

namespace crumple::app {

std::optional<std::string> passed_limit(const model::Control& control, const domain::Domain& domain,
                                        double next_step, const RunStart& start) {
  if (control.minimum_step_factor > 0 && next_step < control.minimum_step_factor * start.first_step)
    return fmt::format("The time step {:.4g} fell below DTMIN times the first step, {:.4g}.", next_step,
                       control.minimum_step_factor * start.first_step);
  const double change = 100 * std::fabs(domain.energy.ratio() - 1);
  if (control.end_energy_ratio > 0 && change > control.end_energy_ratio)
    return fmt::format("The energy ratio changed by {:.4g} %, more than ENDENG = {:.4g} %.", change,
                       control.end_energy_ratio);
  const double increase = start.total_mass > 0 ? 100 * domain.added_mass / start.total_mass : 0;
  if (control.end_mass_increase > 0 && increase > control.end_mass_increase)
    return fmt::format("termination due to mass increase: {:.4g} % was added, more than ENDMAS = {:.4g} %.",
                       increase, control.end_mass_increase);
  return std::nullopt;
}

}  // namespace crumple::app
