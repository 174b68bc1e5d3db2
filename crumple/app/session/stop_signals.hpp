// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

#include "app/console/exit_code.hpp"

namespace crumple::app {

/// While it lives, SIGINT, SIGTERM and SIGHUP do not kill the program but are remembered, so that the run can
/// end between two steps. The second of the same kind kills, for users who cannot wait. A SIGHUP that is
/// ignored stays so: nohup asked for it. SIGUSR1 asks for a restart file, and SIGXFSZ (a file grows beyond a
/// limit) does not kill. At most one object at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// The number of the signal that came, or 0.
  int received() const;
  /// True once after each SIGUSR1, or several at once.
  bool asked_for_restart();

 private:
  struct sigaction earlier_interrupt_ {};
  struct sigaction earlier_terminate_ {};
  struct sigaction earlier_hangup_ {};
  struct sigaction earlier_user_ {};
  struct sigaction earlier_file_size_ {};
};

/// The name of a signal that StopSignals remembers, and the code that the program then returns.
const char* name_of_signal(int signal);
ExitCode code_of_signal(int signal);

/// While it lives, a SIGUSR1 that comes when no run goes on yet, or any more, does nothing.
class IgnoredUserSignal {
 public:
  IgnoredUserSignal();
  ~IgnoredUserSignal();
  IgnoredUserSignal(const IgnoredUserSignal&) = delete;
  IgnoredUserSignal& operator=(const IgnoredUserSignal&) = delete;

 private:
  struct sigaction earlier_ {};
};

}  // namespace crumple::app
