// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/switch_file.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <system_error>

#include "files/input_file.hpp"

namespace crumple::app {

namespace {

constexpr double seconds_between_looks = 0.5;
constexpr std::size_t most_bytes = 64;  ///< of the file: its first word counts

}  // namespace

Switch parse_switch(std::string_view content) {
  std::istringstream words{std::string(content)};
  std::string word;
  words >> word;
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  word = word.substr(0, word.find('.'));
  if (word == "sw1" || word == "stop") return Switch::Stop;
  if (word == "sw2") return Switch::Status;
  if (word == "sw3") return Switch::Restart;
  if (word == "sw4") return Switch::Frame;
  return Switch::Unknown;
}

std::optional<Switch> SwitchFile::poll() {
  if (since_look_.seconds() < seconds_between_looks) return std::nullopt;
  since_look_.restart();
  return look();
}

std::optional<Switch> SwitchFile::look() {
  for (const std::filesystem::path& folder : folders_) {
    const std::filesystem::path path = folder / "d3kil";
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) continue;
    const std::string content = read_start(path, most_bytes);
    std::filesystem::remove(path, ignored);
    return parse_switch(content);
  }
  return std::nullopt;
}

}  // namespace crumple::app
