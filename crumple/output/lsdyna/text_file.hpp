// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/model.hpp"
#include "output/files/growing_file.hpp"
#include "output/results/history_sample.hpp"

namespace crumple::output {

/// The line of LS-DYNA's files that names the program; by it we know our own.
inline constexpr std::string_view program_mark = "crumple (version ";

/// Version of the program, such as "0.1.0".
std::string_view program_version();
/// Month, day and year, as LS-DYNA writes them: ten characters.
std::string today();

/// One of LS-DYNA's text files over time, such as glstat; it grows by whole blocks.
class TextFile {
 public:
  /// Makes the file, empty; if it is continued, that is left to resume(). Throws WriteError.
  explicit TextFile(std::filesystem::path path, Opening opening = Opening::New);

  /// Declares the length of the file, for a restart.
  void declare(domain::StateList& list) { file_.declare(list); }
  /// To be called after a restart has filled what was declared: blocks behind that length are cut off. A file
  /// that is not there begins anew. Throws WriteError.
  void resume() { file_.resume(); }

  /// Adds the block of a time, before the first one the head; it reaches the file with the next flush.
  void add(const std::string& title, const HistoryForm& form, const HistoryItems& items,
           const Sample& sample);
  /// Hands all blocks to the operating system, so that they outlive the program. Throws WriteError.
  void flush();

  const std::filesystem::path& path() const { return file_.path(); }

 private:
  GrowingFile file_;
  std::string text_;  ///< not in the file yet
};

}  // namespace crumple::output
