// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The only way in which this program makes files. A folder of results may come from somebody else, with
// links, pipes or devices under the names that a run or a report writes to: nothing is ever written through
// them.
//
// A new file is made beside its place, under a random name, exclusively (O_EXCL, which follows no link), and
// then renamed, which replaces a link and not what it leads to. A file that goes on is opened without
// following a link, must be regular, and is copied first if it has a second name elsewhere.

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace crumple::output {

/// A file of results, open for writing. All faults throw WriteError with the file and the system's reason.
class OwnFile {
 public:
  OwnFile() = default;
  OwnFile(OwnFile&& other) noexcept;
  OwnFile& operator=(OwnFile&& other) noexcept;
  OwnFile(const OwnFile&) = delete;
  OwnFile& operator=(const OwnFile&) = delete;
  ~OwnFile();

  /// A new, empty file at once in its place.
  static OwnFile create(const std::filesystem::path& path);
  /// A file that is there, to be written on.
  static OwnFile open(const std::filesystem::path& path);

  explicit operator bool() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }
  std::uint64_t size() const;
  void truncate(std::uint64_t bytes);
  void write_at(std::uint64_t place, std::string_view bytes);
  /// Throws if the file has been removed or replaced: what is written then would be lost.
  void require_name() const;
  /// Hands what was written over; a full disk may show only here.
  void close();

 private:
  friend class NewFile;
  [[noreturn]] void fail() const;

  std::filesystem::path path_;  ///< for messages
  int descriptor_ = -1;
};

/// A file that is written beside its place and takes it when it is complete.
class NewFile {
 public:
  explicit NewFile(std::filesystem::path path);
  /// Removes what was not put in place.
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(std::string_view bytes);
  /// To the disk, with all else that the file system holds of this run: see write_restart_file.
  void synchronize();
  /// Takes the place of what was there. `path` must not be a folder, nor lead to a device, pipe or socket.
  void put_in_place();

 private:
  friend class OwnFile;
  void rename();

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  OwnFile file_;
  std::uint64_t bytes_ = 0;
  bool in_place_ = false;
};

/// Removes what killed runs left of files that they had not put in place, but for those of a report, which
/// may be in the making.
void remove_unfinished_files(const std::filesystem::path& folder);

}  // namespace crumple::output
