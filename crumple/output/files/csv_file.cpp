// SPDX-License-Identifier: BSD-3-Clause
#include "output/files/csv_file.hpp"

#include <utility>

namespace crumple::output {

CsvFile::CsvFile(std::filesystem::path path, std::string_view header, Opening opening)
    : file_(std::move(path), opening), header_(fmt::format("{}\n", header)) {
  if (opening == Opening::New) file_.append(header_);
}

void CsvFile::resume() {
  file_.resume();
  if (file_.empty()) file_.append(header_);
}

void CsvFile::flush() {
  if (rows_.empty()) return;
  const std::string rows = std::exchange(rows_, {});
  file_.append(rows);
}

}  // namespace crumple::output
