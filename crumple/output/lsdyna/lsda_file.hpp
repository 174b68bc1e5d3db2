// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "output/files/csv_file.hpp"
#include "output/files/own_file.hpp"

namespace crumple::output {

/// A file in the format LSDA, the one of LS-DYNA's binout: a tree of named arrays, in this machine's order of
/// bytes. Records go to the end of it, each group with a table of what is new, which the table before leads
/// to. A flush links what it adds only when it is there: at any moment a reader that follows the tables finds
/// whole flushes and nothing else. The bytes do not depend on when the file was flushed.
class LsdaFile {
 public:
  /// Makes the file, empty; if it is continued, that is left to resume(). Throws WriteError.
  explicit LsdaFile(std::filesystem::path path, Opening opening = Opening::New);

  /// Declares the length of the file, for a restart.
  void declare(domain::StateList& list);
  /// To be called after a restart has filled what was declared: what came after that length is cut off. False
  /// if the file is not there any more and begins anew. Throws WriteError.
  bool resume();

  /// What is added next lies in this folder of the tree: an absolute path, made as needed.
  void enter(std::string_view folder);
  /// Adds an array under a name of at most 255 characters; empty ones are left out.
  void add(std::string_view name, std::span<const double> values);
  /// The same; of 4 bytes each where that is enough.
  void add(std::string_view name, std::span<const std::int64_t> values);
  /// The same, a character for each byte.
  void add(std::string_view name, std::string_view text);
  void add(std::string_view name, double value) { add(name, std::span<const double>(&value, 1)); }
  void add(std::string_view name, std::int64_t value) { add(name, std::span<const std::int64_t>(&value, 1)); }

  /// Ends the group with its table. It reaches the file with the next flush.
  void end_group();
  /// Ends the group, and makes what was added a part of the file that outlives the program. Throws
  /// WriteError, also if the file has been removed meanwhile; then what waited for the flush is lost.
  void flush();

  const std::filesystem::path& path() const { return path_; }

 private:
  /// A line of the table: where an array is.
  struct Entry {
    std::string folder;
    std::string name;
    std::uint8_t type = 0;
    std::uint64_t record = 0;  ///< place of its record in the file [bytes]
    std::uint64_t values = 0;
  };
  void begin();
  void add_record(std::string_view name, std::uint8_t type, std::uint64_t values, std::string_view bytes);
  std::string table() const;

  std::filesystem::path path_;
  OwnFile file_;
  std::uint64_t length_ = 0;  ///< with what waits [bytes]
  std::string waiting_;       ///< groups that are not in the file yet
  std::string link_;          ///< from the last table in the file to the first of those
  std::string records_;       ///< of the group that is being made
  std::vector<Entry> entries_;
  std::string folder_;
  std::string recorded_folder_;  ///< that the records are in
};

}  // namespace crumple::output
