// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace crumple::app {

/// What `crumple compare` is asked for.
struct CompareOptions {
  std::filesystem::path reference;      ///< folder or file
  std::filesystem::path other;          ///< folder or file
  std::vector<std::string> quantities;  ///< empty is all
  std::vector<std::string> pairs;       ///< `NAME=NAME`
  std::optional<std::filesystem::path> json;
  std::optional<std::filesystem::path> html;
  std::filesystem::path template_file;  ///< empty looks for the one that was built
  int cfc = 0;                          ///< channel frequency class [Hz]; 0 is none
  std::string time_unit;                ///< s, ms or us; empty is that of run.json
  std::optional<double> interval;       ///< between samples [time]
  std::optional<double> tolerance;      ///< of the peak of the reference [-]
  double floor = 0.01;                  ///< of the largest curve of a kind [-]
  std::size_t rows = 40;                ///< of the table; 0 is all
  bool list = false;
  bool quiet = false;
};

}  // namespace crumple::app
