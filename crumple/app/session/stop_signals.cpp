// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/stop_signals.hpp"

namespace crumple::app {

namespace {

// The globals of the program: a signal handler has no other way to leave word.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t signal_received = 0;
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t restart_asked_for = 0;

extern "C" void remember_signal(int number) {
  signal_received = number;
}

extern "C" void remember_restart(int /*number*/) {
  restart_asked_for = 1;
}

}  // namespace

StopSignals::StopSignals() {
  signal_received = 0;
  struct sigaction action {};
  action.sa_handler = remember_signal;
  sigemptyset(&action.sa_mask);
  // Writing goes on when a signal comes in the middle of it, and the handler serves once.
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  sigaction(SIGINT, &action, &earlier_interrupt_);
  sigaction(SIGTERM, &action, &earlier_terminate_);
  sigaction(SIGHUP, &action, &earlier_hangup_);
  if (earlier_hangup_.sa_handler == SIG_IGN) sigaction(SIGHUP, &earlier_hangup_, nullptr);
  restart_asked_for = 0;
  action.sa_handler = remember_restart;
  action.sa_flags = SA_RESTART;
  sigaction(SIGUSR1, &action, &earlier_user_);
  // A limit on the size of files then shows as an error of the write, which names the file.
  action.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &action, &earlier_file_size_);
}

StopSignals::~StopSignals() {
  sigaction(SIGINT, &earlier_interrupt_, nullptr);
  sigaction(SIGTERM, &earlier_terminate_, nullptr);
  sigaction(SIGHUP, &earlier_hangup_, nullptr);
  sigaction(SIGUSR1, &earlier_user_, nullptr);
  sigaction(SIGXFSZ, &earlier_file_size_, nullptr);
}

IgnoredUserSignal::IgnoredUserSignal() {
  struct sigaction action {};
  action.sa_handler = SIG_IGN;
  sigemptyset(&action.sa_mask);
  sigaction(SIGUSR1, &action, &earlier_);
}

IgnoredUserSignal::~IgnoredUserSignal() {
  sigaction(SIGUSR1, &earlier_, nullptr);
}

bool StopSignals::asked_for_restart() {
  const bool asked = restart_asked_for != 0;
  if (asked) restart_asked_for = 0;
  return asked;
}

int StopSignals::received() const {
  return signal_received;
}

const char* name_of_signal(int signal) {
  switch (signal) {
    case SIGINT:
      return "Ctrl-C (SIGINT)";
    case SIGHUP:
      return "SIGHUP: the terminal was closed";
    default:
      return "SIGTERM";
  }
}

ExitCode code_of_signal(int signal) {
  switch (signal) {
    case SIGINT:
      return ExitCode::Interrupt;
    case SIGHUP:
      return ExitCode::Hangup;
    default:
      return ExitCode::Terminate;
  }
}

}  // namespace crumple::app
