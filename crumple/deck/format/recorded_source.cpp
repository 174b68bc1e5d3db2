// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/recorded_source.hpp"

#include <algorithm>

namespace crumple::deck {

namespace {

// What a deck that joins two is called, with its number behind, and how it names them.
constexpr const char* joint = "restart";
constexpr const char* original = "original";
constexpr const char* change = "changes";

LoadedText loaded(const RecordedText& recorded) {
  return {recorded.name, recorded.identity, {}, recorded.text, {}};
}

}  // namespace

LoadedText RecordingSource::deck() {
  LoadedText found = source_->deck();
  keep({}, {}, found);
  return found;
}

LoadedText RecordingSource::include(const std::string& name, const LoadedText& including,
                                    SearchFolders folders) {
  LoadedText found = source_->include(name, including, folders);
  keep(including.identity, name, found);
  return found;
}

void RecordingSource::keep(const std::string& including, const std::string& asked, const LoadedText& loaded) {
  if (!loaded.text) return;
  const bool known = std::any_of(texts_->begin(), texts_->end(), [&](const RecordedText& text) {
    return text.including == including && text.asked == asked;
  });
  if (!known) texts_->push_back({including, asked, loaded.name, loaded.identity, *loaded.text});
}

ReplaySource::ReplaySource(const std::vector<RecordedText>& texts, std::optional<LoadedText> changes)
    : texts_(&texts), changes_(std::move(changes)) {
  if (changes_) changes_->identity = change;
  // The texts may come from a run that was taken up with changes itself.
  const auto joints = std::count_if(texts.begin(), texts.end(), [](const RecordedText& text) {
    return text.asked == original && text.including.starts_with(joint);
  });
  joint_ = joint + std::to_string(joints + 1);
}

LoadedText ReplaySource::deck() {
  if (!changes_) return find({}, {});
  return {
      joint_, joint_, {}, std::string("*INCLUDE\n") + original + "\n*INCLUDE\n" + change + "\n*END\n", {}};
}

LoadedText ReplaySource::include(const std::string& name, const LoadedText& including, SearchFolders) {
  if (!changes_ || including.identity != joint_) return find(including.identity, name);
  return name == change ? *changes_ : find({}, {});
}

LoadedText ReplaySource::find(const std::string& including, const std::string& name) const {
  for (const RecordedText& text : *texts_)
    if (text.including == including && text.asked == name) return loaded(text);
  const bool by_changes = changes_ && including == changes_->identity;
  return {
      name,
      name,
      {},
      std::nullopt,
      by_changes ? "a deck of changes cannot include others" : "the restart file does not hold this file"};
}

LoadedText load_text(const std::filesystem::path& path) {
  return DiskSource(path).deck();
}

}  // namespace crumple::deck
