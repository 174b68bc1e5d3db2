// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/run_session.hpp"

#include <sys/resource.h>

#include <numeric>
#include <ostream>

#include "app/console/print.hpp"
#include "app/preparation/left_out.hpp"
#include "app/preparation/model_summary.hpp"
#include "app/preparation/preparation.hpp"
#include "app/session/live_pages.hpp"
#include "app/session/run_limits.hpp"
#include "app/session/run_summary.hpp"
#include "base/error.hpp"
#include "deck/build/units.hpp"
#include "elements/elements.hpp"
#include "output/earlier_results.hpp"
#include "output/files/atomic_file.hpp"
#include "output/files/folder_lock.hpp"
#include "output/files/set_aside.hpp"
#include "output/files/write_error.hpp"
#include "output/lsdyna/dynain.hpp"
#include "output/run_record.hpp"
#include "timeloop/fitting_state.hpp"

namespace crumple::app {

namespace {

/// Cycles between looks for runaway nodes, a pass over all nodes.
constexpr long peak_cycles = 64;

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

bool lies_in(const std::filesystem::path& file, const std::filesystem::path& folder) {
  std::error_code fault;
  const std::filesystem::path parent = file.has_parent_path() ? file.parent_path() : ".";
  return std::filesystem::equivalent(parent, folder, fault) && !fault;
}

Index segments_of_contacts(const domain::Domain& domain) {
  Index sum = 0;
  for (const domain::ContactReport& contact : domain.contacts) sum += contact.segments;
  return sum;
}

bool positions_are_finite(const domain::NodeFields& nodes) {
  for (const math::Vec3& x : nodes.position)
    if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z)) return false;
  return true;
}

}  // namespace

std::filesystem::path result_folder(const Options& options) {
  if (!options.folder.empty()) return options.folder;
  std::filesystem::path folder = options.deck.stem();
  return folder += ".out";
}

RunSession::RunSession(const Options& options, const deck::ReadResult& deck, const Console& console,
                       const Stopwatch& wall, const Surroundings& around)
    : options_(options),
      deck_(deck),
      console_(console),
      wall_(wall),
      board_(around.board),
      folder_(result_folder(options)),
      simulation_(*deck.model, choose_execution(options, *deck.model)),
      signals_(around.signals == Signals::Heard ? std::make_unique<StopSignals>() : nullptr),
      switches_({std::filesystem::path("."), folder_}),
      inspection_times_(deck.model->control, segments_of_contacts(simulation_.domain())) {
  simulation_.verify_search_every(options.verify_search);
  if (options.d3plot || options.accelerations) simulation_.keep_accelerations();
  if (options.trace_energy > 0) simulation_.trace_energy();
  if (options.allow_negative_contact_energy) simulation_.allow_negative_contact_energy();
  const Restart* const restart = around.restart;
  if (restart == nullptr)
    prepare();
  else
    take_up(*restart);
  const domain::Domain& domain = simulation_.domain();
  warn_of_ties(console.err, *deck.model, domain);
  if (!options.quiet) {
    print_model(console.out, *deck.model, domain);
    print_run_settings(console.out, relaxation_ ? relaxation_->simulation() : simulation_, folder_);
  }
  restart_settings_.options = options;
  restart_settings_.texts = deck.texts;
  // Other instruction sets round otherwise.
  restart_settings_.options.isa = std::string(isa_name(domain.execution.isa));
  output::make_folder(folder_);
  lock_ = std::make_unique<output::FolderLock>(folder_);
  open_files(restart);
  if (relaxation_) relaxation_->open(folder_);
  restart_writer_ = std::make_unique<RestartWriter>(folder_ / restart_folder, deck.model->output.restart,
                                                    options.restart_every, domain.clock);
  if (restart != nullptr && lies_in(restart->file, folder_ / restart_folder))
    restart_writer_->goes_on_from(restart->file, domain.clock);
  monitor_ = std::make_unique<Monitor>(simulation_, console, options.quiet, loop_seconds_);
  if (board_ != nullptr)
    monitor_->tell([this](const Progress& progress) {
      board_->post(live_status(simulation_.domain(), progress, recorder_->frames()));
    });
}

/// A relaxation takes its steps where the run takes them, and the run begins with its end.
void RunSession::prepare() {
  if (!deck_.model->relaxation) return begin();
  relaxation_ = std::make_unique<RelaxationPhase>(*deck_.model, simulation_.domain().execution, console_,
                                                  options_.quiet);
  if (options_.allow_negative_contact_energy) relaxation_->simulation().allow_negative_contact_energy();
}

/// The run, at time zero.
void RunSession::begin() {
  if (options_.dynain) earlier_.keep(simulation_.domain().nodes);
  simulation_.start();
  first_step_ = simulation_.next_step();
  const domain::Domain& domain = simulation_.domain();
  total_mass_ = std::accumulate(domain.nodes.mass.begin(), domain.nodes.mass.end(), 0.0) - domain.added_mass;
}

void RunSession::take_up(const Restart& restart) {
  timeloop::require_fitting_state(restart.content.simulation, simulation_.state(), simulation_.domain());
  restart.content.simulation.put_back(simulation_.state());
  simulation_.resume();
  restart.content.files.put_back_known(own_state());
  warnings_ = restart.settings.warnings;
  if (simulation_.finished())
    warn(fmt::format("the state of {} is of the time {:.6g}: the run is at its end and makes no step",
                     restart.file.string(), simulation_.domain().clock.time));
  if (options_.quiet) return;
  print(console_.out, "Taken up from {}: cycle {}, time {:.6g}\n", restart.file.string(),
        simulation_.domain().clock.cycle, simulation_.domain().clock.time);
}

/// A run that is taken up goes on in the files of its folder, and begins new ones in another.
void RunSession::open_files(const Restart* restart) {
  const bool goes_on = restart != nullptr && lies_in(restart->file, folder_ / restart_folder);
  output::ExtraFiles extra{.d3plot = options_.d3plot, .all_fields = options_.all_fields};
  if (goes_on) extra.opening = output::Opening::Continued;
  output::require_no_link(folder_ / restart_folder);
  output::require_no_output(folder_, deck_.files);
  // Whoever finds run.json knows that it belongs to the results beside it.
  if (goes_on) {
    output::remove_ending(folder_);
    set_restart_files_aside(folder_, *restart);
  } else {
    output::remove_earlier_results(folder_);
    remove_restart_files(folder_);
  }
  recorder_ = std::make_unique<output::Recorder>(folder_, restart_settings_.options.deck.stem().string(),
                                                 view(), extra);
  if (!goes_on) return;
  domain::StateList list;
  recorder_->declare(list);
  restart->content.files.put_back_known(list);
  for (std::string& note : output::set_short_files_aside(folder_, list)) warn(std::move(note));
  for (std::string& note : recorder_->resume(simulation_.domain().clock)) warn(std::move(note));
}

void RunSession::warn(std::string text) {
  print(console_.err, "warning: {}\n", text);
  warnings_.push_back(std::move(text));
}

/// What the session remembers of the run so far, beside the simulation.
domain::StateList RunSession::own_state() {
  domain::StateList list;
  peaks_.declare(list);
  inspection_times_.declare(list);
  list.keep("first_step", "time", domain::Entity::Run, first_step_);
  list.keep("total_mass", "mass", domain::Entity::Run, total_mass_);
  list.keep("loop_seconds", "s", domain::Entity::Run, loop_seconds_);
  list.keep("relaxation", "by item", domain::Entity::Run, relaxed_);
  simulation_.declare_reports(list);
  return list;
}

void RunSession::write_restart(RestartKind kind) {
  loop_seconds_ = monitor_->seconds();
  restart_settings_.warnings = warnings_;
  domain::StateList files = own_state();
  recorder_->flush();
  recorder_->declare(files);
  const domain::StateList state = simulation_.state();
  const RestartSource source{state, files, restart_settings_};
  restart_writer_->write(kind, simulation_.domain().clock, source);
}

/// What ends before its time can be taken up again; what ends in time too, if there are restart files at all.
void RunSession::save_for_restart(Ending& ending) {
  if (relaxation_) return;
  const bool wanted = ending.code == ExitCode::Normal && restart_writer_->wanted();
  if (!wanted && ending.termination != "interrupted") return;
  try {
    const StageTimer timer(simulation_.domain().times.output);
    write_restart(RestartKind::Newest);
  } catch (const output::WriteError& fault) {
    ending = {"error", fault.what(), ExitCode::Output};
  }
}

output::View RunSession::view() const {
  output::View view{simulation_.model(), simulation_.domain(), simulation_.next_step()};
  view.controlling = [this] {
    return elements::controlling_element(simulation_.model(), simulation_.domain());
  };
  if (options_.trace_energy > 0) view.energy_trace = [this] { return simulation_.energy_trace(); };
  view.contact_node_forces = [this] { return simulation_.contact_node_forces(); };
  view.sections = simulation_.sections();
  view.earlier_velocity = earlier_.velocity;
  view.earlier_angular_velocity = earlier_.angular_velocity;
  return view;
}

/// Bodies that pass through each other may be apart again at the end.
void RunSession::inspect_during_run() {
  if (inspection_times_.due(simulation_.domain().clock) && positions_are_finite(simulation_.domain().nodes))
    simulation_.note_intersections();
}

void RunSession::observe() {
  {
    const StageTimer timer(simulation_.domain().times.output);
    peaks_.observe(simulation_.domain().energy);
    if (simulation_.domain().clock.cycle % peak_cycles == 0) peaks_.observe(view());
    inspect_during_run();
    recorder_->write_due(view());
    if (restart_writer_->due(simulation_.domain().clock)) write_restart(RestartKind::Due);
  }
  good_state_.observe(simulation_);
  monitor_->observe();
}

/// Neither restart files nor frames are of a relaxation: true, with a note, while there is one.
bool RunSession::refuse_while_relaxing(std::string_view what) {
  if (!relaxation_) return false;
  print(console_.err, "note: no {} is written during the dynamic relaxation\n", what);
  return true;
}

std::optional<Ending> RunSession::asked_to_stop() {
  if (const int signal = signals_ ? signals_->received() : 0; signal != 0)
    return Ending{"interrupted", name_of_signal(signal) + std::string("."), code_of_signal(signal)};
  const std::optional<Switch> thrown =
      signals_ && signals_->asked_for_restart() ? Switch::Restart : switches_.poll();
  if (!thrown) return std::nullopt;
  monitor_->clear_bar();
  switch (*thrown) {
    case Switch::Stop:
      return Ending{"interrupted", "sw1 in d3kil.", ExitCode::Stopped};
    case Switch::Status:
      relaxation_ ? relaxation_->print_line() : monitor_->print_line();
      break;
    case Switch::Restart:
      if (refuse_while_relaxing("restart file")) break;
      write_restart(RestartKind::Newest);
      print(console_.out, "Restart file {}\n", restart_writer_->newest().string());
      break;
    case Switch::Frame:
      if (refuse_while_relaxing("frame")) break;
      recorder_->write_frame(view());
      break;
    case Switch::Unknown:
      print(console_.err, "note: d3kil holds none of sw1, sw2, sw3, sw4; the run goes on.\n");
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

/// One round of the loop before the run.
std::optional<Ending> RunSession::relax() {
  if (auto ending = asked_to_stop()) return ending;
  relaxation_->step();
  if (relaxation_->finished()) end_relaxation();
  return std::nullopt;
}

void RunSession::end_relaxation() {
  relaxation_->close();
  relaxed_ = relaxation_->record();
  if (!options_.quiet) print_relaxation(console_, relaxed_);
  const model::RelaxationSettings& settings = deck_.model->relaxation->settings;
  if (relaxed_.converged == 0)
    warn(
        fmt::format("the dynamic relaxation has not converged at DRTERM = {:.6g}: its ratio is {:.4g}, and "
                    "DRTOL {:.4g}; the run goes on from there, as LS-DYNA does",
                    settings.end_time, relaxed_.ratio, settings.tolerance));
  constexpr double most = 0.01;
  if (relaxed_.energy_error > most)
    warn(fmt::format("the energy error of the dynamic relaxation is {:.4g} % (limit 1 %)",
                     100 * relaxed_.energy_error));
  simulation_.begin_with(relaxation_->simulation());
  relaxation_.reset();
  monitor_->begin();
  begin();
}

/// What it has come to is shown as the state of time zero, in a run that does not begin.
void RunSession::abandon_relaxation() {
  relaxation_->close();
  relaxed_ = relaxation_->record();
  timeloop::Simulation& left = relaxation_->simulation();
  if (!positions_are_finite(left.domain().nodes)) return;
  simulation_.begin_with(left);
  simulation_.domain().energy = left.domain().energy;
}

/// One round of the loop.
std::optional<Ending> RunSession::follow() {
  if (relaxation_) return relax();
  observe();
  if (simulation_.finished())
    return Ending{
        "normal",
        simulation_.ended_by().value_or(end_reached(simulation_.model().control, simulation_.domain().clock)),
        ExitCode::Normal};
  if (auto ending = asked_to_stop()) return ending;
  if (auto ending = limit_passed()) {
    // The state is good: a run may be taken up from it with another limit.
    write_restart(RestartKind::LastGood);
    return ending;
  }
  if (options_.dynain) earlier_.keep(simulation_.domain().nodes);
  simulation_.step();
  return std::nullopt;
}

/// The same, with everything that can end the loop turned into an ending.
std::optional<Ending> RunSession::follow_guarded() {
  try {
    return follow();
  } catch (const output::WriteError& fault) {
    return Ending{"error", fault.what(), ExitCode::Output};
  } catch (const Error& fault) {
    return gone_wrong(fault.what());
  }
}

/// Goes back to the last state before the error, for the frames and histories, and for whoever wants to look
/// at the step that failed.
Ending RunSession::gone_wrong(const std::string& reason) {
  if (relaxation_) return {"error", "In the dynamic relaxation: " + reason, ExitCode::Numerical};
  Ending ending{"error", reason, ExitCode::Numerical};
  if (!good_state_.return_before(simulation_.domain().clock.cycle, simulation_)) return ending;
  ending.reason += fmt::format(" The last state before it, of cycle {}, is the last frame.",
                               simulation_.domain().clock.cycle);
  try {
    write_restart(RestartKind::LastGood);
  } catch (const output::WriteError& fault) {
    return {"error", reason + " " + fault.what(), ExitCode::Output};
  }
  return ending;
}

void RunSession::write_record(const Ending& ending) {
  output::RunRecord record;
  record.version = program_version();
  record.deck = restart_settings_.options.deck.string();
  record.deck_hash = deck_.text_hash;
  record.deck_hash_with_parameters = deck::hash_with_parameters(deck_);
  record.command = options_.command;
  record.options = options_text(restart_settings_.options);
  for (const deck::SetParameter& parameter : deck_.parameters)
    record.parameters.push_back({parameter.name, parameter.value, parameter.is_preset});
  record.perturbation = restart_settings_.options.perturbation;
  record.seed = restart_settings_.options.seed;
  record.relaxation = relaxed_;
  record.units = deck::guess_units(simulation_.model());
  record.termination = ending.termination;
  record.reason = ending.reason;
  record.wall_seconds = wall_.seconds();
  record.loop_seconds = loop_seconds_;
  record.peak_memory_bytes = peak_memory_bytes();
  record.state_hash = simulation_.state_hash();
  record.checks = output::acceptance_checks(view(), peaks_);
  record.warnings = warnings_;
  record.left_out = left_out_of(deck_);
  for (const auto& file : written_files()) record.files.push_back(file.lexically_relative(folder_));
  output::write_run_record(folder_, record, view());
}

std::vector<std::filesystem::path> RunSession::written_files() const {
  std::vector<std::filesystem::path> files = recorder_->files();
  if (relaxed_.cycles > 0) files.push_back(folder_ / relaxation_file);
  for (std::filesystem::path& file : restart_writer_->files()) files.push_back(std::move(file));
  if (dynain_) files.push_back(*dynain_);
  return files;
}

/// The deck that another run goes on from, if it is asked for.
void RunSession::write_dynain() {
  output::DynainRequest request;
  request.springback = simulation_.model().output.springback;
  request.all = request.velocities = options_.dynain;
  if (!request.wanted()) return;
  const output::Dynain dynain = output::dynain_of(view(), request);
  dynain_ = folder_ / output::dynain_name;
  output::write_atomically(*dynain_, dynain.text);
  for (const std::string& note : dynain.notes) warn(note);
}

/// Writes what is still to be written. If that fails where all else went well, the ending becomes an error.
void RunSession::finish(Ending& ending) {
  try {
    {
      const StageTimer timer(simulation_.domain().times.output);
      if (positions_are_finite(simulation_.domain().nodes)) simulation_.inspect_contacts();
      // After a numerical error the frames before are the last good state, unless the nodes still are
      // somewhere.
      if (ending.code != ExitCode::Output) recorder_->flush();
      if (positions_are_finite(simulation_.domain().nodes) && ending.code != ExitCode::Output)
        recorder_->write_last(view());
      if (ending.code == ExitCode::Normal || ending.code == ExitCode::Stopped) write_dynain();
    }
    // What is written last is output of the run, too.
    loop_seconds_ = monitor_->seconds();
    write_record(ending);
  } catch (const output::WriteError& fault) {
    if (ending.code != ExitCode::Output) ending = {"error", fault.what(), ExitCode::Output};
  }
}

bool RunSession::advance() {
  if (!ending_) ending_ = follow_guarded();
  return !ending_;
}

void RunSession::interrupt(std::string reason) {
  if (!ending_) ending_ = Ending{"interrupted", std::move(reason), ExitCode::Stopped};
}

ExitCode RunSession::run() {
  while (advance()) {
  }
  return close();
}

ExitCode RunSession::close() {
  Ending& ending = *ending_;
  loop_seconds_ = monitor_->seconds();
  save_for_restart(ending);
  if (relaxation_) abandon_relaxation();
  monitor_->clear_bar();
  if (!options_.quiet && ending.code != ExitCode::Output) monitor_->print_last_line();
  for (const deck::Diagnostic& diagnostic : deck_.diagnostics)
    if (diagnostic.severity == deck::Severity::Warning) warnings_.push_back(deck::to_string(diagnostic));
  peaks_.observe(view());
  for (std::string& warning : output::energy_warnings(view(), peaks_)) warn(std::move(warning));
  for (std::string& warning : output::distortion_warnings(view())) warn(std::move(warning));
  finish(ending);
  if (board_ != nullptr) {
    board_->post(live_status(simulation_.domain(), monitor_->progress(), recorder_->frames()));
    board_->end(ending.termination);
  }
  const std::vector<output::Check> checks = output::acceptance_checks(view(), peaks_);
  if (!options_.quiet) {
    print_summary(console_.out, view(), peaks_, loop_seconds_);
    print_checks(console_.out, checks);
    print_final_omissions(console_.out, left_out_of(deck_));
    print_files(console_.out, folder_, written_files());
  }
  print_failed_checks(console_.err, checks);
  if (ending.code == ExitCode::Normal)
    print(console_.out, "\n *** {} ***\n", ending.reason);
  else
    print(console_.err, "\ncrumple: {}: {}\n", ending.termination, ending.reason);
  // Nothing is written from here on, and the caller may keep the session to look at its state.
  lock_.reset();
  return ending.code;
}

}  // namespace crumple::app
