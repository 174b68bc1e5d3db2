// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/arguments/command_line.hpp"

namespace crumple::app {

/// The browser that draws: CHROMIUM of the environment, else chromium, chromium-browser or google-chrome on
/// the path. Throws Error that says how to get one.
std::filesystem::path find_browser();

/// The address of a report that shows what the options ask for, at a frame.
std::string picture_address(const std::filesystem::path& report, const PictureOptions& options,
                            const std::string& frame);

/// Draws one picture for each frame that is asked for, beside the report: `report_1.png`, ... Throws Error if
/// the browser draws none.
std::vector<std::filesystem::path> draw_pictures(const std::filesystem::path& report,
                                                 const PictureOptions& options);

}  // namespace crumple::app
