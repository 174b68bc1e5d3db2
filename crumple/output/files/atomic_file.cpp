// SPDX-License-Identifier: BSD-3-Clause
#include "output/files/atomic_file.hpp"

#include <fmt/core.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "output/files/own_file.hpp"
#include "output/files/write_error.hpp"

namespace crumple::output {

void write_atomically(const std::filesystem::path& path, std::string_view content) {
  NewFile file(path);
  file.write(content);
  file.put_in_place();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault || !std::filesystem::is_directory(folder))
    throw WriteError(fmt::format("Cannot make the folder {}: {}.", folder.string(),
                                 fault ? fault.message() : "a file of that name exists"));
}

void require_no_link(const std::filesystem::path& folder) {
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(folder)))
    throw WriteError(
        fmt::format("Cannot write into {}: it is a link, not a folder of the results.", folder.string()));
}

void make_subfolder(const std::filesystem::path& folder) {
  if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST)
    throw WriteError(fmt::format("Cannot write {}: {}.", folder.string(), std::strerror(errno)));
  require_no_link(folder);
  if (!std::filesystem::is_directory(folder))
    throw WriteError(fmt::format("Cannot make the folder {}: a file of that name exists.", folder.string()));
}

}  // namespace crumple::output
