// SPDX-License-Identifier: BSD-3-Clause
#include "output/lsdyna/binout.hpp"

#include <fmt/core.h>

#include <cmath>
#include <span>
#include <utility>

#include "base/state_hash.hpp"
#include "output/lsdyna/text_file.hpp"

namespace crumple::output {

namespace {

std::string of_width(std::string_view text, std::size_t width) {
  std::string result(text.substr(0, width));
  result.resize(width, ' ');
  return result;
}

void add_legend(LsdaFile& file, const HistoryItems& items) {
  std::vector<std::int64_t> ids;
  std::string legend;
  for (std::size_t i = 0; i < items.titles.size(); ++i) {
    if (items.titles[i].empty()) continue;
    ids.push_back(items.ids[i]);
    legend += of_width(items.titles[i], 70);
  }
  file.add("legend", legend);
  file.add("legend_ids", ids);
}

std::vector<std::int64_t> whole_numbers(const std::vector<double>& values) {
  std::vector<std::int64_t> result;
  result.reserve(values.size());
  for (const double value : values) result.push_back(std::llround(value));
  return result;
}

}  // namespace

Binout::Binout(std::filesystem::path path, std::string title, std::vector<std::string> branches,
               Opening opening)
    : file_(std::move(path), opening), title_(std::move(title)) {
  for (std::string& name : branches) branches_.push_back({.name = std::move(name)});
}

void Binout::declare(domain::StateList& list) {
  file_.declare(list);
  for (Branch& branch : branches_)
    list.keep("binout_" + branch.name, "-", domain::Entity::Run, branch.in_file);
}

void Binout::resume() {
  const bool goes_on = file_.resume();
  for (Branch& branch : branches_) {
    if (!goes_on) branch.in_file = {};
    branch.with_added = branch.in_file;
  }
}

void Binout::add_metadata(const HistoryForm& form, const HistoryItems& items) {
  file_.enter(fmt::format("/{}/metadata", form.branch));
  file_.add("title", of_width(title_, 80));
  file_.add("version", of_width(program_version(), 10));
  file_.add("revision", of_width("crumple", 10));
  file_.add("date", today());
  add_legend(file_, items);
  if (!items.own_ids) file_.add("ids", items.ids);
  for (const auto& [name, values] : items.marks) file_.add(name, values);
  for (const auto& [name, text] : items.texts) file_.add(name, text);
}

void Binout::add(std::size_t branch, const HistoryForm& form, const HistoryItems& items,
                 const Sample& sample) {
  Progress& progress = branches_[branch].with_added;
  // A deck of a restart may add items behind those that there are.
  StateHash fingerprint;
  fingerprint.add(std::as_bytes(std::span(items.ids)));
  if (progress.items != fingerprint.value()) add_metadata(form, items);
  progress.items = fingerprint.value();
  file_.enter(fmt::format("/{}/d{:06}", form.branch, ++progress.states));
  file_.add("time", sample.time());
  file_.add("cycle", std::int64_t{sample.cycle()});
  for (std::size_t i = 0; i < sample.variables().size(); ++i) {
    const Variable& variable = sample.variables()[i];
    if (variable.name.empty()) continue;
    if (variable.whole)
      file_.add(variable.name, whole_numbers(sample.of(i)));
    else
      file_.add(variable.name, sample.of(i));
  }
}

void Binout::flush() {
  // What does not reach the file does not count.
  std::vector<Progress> reached;
  for (Branch& branch : branches_) reached.push_back(std::exchange(branch.with_added, branch.in_file));
  file_.flush();
  for (std::size_t i = 0; i < reached.size(); ++i)
    branches_[i].in_file = branches_[i].with_added = reached[i];
}

}  // namespace crumple::output
