// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/arguments/command_line.hpp"
#include "app/console/console.hpp"
#include "app/console/exit_code.hpp"

namespace crumple::app {

/// `crumple keywords`: lists what the deck reader knows; of the keywords that are named, cards and fields.
ExitCode list_keywords(const KeywordsOptions& options, const Console& console);

}  // namespace crumple::app
