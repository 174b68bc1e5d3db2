// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "domain/state_list.hpp"
#include "output/files/own_file.hpp"

namespace crumple::output {

/// Whether a file of results is made anew or goes on from what lies there.
enum class Opening { New, Continued };

/// A file that only grows, by pieces that are there as a whole or not at all.
class GrowingFile {
 public:
  /// Makes the file, empty; if it is continued, that is left to resume(). Throws WriteError.
  GrowingFile(std::filesystem::path path, Opening opening);

  /// Declares the length of the file, for a restart.
  void declare(domain::StateList& list);
  /// To be called after a restart has filled what was declared: what lies behind that length is cut off. A
  /// file that is not there begins anew. Throws WriteError.
  void resume();

  /// Hands a piece to the operating system, so that it outlives the program. Throws WriteError, also if the
  /// file has been removed meanwhile; then the file is what it was.
  void append(std::string_view piece);

  bool empty() const { return bytes_ == 0; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  OwnFile file_;
  std::uint64_t bytes_ = 0;  ///< in the file
};

}  // namespace crumple::output
