// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace crumple::output {

/// Keeps a folder of results for one run. The file `.crumple.lock` in it says who has it, as "process 4711 on
/// host"; what counts is the system's lock on that file, which ends with the process however that ends, so
/// that the file of a killed run does not block later ones. Where a file system has no locks, the process
/// that the file names must be gone, or on another machine the file must be removed by hand.
class FolderLock {
 public:
  /// Throws WriteError that names the run that has the folder.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  /// False if the file was removed meanwhile by the run that had it.
  bool take();
  std::string owner() const;

  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace crumple::output
