// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace crumple::app {

/// Rewrites a command line as LS-DYNA (`i=deck.k ncpu=2 memory=200m endtime=0.01`) or OpenRadioss
/// (`-i deck.k -nt 2`) spells it into crumple's own; any other is returned as it is. Arguments without a
/// meaning here are dropped with a sentence in `notes`; unknown ones throw Error.
std::vector<std::string> translate_foreign_arguments(const std::vector<std::string>& arguments,
                                                     std::vector<std::string>& notes);

}  // namespace crumple::app
