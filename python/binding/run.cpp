// SPDX-License-Identifier: BSD-3-Clause
#include "binding/run.hpp"

#include <cmath>

#include "base/stopwatch.hpp"
#include "output/files/write_error.hpp"

namespace crumple::python {

namespace py = pybind11;

namespace {

/// Between two calls of Python's signal handlers [s]: soon enough for who presses Ctrl-C, and seldom enough
/// for steps of microseconds.
constexpr double signal_interval = 0.05;

/// Holds a run for one thread.
class Hold {
 public:
  explicit Hold(std::atomic<bool>& busy) : busy_(busy) {
    if (busy_.exchange(true))
      throw InputError(
          "Another thread is stepping this simulation: a simulation serves one thread at a time.");
  }
  ~Hold() { busy_ = false; }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;

 private:
  std::atomic<bool>& busy_;
};

/// What refuses a run gets the words of the console.
std::unique_ptr<Loop> loop_of(const app::Options& options, const DeckReading& deck) {
  if (!deck.result.model) throw InputError(deck.console);
  try {
    return make_loop(options, deck);
  } catch (const output::WriteError& fault) {
    throw output::WriteError(std::string("crumple: error: ") + fault.what());
  } catch (const NumericalError& fault) {
    throw NumericalError(std::string("crumple: error: ") + fault.what());
  } catch (const Error& fault) {
    throw InputError(options.deck.string() + ": error: " + fault.what());
  }
}

}  // namespace

Run::Run(std::shared_ptr<const DeckReading> deck, const app::Options& options, double history_every)
    : deck_(std::move(deck)), loop_(loop_of(options, *deck_)), history_every_(history_every) {
  sample(true);
}

EnergyRow Run::energies() const {
  const domain::Domain& domain = simulation().domain();
  const domain::EnergyLedger& e = domain.energy;
  return {domain.clock.time, e.kinetic, e.internal,      e.hourglass, e.contact, e.friction,
          e.rigidwall,       e.damping, e.external_work, e.eroded,    e.total()};
}

void Run::sample(bool due) {
  const double time = simulation().domain().clock.time;
  if (!due && time < next_sample_) return;
  if (!energies_.empty() && energies_.back().time == time) return;
  energies_.push_back(energies());
  next_sample_ = history_every_ * (std::floor(time / history_every_) + 1);
}

long Run::advance(double until, long steps) {
  const Hold hold(busy_);
  if (closed_) throw InputError("The simulation is closed.");
  const py::gil_scoped_release other_threads_run;
  const domain::Clock& clock = simulation().domain().clock;
  Stopwatch since_signals;
  long done = 0;
  while (done < steps && clock.time < until && loop_->advance()) {
    ++done;
    sample(false);
    if (since_signals.seconds() < signal_interval) continue;
    const py::gil_scoped_acquire handlers_run;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    since_signals = Stopwatch();
  }
  // The end is noticed before the step behind it.
  if (simulation().finished()) loop_->advance();
  if (loop_->ending())
    sample(true);
  else
    loop_->flush();
  return done;
}

void Run::interrupt(const std::string& reason) {
  const Hold hold(busy_);
  loop_->interrupt(reason);
}

void Run::close() {
  const Hold hold(busy_);
  if (closed_ || !loop_->ending()) return;
  closed_ = true;
  const py::gil_scoped_release other_threads_run;
  loop_->close();
}

}  // namespace crumple::python
