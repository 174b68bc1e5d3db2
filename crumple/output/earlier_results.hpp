// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>

namespace crumple::output {

/// Removes from a folder what an earlier run left there and a new one might not write again, so that nobody
/// takes it for the new one's: run.json, the histories, the list of initial penetrations, the report, frames;
/// of files that LS-DYNA and others name in the same way only those that we wrote.
void remove_earlier_results(const std::filesystem::path& folder);

/// Throws Error if a file that was read lies in the folder under a name that results have: it would be
/// overwritten.
void require_no_output(const std::filesystem::path& folder, std::span<const std::filesystem::path> files);

/// Removes what only a finished run has: a run that is taken up goes on in the folder.
void remove_ending(const std::filesystem::path& folder);

}  // namespace crumple::output
