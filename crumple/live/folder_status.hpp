// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "live/run_status.hpp"

namespace crumple::live {

/// How far the run is that left, or is leaving, its results in a folder: running as long as there is no
/// run.json. Speed and end time are not known before. A folder without a frame, or without anything, is one
/// of a run that starts.
RunStatus folder_status(const std::filesystem::path& folder);

}  // namespace crumple::live
