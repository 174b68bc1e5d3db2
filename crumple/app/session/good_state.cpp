// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/good_state.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace crumple::app {

namespace {

/// Time between copies: over the time that one takes, and at least [s].
constexpr double least_share = 200;
constexpr double least_seconds = 1;

}  // namespace

void GoodState::observe(timeloop::Simulation& simulation) {
  if (!copy_.empty() && since_copy_.seconds() < std::max(least_seconds, least_share * copy_seconds_)) return;
  const Stopwatch copying;
  copy_.take(simulation.state());
  domain::StateList reports;
  simulation.declare_reports(reports);
  reports_.take(reports);
  copy_seconds_ = copying.seconds();
  since_copy_.restart();
}

bool GoodState::return_before(long cycle, timeloop::Simulation& simulation) const {
  if (copy_.empty()) return false;
  try {
    copy_.put_back(simulation.state());
    domain::StateList reports;
    simulation.declare_reports(reports);
    reports_.put_back_known(reports);
    simulation.resume();
    while (simulation.domain().clock.cycle < cycle - 1) simulation.step();
  } catch (const Error&) {
    return false;
  }
  return true;
}

}  // namespace crumple::app
