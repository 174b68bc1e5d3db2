// SPDX-License-Identifier: BSD-3-Clause
#include "binding/loop.hpp"

#include <numeric>
#include <sstream>

#include "app/preparation/preparation.hpp"
#include "app/session/run_limits.hpp"
#include "timeloop/dynamic_relaxation.hpp"

namespace crumple::python {

namespace {

/// Steps alone.
class BareLoop : public Loop {
 public:
  BareLoop(const app::Options& options, const DeckReading& deck)
      : simulation_(*deck.result.model, app::choose_execution(options, *deck.result.model)) {
    if (options.allow_negative_contact_energy) simulation_.allow_negative_contact_energy();
    if (options.accelerations) simulation_.keep_accelerations();
    timeloop::begin_relaxed(simulation_);
    simulation_.start();
    const domain::Domain& domain = simulation_.domain();
    start_.first_step = simulation_.next_step();
    start_.total_mass =
        std::accumulate(domain.nodes.mass.begin(), domain.nodes.mass.end(), 0.0) - domain.added_mass;
  }

  bool advance() override {
    if (ending_) return false;
    if (simulation_.finished()) {
      ending_ = {"normal",
                 simulation_.ended_by().value_or(
                     app::end_reached(simulation_.model().control, simulation_.domain().clock)),
                 app::ExitCode::Normal};
      return false;
    }
    if (const auto reason = app::passed_limit(simulation_.model().control, simulation_.domain(),
                                              simulation_.next_step(), start_)) {
      ending_ = {"error", *reason, app::ExitCode::Numerical};
      return false;
    }
    try {
      simulation_.step();
    } catch (const Error& fault) {
      ending_ = {"error", fault.what(), app::ExitCode::Numerical};
      return false;
    }
    return true;
  }

  void interrupt(const std::string& reason) override {
    if (!ending_) ending_ = {"interrupted", reason, app::ExitCode::Stopped};
  }
  void close() override {}
  std::optional<app::Ending> ending() const override { return ending_; }
  timeloop::Simulation& simulation() override { return simulation_; }

 private:
  timeloop::Simulation simulation_;
  app::RunStart start_;
  std::optional<app::Ending> ending_;
};

/// As `crumple run`, but that Python hears the signals.
class RecordedLoop : public Loop {
 public:
  RecordedLoop(const app::Options& options, const DeckReading& deck)
      : options_(options),
        console_{text_, text_},
        session_(options_, deck.result, console_, wall_, {.signals = app::Signals::LeftToCaller}) {}

  bool advance() override { return session_.advance(); }
  void flush() override { session_.flush(); }
  void interrupt(const std::string& reason) override { session_.interrupt(reason); }
  void close() override { session_.close(); }
  std::optional<app::Ending> ending() const override { return session_.ending(); }
  timeloop::Simulation& simulation() override { return session_.simulation(); }
  std::vector<std::string> warnings() const override { return session_.warnings(); }

 private:
  app::Options options_;
  std::ostringstream text_;
  app::Console console_;
  Stopwatch wall_;
  app::RunSession session_;
};

}  // namespace

std::unique_ptr<Loop> make_loop(const app::Options& options, const DeckReading& deck) {
  if (options.folder.empty()) return std::make_unique<BareLoop>(options, deck);
  return std::make_unique<RecordedLoop>(options, deck);
}

}  // namespace crumple::python
