// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple::app {

/// What the program returns to its caller. Documented in docs/usage.md and in the help; scripts rely on it.
enum class ExitCode {
  Normal = 0,     ///< normal termination
  Input = 1,      ///< the deck cannot be run; nothing was written
  Usage = 2,      ///< the command line is wrong
  Numerical = 3,  ///< the run went wrong, or reached a limit that the deck sets; results up to there are kept
  Output = 4,     ///< a result could not be written
  Stopped = 5,    ///< ended before its time by sw1 in a d3kil file
  Hangup = 129,   ///< ended by SIGHUP: the terminal was closed
  Interrupt = 130,  ///< ended by SIGINT (Ctrl-C)
  Terminate = 143,  ///< ended by SIGTERM
};

/// True if a signal ended the run.
constexpr bool is_of_signal(ExitCode code) {
  return code == ExitCode::Hangup || code == ExitCode::Interrupt || code == ExitCode::Terminate;
}

}  // namespace crumple::app
