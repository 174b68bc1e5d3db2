// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/stopwatch.hpp"

namespace crumple::app {

/// What a user may ask of a run while it goes on, by LS-DYNA's names.
enum class Switch {
  Stop,     ///< sw1
  Status,   ///< sw2
  Restart,  ///< sw3, which needs restart files
  Frame,    ///< sw4
  Unknown,
};

/// The switch that the content of a d3kil file names: its first word, in either case.
Switch parse_switch(std::string_view content);

/// Looks for a file `d3kil`, reads it and removes it.
class SwitchFile {
 public:
  /// `folders` are those where the file may lie.
  explicit SwitchFile(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

  /// The switch that has been thrown, if any. Looks twice a second at most, so it can be called every step.
  std::optional<Switch> poll();
  /// Looks at once.
  std::optional<Switch> look();

 private:
  std::vector<std::filesystem::path> folders_;
  Stopwatch since_look_;
};

}  // namespace crumple::app
