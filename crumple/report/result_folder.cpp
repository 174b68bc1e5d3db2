// SPDX-License-Identifier: BSD-3-Clause
#include "report/result_folder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "report/scatter_folder.hpp"
#include "report/text_file.hpp"

namespace crumple::report {

namespace {

constexpr std::size_t longest_echo = 200;  ///< of a tag in a message

std::vector<std::filesystem::path> files_ending_in(const std::filesystem::path& folder,
                                                   std::string_view ending) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ending) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

/// What can be reported of a folder of `crumple scatter` without bands; empty for other folders.
std::string hint_at_runs(const std::filesystem::path& folder) {
  const std::filesystem::path run = folder / scatter_run_name(0);
  std::error_code ignored;
  if (!std::filesystem::is_directory(run, ignored)) return {};
  return fmt::format(" It holds runs of crumple scatter, but no {}; {} alone can be reported.", bands_file,
                     run.string());
}

/// The collection that run.json lists, else the only one.
std::filesystem::path choose_collection(const ResultFolder& results) {
  std::vector<std::filesystem::path> found = files_ending_in(results.folder, ".pvd");
  if (found.empty())
    throw Error(fmt::format("{} holds no result: there is no .pvd file in it.{}", results.folder.string(),
                            hint_at_runs(results.folder)));
  if (found.size() == 1) return found.front();
  if (results.has_record) {
    const std::string record = read_file(results.folder / "run.json");
    for (const std::filesystem::path& file : found)
      if (record.find(fmt::format("\"{}\"", file.filename().string())) != std::string::npos) return file;
  }
  throw Error(fmt::format("{} holds the frames of {} runs ({}, {}, ...) and no run.json that names one.",
                          results.folder.string(), found.size(), found[0].filename().string(),
                          found[1].filename().string()));
}

/// What the writer of a value made of the letters that XML gives a meaning, undone.
std::string plain_text(std::string_view value) {
  constexpr std::array<std::pair<std::string_view, char>, 4> written{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&amp;", '&'}}};
  std::string text;
  while (!value.empty()) {
    std::size_t length = 1;
    char letter = value.front();
    for (const auto& [name, meant] : written)
      if (value.starts_with(name)) {
        length = name.size();
        letter = meant;
      }
    text += letter;
    value.remove_prefix(length);
  }
  return text;
}

std::optional<std::string> attribute(std::string_view tag, const std::string& name) {
  const std::string key = fmt::format(" {}=\"", name);
  const std::size_t at = tag.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  const std::size_t start = at + key.size();
  return plain_text(tag.substr(start, tag.find('"', start) - start));
}

/// Empty if it is no finite number.
std::optional<double> time_of(const std::optional<std::string>& text) {
  double value = 0;
  if (!text) return std::nullopt;
  const char* const end = text->data() + text->size();
  const auto [read, fault] = std::from_chars(text->data(), end, value);
  if (fault != std::errc() || read != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Whether a file lies in the folder of the collection or below: one from somebody else must not lead to
/// others.
bool stays_inside(const std::filesystem::path& file) {
  return !file.empty() && file.is_relative() && std::find(file.begin(), file.end(), "..") == file.end();
}

std::vector<FrameFiles> frames_of(const std::filesystem::path& collection) {
  const std::string text = read_file(collection);
  std::vector<FrameFiles> frames;
  std::set<std::string> files;
  constexpr std::string_view key = "<DataSet";
  // From the end of each tag, so that the time is linear in the length.
  std::size_t end = 0;
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, end)) {
    end = std::min(text.find('>', at), text.size());
    const std::string_view tag = std::string_view(text).substr(at, end - at);
    const auto time = time_of(attribute(tag, "timestep"));
    const auto part = attribute(tag, "part");
    const auto file = attribute(tag, "file");
    const bool walls = part == "1";
    if (!time || !file || !stays_inside(*file) || !files.insert(*file).second ||
        (walls && (frames.empty() || frames.back().time < *time || frames.back().time > *time)))
      throw Error(fmt::format("{} cannot be read: <{}> is not understood.", collection.string(),
                              tag.substr(1, longest_echo)));
    const std::filesystem::path path = collection.parent_path() / *file;
    if (walls)
      frames.back().walls = path;
    else
      frames.push_back({*time, path, {}});
  }
  if (frames.empty()) throw Error(fmt::format("{} lists no frames yet.", collection.string()));
  return frames;
}

ResultFolder open_run(const std::filesystem::path& folder) {
  ResultFolder results;
  results.folder = folder;
  results.has_record = std::filesystem::is_regular_file(folder / "run.json");
  const std::filesystem::path collection = choose_collection(results);
  results.name = collection.stem().string();
  results.frames = frames_of(collection);
  results.tables = files_ending_in(folder, ".csv");
  return results;
}

}  // namespace

ResultFolder open_results(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    throw Error(fmt::format("{} is no folder; name that of a run's results.", folder.string()));
  if (!is_scatter_folder(folder)) return open_run(folder);
  ResultFolder results = open_run(folder / scatter_run_name(0));
  results.scatter = folder;
  return results;
}

}  // namespace crumple::report
