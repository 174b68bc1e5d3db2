// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "binding/deck_reading.hpp"
#include "binding/loop.hpp"

namespace crumple::python {

/// The energies of the model at one time, a row of Run::energy_history().
struct EnergyRow {
  double time = 0;  ///< [time]
  double kinetic = 0;
  double internal = 0;
  double hourglass = 0;
  double contact = 0;
  double friction = 0;
  double rigidwall = 0;
  double damping = 0;
  double external_work = 0;
  double eroded = 0;
  double total = 0;
};

/// A run that Python drives. One thread of Python at a time may use it; another one gets an InputError.
class Run {
 public:
  /// `history_every`: between rows of the energies [time]. Throws Error, InputError with the words of the
  /// console.
  Run(std::shared_ptr<const DeckReading> deck, const app::Options& options, double history_every);

  /// Steps until the time is reached, so many steps are done or the run ends; returns how many it did. Lets
  /// other threads of Python run meanwhile, and Python's signal handlers 20 times a second: what they raise
  /// passes through, between two steps.
  long advance(double until, long steps);
  void interrupt(const std::string& reason);
  /// Writes the end of the results, once.
  void close();

  std::optional<app::Ending> ending() const { return loop_->ending(); }
  bool closed() const { return closed_; }
  std::vector<std::string> warnings() const { return loop_->warnings(); }
  const DeckReading& deck() const { return *deck_; }
  const std::vector<EnergyRow>& energy_history() const { return energies_; }
  EnergyRow energies() const;

  timeloop::Simulation& simulation() { return loop_->simulation(); }
  const timeloop::Simulation& simulation() const { return loop_->simulation(); }

 private:
  void sample(bool due);

  std::shared_ptr<const DeckReading> deck_;
  std::unique_ptr<Loop> loop_;
  std::vector<EnergyRow> energies_;
  double history_every_ = 0;
  double next_sample_ = 0;  ///< [time]
  bool closed_ = false;
  std::atomic<bool> busy_ = false;
};

}  // namespace crumple::python
