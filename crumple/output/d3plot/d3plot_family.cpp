// SPDX-License-Identifier: BSD-3-Clause
#include "output/d3plot/d3plot_family.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "output/files/atomic_file.hpp"
#include "output/files/own_file.hpp"

namespace crumple::output {

namespace {

constexpr std::string_view stem = "d3plot";

/// Number of a file of the family: 0 is the first; -1 if it is none.
int number_of(const std::string& name) {
  if (!name.starts_with(stem) || name.size() == stem.size() + 1) return -1;
  const std::string digits = name.substr(stem.size());
  if (digits.empty()) return 0;
  const bool number = digits.size() < 9 && std::all_of(digits.begin(), digits.end(),
                                                       [](unsigned char c) { return std::isdigit(c) != 0; });
  return number ? std::atoi(digits.c_str()) : -1;
}

void write_at(OwnFile& file, std::size_t word, std::string_view bytes) {
  file.write_at(word * sizeof(std::uint32_t), bytes);
}

}  // namespace

D3plotFamily::D3plotFamily(std::filesystem::path folder, D3plotWords geometry, std::size_t file_words,
                           Opening opening)
    : folder_(std::move(folder)), geometry_(std::move(geometry)), file_words_(file_words) {
  if (opening == Opening::New) begin();
}

void D3plotFamily::begin() {
  remove_files_after(-1);
  write_atomically(first_file(), geometry_.bytes());
  geometry_ = {};
  files_ = 0;
  words_ = 0;
}

void D3plotFamily::remove_files_after(int last) const {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, ignored))
    if (number_of(entry.path().filename().string()) > last) std::filesystem::remove(entry.path(), ignored);
}

void D3plotFamily::declare(domain::StateList& list) {
  list.keep("d3plot_files", "-", domain::Entity::Run, files_);
  list.keep("d3plot_words", "-", domain::Entity::Run, words_);
}

bool D3plotFamily::is_whole() const {
  std::error_code fault;
  if (files_ == 0 || !std::filesystem::exists(first_file(), fault)) return false;
  const std::uintmax_t bytes = std::filesystem::file_size(last_file(), fault);
  return !fault && bytes / sizeof(std::uint32_t) > words_;
}

void D3plotFamily::resume() {
  if (!is_whole()) {
    begin();
    return;
  }
  geometry_ = {};
  remove_files_after(files_);
  D3plotWords mark;
  mark.end_mark();
  OwnFile file = OwnFile::open(last_file());
  write_at(file, words_, mark.bytes());
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
  // Opened again each time, so that a file that is no longer there is noticed.
  OwnFile file = OwnFile::open(last_file());
  constexpr std::size_t first = sizeof(std::uint32_t);
  write_at(file, words_ + 1, state.bytes().substr(first));
  write_at(file, words_, state.bytes().substr(0, first));
}

}  // namespace crumple::output
