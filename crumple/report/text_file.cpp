// SPDX-License-Identifier: BSD-3-Clause
#include "report/text_file.hpp"

#include <fmt/core.h>

#include <utility>

#include "base/error.hpp"
#include "files/input_file.hpp"

namespace crumple::report {

std::string read_file(const std::filesystem::path& file) {
  InputFile input = read_input_file(file);
  if (!input.fault.empty()) throw Error(fmt::format("{} cannot be read: {}.", file.string(), input.fault));
  return std::move(input.text);
}

}  // namespace crumple::report
