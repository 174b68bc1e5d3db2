// SPDX-License-Identifier: BSD-3-Clause
#include "output/text_file.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <iterator>
#include <system_error>
#include <utility>

#include "output/write_error.hpp"

namespace crumple::output {

namespace {

void add_head(const std::string& title, const HistoryForm& form, const HistoryItems& items,
              std::string& text) {
  fmt::format_to(std::back_inserter(text), " {:.72}\n{:25}{}{})     date {}\n", title, "", program_mark,
                 program_version(), today());
  const bool named = std::any_of(items.titles.begin(), items.titles.end(),
                                 [](const std::string& name) { return !name.empty(); });
  if (named) {
    text += "\n{BEGIN LEGEND}\n Entity #        Title\n";
    for (std::size_t i = 0; i < items.ids.size(); ++i)
      if (!items.titles[i].empty())
        fmt::format_to(std::back_inserter(text), "{:9}     {:.70}\n", items.ids[i], items.titles[i]);
    text += "{END LEGEND}\n\n";
  }
  text += form.heading;
}

}  // namespace

std::string_view program_version() {
  return CRUMPLE_VERSION;
}

std::string today() {
  return fmt::format("{:%m/%d/%Y}", fmt::localtime(std::time(nullptr)));
}

TextFile::TextFile(std::filesystem::path path, Opening opening) : path_(std::move(path)) {
  if (opening == Opening::New) open("wb");
}

void TextFile::declare(domain::StateList& list) {
  list.keep(path_.filename().string() + "_bytes", "-", domain::Entity::Run, bytes_);
}

void TextFile::resume() {
  std::error_code fault;
  const std::uintmax_t there = std::filesystem::file_size(path_, fault);
  if (fault || there < bytes_ || bytes_ == 0) {
    bytes_ = 0;
    open("wb");
    return;
  }
  std::filesystem::resize_file(path_, bytes_, fault);
  if (fault) throw WriteError(fmt::format("Cannot write {}: {}.", path_.string(), fault.message()));
  open("ab");
}

void TextFile::open(const char* mode) {
  file_.reset(std::fopen(path_.c_str(), mode));
  if (!file_) throw WriteError(fmt::format("Cannot write {}: {}.", path_.string(), std::strerror(errno)));
  // Each block is one write: nothing is left over for later if it fails.
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
}

void TextFile::add(const std::string& title, const HistoryForm& form, const HistoryItems& items,
                   const Sample& sample) {
  text_.clear();
  if (bytes_ == 0) add_head(title, form, items, text_);
  form.print(items, sample, text_);
  const bool good = std::fwrite(text_.data(), 1, text_.size(), file_.get()) == text_.size();
  const int reason = errno;
  if (good) {
    bytes_ += text_.size();
    return;
  }
  // Half a block would be read as one.
  std::error_code ignored;
  std::filesystem::resize_file(path_, bytes_, ignored);
  throw WriteError(fmt::format("Cannot write {}: {}.", path_.string(), std::strerror(reason)));
}

}  // namespace crumple::output
