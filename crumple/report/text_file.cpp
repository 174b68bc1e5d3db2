// SPDX-License-Identifier: BSD-3-Clause
#include "report/text_file.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/error.hpp"

namespace crumple::report {

std::string read_file(const std::filesystem::path& file) {
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  const std::unique_ptr<std::FILE, Close> stream(std::fopen(file.c_str(), "rb"));
  if (!stream) throw Error(fmt::format("{} cannot be read: {}.", file.string(), std::strerror(errno)));
  std::string text;
  constexpr std::size_t chunk = 1U << 20U;
  for (std::size_t read = chunk; read == chunk;) {
    const std::size_t start = text.size();
    text.resize(start + chunk);
    read = std::fread(text.data() + start, 1, chunk, stream.get());
    text.resize(start + read);
  }
  if (std::ferror(stream.get()) != 0)
    throw Error(fmt::format("{} cannot be read: {}.", file.string(), std::strerror(errno)));
  return text;
}

}  // namespace crumple::report
