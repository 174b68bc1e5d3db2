// SPDX-License-Identifier: BSD-3-Clause
#include "output/files/growing_file.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "output/files/write_error.hpp"

namespace crumple::output {

GrowingFile::GrowingFile(std::filesystem::path path, Opening opening) : path_(std::move(path)) {
  if (opening == Opening::New) open("wb");
}

void GrowingFile::open(const char* mode) {
  file_.reset(std::fopen(path_.c_str(), mode));
  if (!file_) throw WriteError(fmt::format("Cannot write {}: {}.", path_.string(), std::strerror(errno)));
  // Each piece is one write: nothing is left over for later if it fails.
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
}

void GrowingFile::declare(domain::StateList& list) {
  list.keep(path_.filename().string() + "_bytes", "-", domain::Entity::Run, bytes_);
}

void GrowingFile::resume() {
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

void GrowingFile::append(std::string_view piece) {
  const bool good = std::fwrite(piece.data(), 1, piece.size(), file_.get()) == piece.size();
  const int reason = errno;
  if (good) {
    bytes_ += piece.size();
    return;
  }
  // Half a piece would be read as a whole one.
  std::error_code ignored;
  std::filesystem::resize_file(path_, bytes_, ignored);
  throw WriteError(fmt::format("Cannot write {}: {}.", path_.string(), std::strerror(reason)));
}

}  // namespace crumple::output
