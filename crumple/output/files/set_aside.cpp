// SPDX-License-Identifier: BSD-3-Clause
#include "output/files/set_aside.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <cstring>
#include <string_view>
#include <system_error>

namespace crumple::output {

namespace {

constexpr std::string_view ending = "_bytes";

std::string set_aside(const std::filesystem::path& path) {
  std::filesystem::path other = path;
  other.replace_filename("before_restart_" + path.filename().string());
  std::error_code ignored;
  std::filesystem::rename(path, other, ignored);
  return fmt::format(
      "{} holds less than when the restart file was written: it is called {} now, and begins anew.",
      path.string(), other.filename().string());
}

}  // namespace

std::vector<std::string> set_short_files_aside(const std::filesystem::path& folder,
                                               const domain::StateList& list) {
  std::vector<std::string> notes;
  for (const domain::StateArray& array : list.arrays()) {
    std::uint64_t expected = 0;
    if (!array.name.ends_with(ending) || array.bytes.size() != sizeof(expected)) continue;
    std::memcpy(&expected, array.bytes.data(), sizeof(expected));
    const std::filesystem::path path = folder / array.name.substr(0, array.name.size() - ending.size());
    std::error_code fault;
    const std::uintmax_t there = std::filesystem::file_size(path, fault);
    if (!fault && there < expected) notes.push_back(set_aside(path));
  }
  return notes;
}

std::vector<std::string> set_family_aside(const std::filesystem::path& folder) {
  std::vector<std::string> notes;
  std::vector<std::filesystem::path> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with("d3plot")) found.push_back(entry.path());
  notes.reserve(found.size());
  for (const std::filesystem::path& path : found) notes.push_back(set_aside(path));
  return notes;
}

}  // namespace crumple::output
