// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace crumple::report {

/// All bytes of a file. Throws Error with its name and the system's reason.
std::string read_file(const std::filesystem::path& file);

}  // namespace crumple::report
