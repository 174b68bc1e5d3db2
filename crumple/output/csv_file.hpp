// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>

namespace crumple::output {

/// A table of comma-separated values with a header line, written in whole rows. Numbers have as many digits
/// as it takes to read the same double back.
class CsvFile {
 public:
  /// Makes the file and writes the header. Throws WriteError.
  CsvFile(std::filesystem::path path, std::string_view header);

  /// Appends a row to the memory of the table; it reaches the file with the next flush.
  template <class... Values>
  void add_row(const Values&... values) {
    std::string_view separator;
    ((fmt::format_to(std::back_inserter(rows_), "{}{}", separator, values), separator = ","), ...);
    rows_ += '\n';
  }

  /// Hands all rows to the operating system, so that they outlive the program. Throws WriteError.
  void flush();

  const std::filesystem::path& path() const { return path_; }

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Closer> file_;
  std::string rows_;
};

}  // namespace crumple::output
