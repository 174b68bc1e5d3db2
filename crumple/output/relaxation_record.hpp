// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple::output {

/// How the dynamic relaxation before a run went, for run.json and the summary. No cycles: there was none.
struct RelaxationRecord {
  long cycles = 0;
  long converged = 0;       ///< 1 if it has, 0 if it came to its end time before
  double time = 0;          ///< of its own clock [time]
  double ratio = 0;         ///< kinetic energy over the largest, at the last check [-]
  double factor = 0;        ///< left of velocities in each step, at the end [-]
  double energy_error = 0;  ///< of its own balance, damping included [-]
  double seconds = 0;       ///< wall time [s]
};

}  // namespace crumple::output
