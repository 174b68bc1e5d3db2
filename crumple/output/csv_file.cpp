// SPDX-License-Identifier: BSD-3-Clause
#include "output/csv_file.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include "output/write_error.hpp"

namespace crumple::output {

CsvFile::CsvFile(std::filesystem::path path, std::string_view header)
    : path_(std::move(path)), file_(std::fopen(path_.c_str(), "wb")) {
  if (!file_) throw WriteError(fmt::format("Cannot write {}: {}.", path_.string(), std::strerror(errno)));
  rows_ = header;
  rows_ += '\n';
  flush();
}

void CsvFile::flush() {
  const bool good = std::fwrite(rows_.data(), 1, rows_.size(), file_.get()) == rows_.size() &&
                    std::fflush(file_.get()) == 0;
  rows_.clear();
  if (!good) throw WriteError(fmt::format("Cannot write {}: {}.", path_.string(), std::strerror(errno)));
}

}  // namespace crumple::output
