// SPDX-License-Identifier: BSD-3-Clause
#include "app/stop_signals.hpp"

namespace crumple::app {

namespace {

/// The one global of the program: a signal handler has no other way to leave word.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t signal_received = 0;

extern "C" void remember_signal(int number) {
  signal_received = number;
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
}

StopSignals::~StopSignals() {
  sigaction(SIGINT, &earlier_interrupt_, nullptr);
  sigaction(SIGTERM, &earlier_terminate_, nullptr);
}

int StopSignals::received() const {
  return signal_received;
}

}  // namespace crumple::app
