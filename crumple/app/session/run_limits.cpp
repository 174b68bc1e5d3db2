// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/run_limits.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "elements/elements.hpp"

namespace crumple::app {

namespace {

/// Whether all elements but solids, which go when they do not, allow a step.
bool allow_step(const domain::Domain& domain, double step) {
  const auto allow = [&](const auto& blocks) {
    return std::all_of(blocks.begin(), blocks.end(), [&](const auto& block) {
      return block.rigid || elements::stable_step(domain, block) >= step;
    });
  };
  return allow(domain.shells) && allow(domain.beams) && allow(domain.discretes);
}

}  // namespace

std::optional<std::string> passed_limit(const model::Control& control, const domain::Domain& domain,
                                        double next_step, const RunStart& start) {
  const double least = control.minimum_step_factor * start.first_step;
  if (next_step < least && !(control.erodes_short_solids && allow_step(domain, least / control.step_scale)))
    return fmt::format("The time step {:.4g} fell below DTMIN times the first step, {:.4g}.", next_step,
                       least);
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

std::string end_reached(const model::Control& control, const domain::Clock& clock) {
  if (control.end_cycle <= 0 || clock.cycle < control.end_cycle) return "termination time reached";
  return fmt::format("cycle limit reached: ENDCYC = {}, at the time {:.4g} of {:.4g}", control.end_cycle,
                     clock.time, control.end_time);
}

}  // namespace crumple::app
