// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace cellsearch::bench {

/// What the user asks for.
struct Options {
  std::vector<int> scenes{};                ///< family numbers; empty: all
  std::vector<int> nodes{10000, 100000};    ///< sizes of scenes
  std::vector<std::string> methods{"all"};  ///< names, or "all", "own", "peers"
  std::vector<int> threads{1};
  int repeats = 5;
  double seconds = 20.0;  ///< a method stops repeating after so much time on a scene
  bool shuffled = false;
  std::string csv{};    ///< empty: none
  std::string plots{};  ///< folder; empty: none
  bool list = false;
  bool help = false;
};

/// The command line cannot be understood. The message is a sentence for the user.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the command line without the program's name. Throws UsageError.
Options parse_options(const std::vector<std::string>& arguments);

/// What --help prints.
std::string help_text();

}  // namespace cellsearch::bench
