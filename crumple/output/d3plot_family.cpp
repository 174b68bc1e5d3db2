// SPDX-License-Identifier: BSD-3-Clause
#include "output/d3plot_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "output/atomic_file.hpp"
#include "output/write_error.hpp"

namespace crumple::output {

namespace {

bool is_of_family(const std::string& name) {
  constexpr std::string_view stem = "d3plot";
  return name.starts_with(stem) && (name.size() == stem.size() || name.size() >= stem.size() + 2) &&
         std::all_of(name.begin() + stem.size(), name.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool write_at(std::FILE* file, std::size_t word, std::string_view bytes) {
  return std::fseek(file, static_cast<long>(word * sizeof(std::uint32_t)), SEEK_SET) == 0 &&
         std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

D3plotFamily::D3plotFamily(std::filesystem::path folder, const D3plotWords& geometry, std::size_t file_words)
    : folder_(std::move(folder)), file_words_(file_words) {
  remove_earlier_files();
  write_atomically(first_file(), geometry.bytes());
}

void D3plotFamily::remove_earlier_files() const {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, ignored))
    if (is_of_family(entry.path().filename().string())) std::filesystem::remove(entry.path(), ignored);
}

std::filesystem::path D3plotFamily::last_file() const {
  return folder_ / fmt::format("d3plot{:02}", files_);
}

void D3plotFamily::add_state(D3plotWords state) {
  const std::size_t added = state.size();
  state.end_mark();
  if (files_ > 0 && words_ + state.size() <= file_words_) {
    state.zeros((D3plotWords::block - (words_ + state.size()) % D3plotWords::block) % D3plotWords::block);
    append(state);
    words_ += added;
    return;
  }
  state.pad();
  ++files_;
  words_ = added;
  write_atomically(last_file(), state.bytes());
}

/// All but the first word goes behind the end mark, then that word takes the mark's place: until then readers
/// see the file end where it did.
void D3plotFamily::append(const D3plotWords& state) const {
  const std::filesystem::path path = last_file();
  // Opened anew each time, so that a file that is no longer there is noticed.
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "r+b"));
  constexpr std::size_t first = sizeof(std::uint32_t);
  if (!file || !write_at(file.get(), words_ + 1, state.bytes().substr(first)) ||
      !write_at(file.get(), words_, state.bytes().substr(0, first)))
    throw WriteError(fmt::format("Cannot write {}: {}.", path.string(), std::strerror(errno)));
}

}  // namespace crumple::output
