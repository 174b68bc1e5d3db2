// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments/command_line.hpp"
#include "app/session/run_session.hpp"
#include "binding/deck_reading.hpp"
#include "timeloop/simulation.hpp"

namespace crumple::python {

/// The loop over the steps of a run, one round at a time.
class Loop {
 public:
  Loop() = default;
  virtual ~Loop() = default;
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  /// One step, unless the run is at its end. False if it is, or has failed: then there is an ending().
  virtual bool advance() = 0;
  /// Makes the tables of its folder complete up to now.
  virtual void flush() {}
  /// Ends the run now, if it is not at its end.
  virtual void interrupt(const std::string& reason) = 0;
  /// Writes what is still to be written; to be called once, when there is an ending().
  virtual void close() = 0;
  virtual std::optional<app::Ending> ending() const = 0;
  virtual timeloop::Simulation& simulation() = 0;
  /// Sentences about the results.
  virtual std::vector<std::string> warnings() const { return {}; }
};

/// A run that writes nothing, or one that writes the same folder as `crumple run` if `options` names one.
/// Both make the same steps. The deck must have a model and outlive the loop. Throws Error.
std::unique_ptr<Loop> make_loop(const app::Options& options, const DeckReading& deck);

}  // namespace crumple::python
