// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/core.h>

#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>

#include "output/files/growing_file.hpp"

namespace crumple::output {

/// A table of comma-separated values with a header line, written in whole rows. Numbers have as many digits
/// as it takes to read the same double back.
class CsvFile {
 public:
  /// Makes the file and writes the header; if it is continued, that is left to resume(). Throws WriteError.
  CsvFile(std::filesystem::path path, std::string_view header, Opening opening = Opening::New);

  /// Declares the length of the file, for a restart.
  void declare(domain::StateList& list) { file_.declare(list); }
  /// To be called after a restart has filled what was declared: rows behind that length, which the run wrote
  /// after the restart file, are cut off. A file that is not there begins anew. Throws WriteError.
  void resume();

  /// Appends a row to the memory of the table; it reaches the file with the next flush.
  template <class... Values>
  void add_row(const Values&... values) {
    std::string_view separator;
    ((fmt::format_to(std::back_inserter(rows_), "{}{}", separator, values), separator = ","), ...);
    rows_ += '\n';
  }

  /// Hands all rows to the operating system, so that they outlive the program. Throws WriteError.
  void flush();

  const std::filesystem::path& path() const { return file_.path(); }

 private:
  GrowingFile file_;
  std::string header_;  ///< with the end of its line
  std::string rows_;
};

}  // namespace crumple::output
