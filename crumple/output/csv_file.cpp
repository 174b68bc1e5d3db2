// SPDX-License-Identifier: BSD-3-Clause
#include "output/csv_file.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "output/write_error.hpp"

namespace crumple::output {

CsvFile::CsvFile(std::filesystem::path path, std::string_view header, Opening opening)
    : path_(std::move(path)), header_(header) {
  if (opening == Opening::Continued) return;
  open("wb");
}

void CsvFile::open(const char* mode) {
  file_.reset(std::fopen(path_.c_str(), mode));
  if (!file_) throw WriteError(fmt::format("Cannot write {}: {}.", path_.string(), std::strerror(errno)));
  // Each flush is one write: nothing is left over for later if it fails.
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
  if (bytes_ > 0) return;
  rows_ = header_ + "\n";
  flush();
}

void CsvFile::declare(domain::StateList& list) {
  list.keep(path_.filename().string() + "_bytes", "-", domain::Entity::Run, bytes_);
}

void CsvFile::resume() {
  std::error_code fault;
  const std::uintmax_t there = std::filesystem::file_size(path_, fault);
  if (fault || there < bytes_ || bytes_ == 0) {
    bytes_ = 0;
    open("wb");
    return;
  }
  std::filesystem::resize_file(path_, bytes_, fault);
  if (fault) throw WriteError(fmt::format("Cannot write {}: {}.", path_.string(), fault.message()));
  open("ab");
}

void CsvFile::flush() {
  const bool good = std::fwrite(rows_.data(), 1, rows_.size(), file_.get()) == rows_.size() &&
                    std::fflush(file_.get()) == 0;
  const int reason = errno;
  const std::size_t added = rows_.size();
  rows_.clear();
  if (good) {
    bytes_ += added;
    return;
  }
  // Half a row would be no table any more.
  std::error_code ignored;
  std::filesystem::resize_file(path_, bytes_, ignored);
  throw WriteError(fmt::format("Cannot write {}: {}.", path_.string(), std::strerror(reason)));
}

}  // namespace crumple::output
