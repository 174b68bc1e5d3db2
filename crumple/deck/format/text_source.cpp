// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/text_source.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "files/input_file.hpp"

namespace crumple::deck {

namespace {

LoadedText load(const std::filesystem::path& path) {
  LoadedText loaded;
  loaded.name = path.generic_string();
  loaded.path = path;
  std::error_code fault;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, fault);
  loaded.identity = fault ? loaded.name : canonical.generic_string();
  InputFile input = read_input_file(path);
  loaded.fault = std::move(input.fault);
  if (loaded.fault.empty()) loaded.text = std::move(input.text);
  return loaded;
}

}  // namespace

std::string with_slashes(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

LoadedText DiskSource::deck() {
  return load(deck_);
}

LoadedText DiskSource::include(const std::string& name, const LoadedText& including, SearchFolders folders) {
  const std::filesystem::path path(with_slashes(name));
  if (path.is_absolute()) return load(path);
  LoadedText beside_including = load(including.path.parent_path() / path);
  if (beside_including.text) return beside_including;
  LoadedText beside_deck = load(deck_.parent_path() / path);
  if (beside_deck.text) return beside_deck;
  for (const std::filesystem::path& folder : folders) {
    LoadedText found = load(folder / path);
    if (found.text) return found;
    beside_including.fault +=
        fmt::format("{}\"{}\"", &folder == folders.data() ? ", nor in " : ", ", folder.generic_string());
  }
  return beside_including;
}

LoadedText MemorySource::deck() {
  return {name_, name_, {}, std::string(text_), {}};
}

LoadedText MemorySource::include(const std::string& name, const LoadedText&, SearchFolders folders) {
  auto found = included_->find(name);
  for (auto folder = folders.begin(); found == included_->end() && folder != folders.end(); ++folder)
    found = included_->find((*folder / name).generic_string());
  if (found == included_->end()) return {name, name, {}, std::nullopt, "there is no such file"};
  return {found->first, found->first, {}, found->second, {}};
}

}  // namespace crumple::deck
