// SPDX-License-Identifier: BSD-3-Clause
#include "output/files/atomic_file.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "output/files/write_error.hpp"

namespace crumple::output {

void write_atomically(const std::filesystem::path& path, std::string_view content) {
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (file == nullptr)
    throw WriteError(fmt::format("Cannot write {}: {}.", path.string(), std::strerror(errno)));
  // A full disk shows in fwrite or only when the buffers are flushed by fclose.
  bool good = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  int reason = good ? 0 : errno;
  if (std::fclose(file) != 0 && good) {
    good = false;
    reason = errno;
  }
  std::error_code ignored;
  if (good && std::rename(temporary.c_str(), path.c_str()) == 0) return;
  if (good) reason = errno;
  std::filesystem::remove(temporary, ignored);
  throw WriteError(fmt::format("Cannot write {}: {}.", path.string(), std::strerror(reason)));
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault || !std::filesystem::is_directory(folder))
    throw WriteError(fmt::format("Cannot make the folder {}: {}.", folder.string(),
                                 fault ? fault.message() : "a file of that name exists"));
}

}  // namespace crumple::output
