// SPDX-License-Identifier: BSD-3-Clause
#include "app/arguments/foreign_arguments.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "base/error.hpp"

namespace crumple::app {

namespace {

/// Keys of LS-DYNA's command line that say nothing about what is computed here.
constexpr std::array<std::string_view, 12> keys_without_effect = {
    "memory", "memory2", "o", "g", "f", "d", "h", "a", "jobid", "nodes", "para", "case"};

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_ls_dyna(const std::vector<std::string>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(), [](const std::string& argument) {
    const std::string text = lower_case(argument);
    return text.starts_with("i=") || text.starts_with("r=");
  });
}

void translate_pair(const std::string& key, const std::string& value, std::vector<std::string>& own,
                    std::vector<std::string>& notes) {
  if (key == "i") {
    own.push_back(value);
  } else if (key == "r") {
    own.insert(own.end(), {"--restart", value});
  } else if (key == "ncpu") {
    // A negative number asks LS-DYNA for results that do not depend on it: ours never do.
    own.insert(own.end(), {"--threads", value.starts_with('-') ? value.substr(1) : value});
  } else if (key == "endtime") {
    own.insert(own.end(), {"--end", value});
  } else if (std::find(keys_without_effect.begin(), keys_without_effect.end(), key) !=
             keys_without_effect.end()) {
    notes.push_back(fmt::format("{}={} has no meaning here and is ignored.", key, value));
  } else {
    throw Error(fmt::format("{}={} is not understood: i=, r=, ncpu=, endtime= and memory= are.", key, value));
  }
}

std::vector<std::string> from_ls_dyna(const std::vector<std::string>& arguments,
                                      std::vector<std::string>& notes) {
  std::vector<std::string> own{"run"};
  for (const std::string& argument : arguments) {
    const std::size_t equals = argument.find('=');
    if (argument.starts_with("-") || equals == std::string::npos)
      own.push_back(argument);
    else
      translate_pair(lower_case(argument.substr(0, equals)), argument.substr(equals + 1), own, notes);
  }
  return own;
}

std::vector<std::string> from_openradioss(const std::vector<std::string>& arguments) {
  std::vector<std::string> own{"run"};
  for (const std::string& argument : arguments) {
    if (argument == "-i" || argument == "-input") continue;
    own.push_back(argument == "-nt" || argument == "-nthread" ? "--threads" : argument);
  }
  return own;
}

}  // namespace

std::vector<std::string> translate_foreign_arguments(const std::vector<std::string>& arguments,
                                                     std::vector<std::string>& notes) {
  if (is_ls_dyna(arguments)) return from_ls_dyna(arguments, notes);
  if (!arguments.empty() && (arguments[0] == "-i" || arguments[0] == "-input" || arguments[0] == "-nt"))
    return from_openradioss(arguments);
  return arguments;
}

}  // namespace crumple::app
