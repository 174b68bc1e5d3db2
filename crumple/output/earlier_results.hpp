// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace crumple::output {

/// Removes from a folder what an earlier run left there and a new one might not write again, so that nobody
/// takes it for the new one's: run.json, the histories, the list of initial penetrations, the report; of
/// files that LS-DYNA names in the same way only those that we wrote. Frames are removed where new ones are
/// written.
void remove_earlier_results(const std::filesystem::path& folder);

/// Removes what only a finished run has: a run that is taken up goes on in the folder.
void remove_ending(const std::filesystem::path& folder);

}  // namespace crumple::output
