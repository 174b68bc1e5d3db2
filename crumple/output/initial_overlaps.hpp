// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "output/results/view.hpp"

namespace crumple::output {

/// Writes initial_penetrations.csv: the nodes that overlapped segments when contact began, of each interface
/// the deepest first. Returns its path, or nothing if there were none and so no file. Throws WriteError.
std::optional<std::filesystem::path> write_initial_overlaps(const std::filesystem::path& folder,
                                                            const View& view);

}  // namespace crumple::output
