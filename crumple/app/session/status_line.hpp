// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "domain/domain.hpp"

namespace crumple::app {

/// How far a run is, beside what the domain tells.
struct Progress {
  double end_time = 0;        ///< [time]
  double next_step = 0;       ///< [time]
  double seconds_to_go = -1;  ///< wall time to the end; negative if it is not known yet [s]
  double seconds = 0;         ///< wall time of the cycles so far [s]
  domain::ControllingElement controlling;
};

/// Names of the columns of status_line, two lines.
std::string status_header();
/// Cycle, time, step, controlling element, energies, ratio, ns per element-cycle, time to go. No newline.
std::string status_line(const domain::Domain& domain, const Progress& progress);
/// A bar of at most 79 characters for a terminal.
std::string progress_bar(const domain::Domain& domain, const Progress& progress);

/// "0.4 s", "12 s", "3:05", "1:02:45"; "?" for what is negative or no number.
std::string format_duration(double seconds);

}  // namespace crumple::app
