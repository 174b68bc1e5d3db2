// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/arguments/command_line.hpp"
#include "deck/format/recorded_source.hpp"
#include "output/files/restart_file.hpp"

namespace crumple::app {

/// What a restart file says about how its run was begun.
struct RestartSettings {
  Options options;                        ///< those that the run depends on
  std::vector<deck::RecordedText> texts;  ///< of the deck
  std::vector<std::string> warnings;      ///< so far
};

/// A restart file that a run is taken up from.
struct Restart {
  std::filesystem::path file;  ///< the one that was read
  output::RestartContent content;
  RestartSettings settings;
  std::string note;  ///< to the user; empty if there is nothing to say
};

/// The options that a run depends on, as JSON, without the parameters of the deck.
std::string options_text(const Options& options);

/// The part of a restart file that is read back by read_restart(), with copies of all texts.
output::RestartRecord make_restart_record(const RestartSettings& settings);

/// Reads a restart file, or the newest good one of a folder of results or of restart files. Throws Error.
Restart read_restart(const std::filesystem::path& place);

/// Renames in a folder of results what is not of the run that is taken up: files that cannot be read, and
/// those of a later time, which that run will not come to in the same way.
void set_restart_files_aside(const std::filesystem::path& results, const Restart& restart);

/// The options with which the run goes on: those of the file, but for what may change at a restart.
Options continued_options(const Options& asked, const Restart& restart);

/// The folder of the results that a restart file belongs to. Throws Error for a file that lies elsewhere.
std::filesystem::path continued_folder(const Restart& restart);

}  // namespace crumple::app
