// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "app/console/console.hpp"
#include "base/stopwatch.hpp"
#include "output/files/csv_file.hpp"
#include "output/relaxation_record.hpp"
#include "timeloop/dynamic_relaxation.hpp"

namespace crumple::app {

inline constexpr const char* relaxation_file = "relax.csv";

/// The dynamic relaxation of a session, before its run: its steps, a row of relax.csv for each check, and a
/// line on the console for some of them.
class RelaxationPhase {
 public:
  /// Makes the first state. The model and the console must outlive this. Throws Error.
  RelaxationPhase(const model::Model& model, const domain::Execution& execution, const Console& console,
                  bool quiet);

  /// Makes relax.csv in the folder of the results. Before the first step. Throws WriteError.
  void open(const std::filesystem::path& folder);
  /// One step. Throws NumericalError, WriteError.
  void step();
  bool finished() const { return relaxation_.finished(); }
  /// Writes and prints what is still to be. Throws WriteError.
  void close();

  /// Prints how far it is at once.
  void print_line();

  output::RelaxationRecord record() const;
  timeloop::Simulation& simulation() { return relaxation_.simulation(); }

 private:
  void add_row();

  timeloop::DynamicRelaxation relaxation_;
  const Console& console_;
  bool quiet_;
  std::optional<output::CsvFile> table_;
  Stopwatch since_start_;
  double next_line_seconds_ = 0;  ///< wall time [s]
  long line_cycle_ = -1;          ///< of the last line
};

/// One line about a relaxation that has ended.
void print_relaxation(const Console& console, const output::RelaxationRecord& record);

}  // namespace crumple::app
