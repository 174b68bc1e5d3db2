// SPDX-License-Identifier: BSD-3-Clause
#include "output/lsdyna/text_file.hpp"

#include <fmt/chrono.h>
#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <iterator>
#include <utility>

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

TextFile::TextFile(std::filesystem::path path, Opening opening) : file_(std::move(path), opening) {}

void TextFile::add(const std::string& title, const HistoryForm& form, const HistoryItems& items,
                   const Sample& sample) {
  if (file_.empty() && text_.empty()) add_head(title, form, items, text_);
  form.print(items, sample, text_);
}

void TextFile::flush() {
  if (text_.empty()) return;
  const std::string blocks = std::exchange(text_, {});
  file_.append(blocks);
}

}  // namespace crumple::output
