// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments/command_line.hpp"
#include "app/console/console.hpp"
#include "app/console/exit_code.hpp"
#include "app/session/good_state.hpp"
#include "app/session/inspection_times.hpp"
#include "app/session/monitor.hpp"
#include "app/session/relaxation_phase.hpp"
#include "app/session/restart_settings.hpp"
#include "app/session/restart_writer.hpp"
#include "app/session/stop_signals.hpp"
#include "app/session/switch_file.hpp"
#include "base/stopwatch.hpp"
#include "deck/reader.hpp"
#include "domain/earlier_velocities.hpp"
#include "live/run_status.hpp"
#include "output/checks.hpp"
#include "output/files/folder_lock.hpp"
#include "output/recorder.hpp"
#include "timeloop/simulation.hpp"

namespace crumple::app {

/// Folder of the results: as asked for, else the deck's name with ".out", in the working folder.
std::filesystem::path result_folder(const Options& options);

/// How a run ended.
struct Ending {
  std::string termination;  ///< "normal", "error" or "interrupted", as run.json says it
  std::string reason;       ///< a sentence
  ExitCode code = ExitCode::Normal;
};

/// Who hears the signals that ask a run to end.
enum class Signals {
  Heard,         ///< the session, while it lives
  LeftToCaller,  ///< a program of which the session is a part, as Python
};

/// What is around a session. What is pointed to must outlive it.
struct Surroundings {
  const Restart* restart = nullptr;    ///< to take a run up from; null for a new one
  live::StatusBoard* board = nullptr;  ///< where others read how far the run is; may be null
  Signals signals = Signals::Heard;
};

/// One run of a model, from time zero or a restart file to its end, with all that is printed and written on
/// the way; before it the dynamic relaxation, if the model has one, step by step as well. It owns the loop,
/// or a caller has it advance step by step.
class RunSession {
 public:
  /// Builds the simulation, prints what it holds and makes the folder of the results. The deck, whose model
  /// must be there, the console and the watch must outlive the session. Throws Error, WriteError.
  RunSession(const Options& options, const deck::ReadResult& deck, const Console& console,
             const Stopwatch& wall, const Surroundings& around = {});

  /// Runs to the end, writes the last state and run.json, and prints the summary. Throws nothing of its own:
  /// what goes wrong is told on the console and by the exit code.
  ExitCode run();

  /// One round of the loop: writes what is due, then takes a step unless the run is at its end. False if it
  /// is, or has failed; then there is an ending(). Throws nothing of its own.
  bool advance();
  /// Hands all rows of tables to the operating system; they wait a tenth of a second at most otherwise.
  /// Throws WriteError.
  void flush() { recorder_->flush(); }
  /// Ends a run that has not come to its end, as an interrupted one.
  void interrupt(std::string reason);
  /// The last part of run(), once, when there is an ending(): last state, run.json, summary.
  ExitCode close();

  const std::optional<Ending>& ending() const { return ending_; }
  timeloop::Simulation& simulation() { return simulation_; }
  const std::filesystem::path& folder() const { return folder_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  output::View view() const;
  void prepare();
  void begin();
  void take_up(const Restart& restart);
  void open_files(const Restart* restart);
  void warn(std::string text);
  domain::StateList own_state();
  void write_restart(RestartKind kind);
  void save_for_restart(Ending& ending);
  Ending gone_wrong(const std::string& reason);
  std::optional<Ending> follow();
  std::optional<Ending> relax();
  void end_relaxation();
  void abandon_relaxation();
  std::optional<Ending> follow_guarded();
  void inspect_during_run();
  void observe();
  std::optional<Ending> asked_to_stop();
  bool refuse_while_relaxing(std::string_view what);
  std::optional<Ending> limit_passed() const;
  void finish(Ending& ending);
  void write_record(const Ending& ending);
  void write_dynain();
  std::vector<std::filesystem::path> written_files() const;

  const Options& options_;
  const deck::ReadResult& deck_;
  const Console& console_;
  const Stopwatch& wall_;
  live::StatusBoard* board_;
  std::filesystem::path folder_;
  timeloop::Simulation simulation_;
  std::unique_ptr<RelaxationPhase> relaxation_;  ///< while it lasts; then the run has not begun
  output::RelaxationRecord relaxed_;             ///< once it has ended
  std::unique_ptr<output::FolderLock> lock_;     ///< longer than all that writes into the folder
  std::unique_ptr<output::Recorder> recorder_;
  std::unique_ptr<Monitor> monitor_;
  std::unique_ptr<StopSignals> signals_;  ///< null if they are left to the caller
  SwitchFile switches_;
  std::unique_ptr<RestartWriter> restart_writer_;
  RestartSettings restart_settings_;
  GoodState good_state_;
  output::PeakValues peaks_;
  InspectionTimes inspection_times_;
  domain::EarlierVelocities earlier_;
  std::optional<std::filesystem::path> dynain_;  ///< once it is written
  std::vector<std::string> warnings_;
  std::optional<Ending> ending_;
  double first_step_ = 0;    ///< [time]
  double total_mass_ = 0;    ///< at time zero [mass]
  double loop_seconds_ = 0;  ///< wall time of the cycles, those before a restart included [s]
};

}  // namespace crumple::app
