// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "domain/state_list.hpp"
#include "domain/state_snapshot.hpp"

namespace crumple::output {

/// What a restart file says besides the state.
struct RestartRecord {
  std::string version;   ///< of the program
  std::string settings;  ///< JSON of whoever owns the run; not read here
  double time = 0;       ///< [time]
  long cycle = 0;
  std::vector<std::string> texts;  ///< of the deck, in an order that `settings` knows
};

/// A restart file in memory.
struct RestartContent {
  RestartRecord record;
  domain::StateSnapshot simulation;
  domain::StateSnapshot files;  ///< of what writes the results
};

/// Writes a restart file, one in itself: the texts of the deck, the state of the simulation and that of the
/// files being written, with a checksum. It is written beside and renamed, and on the disk when this returns.
/// Throws WriteError; a file of that name then is untouched.
void write_restart_file(const std::filesystem::path& path, const RestartRecord& record,
                        const domain::StateList& simulation, const domain::StateList& files);

/// Reads it back. Throws Error, a sentence, for a file that is none, is damaged or of another format.
RestartContent read_restart_file(const std::filesystem::path& path);

}  // namespace crumple::output
