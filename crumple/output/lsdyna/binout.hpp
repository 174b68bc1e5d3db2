// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "output/lsdyna/lsda_file.hpp"
#include "output/results/history_sample.hpp"

namespace crumple::output {

/// By this we know our own files: the name of an array and its content, near the start.
inline constexpr std::string_view binout_mark = "revisioncrumple";

/// LS-DYNA's binout: all histories in one file, each a branch of its tree with the states d000001, d000002
/// ...
class Binout {
 public:
  /// Makes the file for branches of those names; if it is continued, that is left to resume(). Throws
  /// WriteError.
  Binout(std::filesystem::path path, std::string title, std::vector<std::string> branches,
         Opening opening = Opening::New);

  /// Declares the length of the file and the states in it, for a restart.
  void declare(domain::StateList& list);
  /// To be called after a restart has filled what was declared: states behind those are cut off. A file that
  /// is not there begins anew. Throws WriteError.
  void resume();

  /// Adds a state to a branch, by its place; it reaches the file with the next flush.
  void add(std::size_t branch, const HistoryForm& form, const HistoryItems& items, const Sample& sample);
  /// Ends the group of states that belong together in the file.
  void end_group() { file_.end_group(); }
  /// Makes what was added readable. Throws WriteError; then nothing was.
  void flush();

  const std::filesystem::path& path() const { return file_.path(); }

 private:
  void add_metadata(const HistoryForm& form, const HistoryItems& items);

  struct Progress {
    long states = 0;
    std::uint64_t items = 0;  ///< fingerprint of those that the metadata name
  };
  struct Branch {
    std::string name;
    Progress in_file{};
    Progress with_added{};  ///< once it is flushed
  };
  LsdaFile file_;
  std::string title_;
  std::vector<Branch> branches_;
};

}  // namespace crumple::output
