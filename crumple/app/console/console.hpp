// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

namespace crumple::app {

/// Where the program talks to its user.
struct Console {
  std::ostream& out;      ///< results and progress
  std::ostream& err;      ///< errors and warnings
  bool terminal = false;  ///< `out` is a terminal: a line may be written over
};

}  // namespace crumple::app
