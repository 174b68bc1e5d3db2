// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_session.hpp"

#include <fmt/ostream.h>
#include <sys/resource.h>

#include <numeric>
#include <ostream>

#include "app/model_summary.hpp"
#include "app/preparation.hpp"
#include "app/run_command.hpp"
#include "app/run_limits.hpp"
#include "app/run_summary.hpp"
#include "base/error.hpp"
#include "deck/units.hpp"
#include "elements/elements.hpp"
#include "output/atomic_file.hpp"
#include "output/earlier_results.hpp"
#include "output/run_record.hpp"
#include "output/write_error.hpp"

namespace crumple::app {

namespace {

/// Cycles between looks for runaway nodes, a pass over all nodes.
constexpr long peak_cycles = 64;

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

bool positions_are_finite(const domain::NodeFields& nodes) {
  for (const math::Vec3& x : nodes.position)
    if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z)) return false;
  return true;
}

}  // namespace

RunSession::RunSession(const Options& options, const deck::ReadResult& deck, const Console& console,
                       const Stopwatch& wall)
    : options_(options),
      deck_(deck),
      console_(console),
      wall_(wall),
      folder_(result_folder(options)),
      simulation_(*deck.model, choose_execution(options, *deck.model)),
      switches_({std::filesystem::path("."), folder_}) {
  simulation_.verify_search_every(options.verify_search);
  if (options.d3plot) simulation_.keep_accelerations();
  simulation_.start();
  const domain::Domain& domain = simulation_.domain();
  first_step_ = simulation_.next_step();
  total_mass_ = std::accumulate(domain.nodes.mass.begin(), domain.nodes.mass.end(), 0.0) - domain.added_mass;
  if (!options.quiet) {
    print_model(console.out, *deck.model, domain);
    print_run_settings(console.out, simulation_, folder_);
  }
  output::make_folder(folder_);
  // Whoever finds run.json knows that it belongs to the results beside it.
  output::remove_earlier_results(folder_);
  recorder_ = std::make_unique<output::Recorder>(folder_, options.deck.stem().string(), view(),
                                                 output::ExtraFiles{.d3plot = options.d3plot});
  monitor_ = std::make_unique<Monitor>(simulation_, console, options.quiet);
}

output::View RunSession::view() const {
  return {simulation_.model(), simulation_.domain(), simulation_.next_step(),
          [this] { return elements::controlling_element(simulation_.model(), simulation_.domain()); }};
}

void RunSession::observe() {
  {
    const StageTimer timer(simulation_.domain().times.output);
    if (simulation_.domain().clock.cycle % peak_cycles == 0) peaks_.observe(view());
    recorder_->write_due(view());
  }
  monitor_->observe();
}

std::optional<Ending> RunSession::asked_to_stop() {
  if (const int signal = signals_.received(); signal != 0)
    return Ending{"interrupted", signal == SIGINT ? "Ctrl-C (SIGINT)." : "SIGTERM.",
                  signal == SIGINT ? ExitCode::Interrupt : ExitCode::Terminate};
  const std::optional<Switch> thrown = switches_.poll();
  if (!thrown) return std::nullopt;
  monitor_->clear_bar();
  switch (*thrown) {
    case Switch::Stop:
      return Ending{"interrupted", "sw1 in d3kil.", ExitCode::Stopped};
    case Switch::Status:
      monitor_->print_line();
      break;
    case Switch::Restart:
      fmt::print(console_.err, "note: sw3 in d3kil: restart files are not supported yet; the run goes on.\n");
      break;
    case Switch::Frame:
      recorder_->write_frame(view());
      break;
    case Switch::Unknown:
      fmt::print(console_.err, "note: d3kil holds none of sw1, sw2, sw4; the run goes on.\n");
      break;
  }
  return std::nullopt;
}

std::optional<Ending> RunSession::limit_passed() const {
  const auto reason = passed_limit(simulation_.model().control, simulation_.domain(), simulation_.next_step(),
                                   {first_step_, total_mass_});
  if (!reason) return std::nullopt;
  return Ending{"error", *reason, ExitCode::Numerical};
}

Ending RunSession::follow() {
  for (;;) {
    observe();
    if (simulation_.finished()) return {"normal", "termination time reached", ExitCode::Normal};
    if (const auto ending = asked_to_stop()) return *ending;
    if (const auto ending = limit_passed()) return *ending;
    simulation_.step();
  }
}

/// The loop, with everything that can end it turned into an ending.
Ending RunSession::follow_guarded() {
  try {
    return follow();
  } catch (const output::WriteError& fault) {
    return {"error", fault.what(), ExitCode::Output};
  } catch (const Error& fault) {
    return {"error", fault.what(), ExitCode::Numerical};
  }
}

void RunSession::write_record(const Ending& ending) {
  output::RunRecord record;
  record.version = program_version();
  record.deck = options_.deck.string();
  record.deck_hash = deck_.text_hash;
  record.units = deck::guess_units(simulation_.model());
  record.termination = ending.termination;
  record.reason = ending.reason;
  record.wall_seconds = wall_.seconds();
  record.loop_seconds = loop_seconds_;
  record.peak_memory_bytes = peak_memory_bytes();
  record.state_hash = simulation_.state_hash();
  record.checks = output::acceptance_checks(view(), peaks_);
  record.warnings = warnings_;
  for (const auto& file : recorder_->files()) record.files.push_back(file.lexically_relative(folder_));
  output::write_run_record(folder_, record, view());
}

/// Writes what is still to be written. If that fails where all else went well, the ending becomes an error.
void RunSession::finish(Ending& ending) {
  try {
    {
      const StageTimer timer(simulation_.domain().times.output);
      peaks_.observe(view());
      if (positions_are_finite(simulation_.domain().nodes)) simulation_.inspect_contacts();
      // After a numerical error the frames before are the last good state, unless the nodes still are
      // somewhere.
      if (positions_are_finite(simulation_.domain().nodes) && ending.code != ExitCode::Output)
        recorder_->write_last(view());
    }
    write_record(ending);
  } catch (const output::WriteError& fault) {
    if (ending.code != ExitCode::Output) ending = {"error", fault.what(), ExitCode::Output};
  }
}

ExitCode RunSession::run() {
  Ending ending = follow_guarded();
  loop_seconds_ = monitor_->seconds();
  monitor_->clear_bar();
  if (!options_.quiet && ending.code != ExitCode::Output) monitor_->print_last_line();
  for (const deck::Diagnostic& diagnostic : deck_.diagnostics)
    if (diagnostic.severity == deck::Severity::Warning) warnings_.push_back(deck::to_string(diagnostic));
  for (std::string& warning : output::energy_warnings(view())) {
    fmt::print(console_.err, "warning: {}\n", warning);
    warnings_.push_back(std::move(warning));
  }
  finish(ending);
  if (!options_.quiet) {
    print_summary(console_.out, view(), loop_seconds_);
    print_checks(console_.out, output::acceptance_checks(view(), peaks_));
    print_files(console_.out, folder_, recorder_->files());
  }
  if (ending.code == ExitCode::Normal)
    fmt::print(console_.out, "\n *** termination time reached ***\n");
  else
    fmt::print(console_.err, "\ncrumple: {}: {}\n", ending.termination, ending.reason);
  return ending.code;
}

}  // namespace crumple::app
