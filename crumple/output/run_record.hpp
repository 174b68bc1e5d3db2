// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "output/checks.hpp"
#include "output/relaxation_record.hpp"
#include "output/results/view.hpp"

namespace crumple::output {

/// Why something of a deck does not take part in a run.
enum class LeftOutReason {
  WithoutEffect,  ///< it does not change what is computed
  OnRequest,      ///< it does: --allow-unsupported left it out
  NotSupported,   ///< it does, and the deck is refused for it
};

/// "without effect", "on request" or "not supported".
const char* name_of(LeftOutReason reason);

/// A keyword, or a value of a field, that does not take part.
struct LeftOut {
  std::string name;  ///< "*DATABASE_ABSTAT", "*SECTION_SHELL ELFORM 13"
  LeftOutReason reason = LeftOutReason::WithoutEffect;
  int count = 1;      ///< how often it occurs
  std::string place;  ///< the first, as "deck.k:12"
};

/// A parameter of the deck with the value that was taken.
struct RunParameter {
  std::string name;
  std::string value;
  bool by_command_line = false;
};

/// What `run.json` says beside what the model and the domain know.
struct RunRecord {
  std::string version;
  std::string deck;
  std::uint64_t deck_hash = 0;
  std::uint64_t deck_hash_with_parameters = 0;  ///< and those that the command line set
  std::vector<std::string> command;             ///< arguments of the program
  std::string options;  ///< options of the command line as JSON; empty if the caller has none
  std::vector<RunParameter> parameters;
  double perturbation = 0;  ///< largest random move of a node over the diagonal of the model [-]
  std::uint64_t seed = 0;   ///< of these moves
  RelaxationRecord relaxation;
  std::string units;        ///< guess, such as "kg, mm, ms"; empty if there is none
  std::string termination;  ///< "normal", "error" or "interrupted"
  std::string reason;
  double wall_seconds = 0;  ///< of the whole program, reading included [s]
  double loop_seconds = 0;  ///< of the cycles, output included [s]
  std::uint64_t peak_memory_bytes = 0;
  std::uint64_t state_hash = 0;
  std::vector<Check> checks;
  std::vector<std::string> warnings;
  std::vector<LeftOut> left_out;
  std::vector<std::filesystem::path> files;  ///< relative to the folder
};

/// Wall time of the loop by thread, element and cycle [ns]; 0 before the first cycle.
double nanoseconds_per_element_cycle(const domain::Domain& domain, double seconds);

/// Writes `run.json` as a whole. Numbers that are not finite become null. Throws WriteError.
void write_run_record(const std::filesystem::path& folder, const RunRecord& record, const View& view);

}  // namespace crumple::output
