// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace crumple::report {

/// Files of one moment of a run.
struct FrameFiles {
  double time = 0;              ///< as the collection has it [time]
  std::filesystem::path grid;   ///< the model
  std::filesystem::path walls;  ///< rigid walls that have a shape; empty if there are none
};

/// What a run left in its folder.
struct ResultFolder {
  std::filesystem::path folder;
  std::string name;                           ///< of the frames, which is that of the deck
  std::vector<FrameFiles> frames;             ///< at least one
  std::vector<std::filesystem::path> tables;  ///< histories, `*.csv`, by name
  bool has_record = false;                    ///< run.json is there: the run has ended
  std::filesystem::path scatter;  ///< folder of `crumple scatter` whose unperturbed run this is; else empty
};

/// Looks through a folder; of a folder of `crumple scatter` through that of its unperturbed run. Throws Error
/// if there is none, if it holds no frames, or frames of several runs that run.json does not choose from.
ResultFolder open_results(const std::filesystem::path& folder);

}  // namespace crumple::report
