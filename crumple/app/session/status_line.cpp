// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/status_line.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "output/run_record.hpp"

namespace crumple::app {

std::string format_duration(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0 || seconds > 1e9) return "?";
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string status_header() {
  return fmt::format("{:>8} {:>10} {:>9}  {:<16} {:>10} {:>10} {:>9} {:>9} {:>7} {:>6} {:>7}\n{:-<115}",
                     "cycle", "time", "step", "controlled by", "kinetic", "internal", "hourglass", "contact",
                     "ratio", "ns/ec", "to go", "");
}

std::string status_line(const domain::Domain& domain, const Progress& progress) {
  const domain::EnergyLedger& energy = domain.energy;
  const std::string controlling = fmt::format("{} {} p{}", progress.controlling.kind,
                                              progress.controlling.element, progress.controlling.part);
  return fmt::format(
      "{:>8} {:>10.4e} {:>9.3e}  {:<16} {:>10.4e} {:>10.4e} {:>9.2e} {:>9.2e} {:>7.5f} {:>6.1f} {:>7}",
      domain.clock.cycle, domain.clock.time, progress.next_step, controlling, energy.kinetic, energy.internal,
      energy.hourglass, energy.contact, energy.ratio(),
      output::nanoseconds_per_element_cycle(domain, progress.seconds),
      format_duration(progress.seconds_to_go));
}

std::string progress_bar(const domain::Domain& domain, const Progress& progress) {
  constexpr int width = 30;
  const double done =
      progress.end_time > 0 ? std::clamp(domain.clock.time / progress.end_time, 0.0, 1.0) : 0.0;
  const int filled = static_cast<int>(done * width);
  return fmt::format("[{:#<{}}{:.<{}}] {:3.0f} %  cycle {}  time {:.3e}  {} to go", "", filled, "",
                     width - filled, 100 * done, domain.clock.cycle, domain.clock.time,
                     format_duration(progress.seconds_to_go));
}

}  // namespace crumple::app
