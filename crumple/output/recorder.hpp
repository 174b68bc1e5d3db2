// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The output of a run: observers that read the domain between two steps, through a View, and write nothing
// back. A run has the same bits whatever it writes.
//
//     Recorder           what a run writes while it goes on
//       |- frames        ParaviewSeries: <name>.pvd, vtu/<name>_000000.vtu ...              paraview/
//       |                D3plotSeries: d3plot, d3plot01 ..., if asked for                   d3plot/
//       |- tables        History: rows of a CSV file                                        histories/
//       |                SampledHistory: also LS-DYNA's text file and a branch of
//       |                binout0000, with the same numbers, if the deck asks for them       lsdyna/
//       '- at the start  initial_penetrations.csv (initial_overlaps.hpp)
//
// Frames and every table have a Schedule of their own. The caller of a run adds the rest: run.json with the
// state at its end (run_record.hpp), the checks by which a run is accepted (checks.hpp), restart files
// (files/restart_file.hpp).
//
// Files are replaced whole or grow by whole rows (files/), so that they can be read at any moment, also after
// the program was killed. Rows reach them ten times a second: a call of the operating system for each may
// cost more than the step. How far each has come is declared for a restart; resume() cuts off what is beyond
// it, so that a run that was taken up again leaves the same bytes.
//
// Order of calls: constructor, write_due() at time zero and after every step, write_last() at the end; for a
// restart flush() and declare(), then resume() before the first write_due(). results/ has what several
// formats show (stresses in global axes, masses of parts), each computed once. How to add an output:
// docs/adding_an_output.md.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/d3plot/d3plot_series.hpp"
#include "output/files/csv_file.hpp"
#include "output/histories/history.hpp"
#include "output/histories/sampled_history.hpp"
#include "output/histories/schedule.hpp"
#include "output/lsdyna/binout.hpp"
#include "output/lsdyna/text_file.hpp"
#include "output/paraview/paraview_series.hpp"
#include "output/results/view.hpp"

namespace crumple::output {

/// Frames of a run if the deck does not ask for an interval.
inline constexpr int default_frames = 100;

/// What the deck does not ask for and the user may.
struct ExtraFiles {
  bool d3plot = false;             ///< LS-DYNA's files of the frames, beside ParaView's
  bool all_fields = false;         ///< stress tensors and more in ParaView's frames
  Opening opening = Opening::New;  ///< whether all files are made anew
};

/// Everything that a run writes while it goes on.
class Recorder {
 public:
  /// Makes the folder and the files in it; `name` is that of the frames. If they are continued, their content
  /// is left to resume(). Throws WriteError.
  Recorder(const std::filesystem::path& folder, const std::string& name, const View& view,
           const ExtraFiles& extra = {});

  /// Declares how far all files have come, for a restart.
  void declare(domain::StateList& list);
  /// To be called after a restart has filled what was declared: what the files hold beyond it is cut off. A
  /// d3plot family that holds less is set aside under other names, and begins anew, which the sentences say;
  /// for the other files see set_short_files_aside(). Throws WriteError.
  std::vector<std::string> resume(const domain::Clock& clock);

  /// Writes what is due at this time. To be called once at time zero and after every step. Throws WriteError.
  void write_due(const View& view);
  /// Writes the present state to the frames and all histories, unless it is there already.
  void write_last(const View& view);
  /// Adds a frame of the present state, due or not, unless it is there already.
  void write_frame(const View& view);
  /// Hands all rows to the operating system, so that they outlive the program. Throws WriteError.
  void flush();

  int frames() const { return series_.frames(); }
  /// What was written, the most useful first.
  std::vector<std::filesystem::path> files() const;

 private:
  /// Where LS-DYNA's forms of a history go, if the deck asks for them.
  struct ForeignForm {
    SampledHistory* history;
    std::optional<std::size_t> text;    ///< in texts_; several may share one
    std::optional<std::size_t> branch;  ///< of binout
  };
  struct Table {
    CsvFile file;
    Schedule schedule;
    std::unique_ptr<History> history;
    std::vector<ForeignForm> foreign;
  };
  void ask_for_foreign_forms(const std::filesystem::path& folder, const View& view, Opening opening);
  std::size_t text_of(const std::filesystem::path& path, Opening opening);
  void write_rows(Table& table, const View& view);

  std::filesystem::path folder_;
  ParaviewSeries series_;
  std::optional<D3plotSeries> d3plot_;
  Schedule frame_schedule_;
  std::vector<Table> tables_;
  std::vector<TextFile> texts_;
  std::optional<Binout> binout_;
  std::vector<std::filesystem::path> start_files_;  ///< written once
  bool has_waiting_rows_ = false;
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

}  // namespace crumple::output
