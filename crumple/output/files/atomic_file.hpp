// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

namespace crumple::output {

/// Replaces a file as a whole: writes beside it, then renames. Whoever opens `path`, at any moment and even
/// if the program is killed, finds either the old content or all of the new. Throws WriteError; the old file
/// then is untouched and nothing is left beside it.
void write_atomically(const std::filesystem::path& path, std::string_view content);

/// Makes a folder with all its parents, unless it is there. Throws WriteError.
void make_folder(const std::filesystem::path& folder);

/// Makes a folder in one of results, unless it is there. That may be a link, set by the user, but none in it:
/// throws WriteError.
void make_subfolder(const std::filesystem::path& folder);
/// Throws WriteError if it is one.
void require_no_link(const std::filesystem::path& folder);

}  // namespace crumple::output
