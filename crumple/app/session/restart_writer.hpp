// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/session/restart_settings.hpp"
#include "base/stopwatch.hpp"
#include "domain/domain.hpp"
#include "model/output_requests.hpp"

namespace crumple::app {

/// Folder of the restart files in that of the results, and the newest file in it.
inline constexpr const char* restart_folder = "restart";
inline constexpr const char* newest_restart = "latest.restart";
/// Behind the names of files that have been set aside.
inline constexpr const char* damaged_ending = ".damaged";
inline constexpr const char* abandoned_ending = ".abandoned";
/// The file before the newest (1), the one before that (2), ...
std::string earlier_restart(int age);

/// What a restart file is made from, between two steps.
struct RestartSource {
  const domain::StateList& simulation;
  const domain::StateList& files;
  const RestartSettings& settings;
};

/// Which restart file to write.
enum class RestartKind {
  Due,       ///< those that are due now
  Newest,    ///< the newest file, whether it is due or not
  LastGood,  ///< the state before an error, beside the others
};

/// Writes restart files when they are due. Those that replace each other keep the one before until the new
/// one is whole, so that there is a good one at any moment.
class RestartWriter {
 public:
  RestartWriter(std::filesystem::path folder, const model::RestartRequests& deck,
                const RestartInterval& asked, const domain::Clock& clock);

  /// The run was taken up from this file of the same folder.
  void goes_on_from(const std::filesystem::path& file, const domain::Clock& clock);

  /// Whether a file is due after this cycle.
  bool due(const domain::Clock& clock) const;
  /// Whether the user or the deck asks for restart files at all.
  bool wanted() const;
  /// Throws WriteError.
  void write(RestartKind kind, const domain::Clock& clock, const RestartSource& source);

  /// What was written, or taken up, and still lies there.
  std::vector<std::filesystem::path> files() const;
  std::filesystem::path newest() const { return folder_ / newest_restart; }

 private:
  bool running_due(const domain::Clock& clock) const;
  bool dump_due(const domain::Clock& clock) const;
  void write_newest(const domain::Clock& clock, const RestartSource& source);
  void write_file(const std::filesystem::path& path, const domain::Clock& clock,
                  const RestartSource& source) const;
  void keep_earlier() const;

  std::filesystem::path folder_;
  model::RestartRequests deck_;
  RestartInterval asked_;
  Stopwatch since_last_;
  long first_cycle_ = 0;    ///< with which this run of the program began
  long newest_cycle_ = -1;  ///< of the newest file
};

/// The restart files in a folder, also one that has not got its name yet; in alphabetical order.
std::vector<std::filesystem::path> restart_files(const std::filesystem::path& folder);

/// Removes the restart files of an earlier run from a folder of results; only our own.
void remove_restart_files(const std::filesystem::path& results);

}  // namespace crumple::app
