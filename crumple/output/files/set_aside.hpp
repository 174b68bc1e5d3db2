// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "domain/state_list.hpp"

namespace crumple::output {

/// Files that a run is to go on in, but that hold less than they did when the restart file was written: their
/// end was lost, or an older restart file has been taken up since. They are renamed, so that nothing is lost.
/// `list` holds the lengths that they should have, as `<file>_bytes`. Returns a sentence for each.
std::vector<std::string> set_short_files_aside(const std::filesystem::path& folder,
                                               const domain::StateList& list);

/// The same for all files of a d3plot family.
std::vector<std::string> set_family_aside(const std::filesystem::path& folder);

}  // namespace crumple::output
