// SPDX-License-Identifier: BSD-3-Clause
#include "output/files/growing_file.hpp"

#include <system_error>
#include <utility>

#include "output/files/write_error.hpp"

namespace crumple::output {

GrowingFile::GrowingFile(std::filesystem::path path, Opening opening) : path_(std::move(path)) {
  if (opening == Opening::New) file_ = OwnFile::create(path_);
}

void GrowingFile::declare(domain::StateList& list) {
  list.keep(path_.filename().string() + "_bytes", "-", domain::Entity::Run, bytes_);
}

void GrowingFile::resume() {
  std::error_code fault;
  const std::uintmax_t there = std::filesystem::file_size(path_, fault);
  if (fault || there < bytes_ || bytes_ == 0) {
    bytes_ = 0;
    file_ = OwnFile::create(path_);
    return;
  }
  file_ = OwnFile::open(path_);
  file_.truncate(bytes_);
}

void GrowingFile::append(std::string_view piece) {
  file_.require_name();
  try {
    file_.write_at(bytes_, piece);
  } catch (const WriteError&) {
    // Half a piece would be read as a whole one.
    file_.truncate(bytes_);
    throw;
  }
  bytes_ += piece.size();
}

}  // namespace crumple::output
