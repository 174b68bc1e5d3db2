// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/format/text_source.hpp"

namespace crumple::deck {

/// A text that a deck was read from, and how it was asked for.
struct RecordedText {
  std::string including;  ///< identity of the file with the *INCLUDE; empty for the deck
  std::string asked;      ///< what that *INCLUDE says; empty for the deck
  std::string name;       ///< for messages
  std::string identity;
  std::string text;
};

/// Hands on what another source has and keeps a copy of every text that exists.
class RecordingSource final : public TextSource {
 public:
  /// Both must outlive the source.
  RecordingSource(TextSource& source, std::vector<RecordedText>& texts) : source_(&source), texts_(&texts) {}
  LoadedText deck() override;
  LoadedText include(const std::string& name, const LoadedText& including, SearchFolders folders) override;

 private:
  void keep(const std::string& including, const std::string& asked, const LoadedText& loaded);

  TextSource* source_;
  std::vector<RecordedText>* texts_;
};

/// The texts of an earlier reading, and optionally a second deck behind them.
class ReplaySource final : public TextSource {
 public:
  /// `texts` must outlive the source. `changes` is read behind the deck.
  ReplaySource(const std::vector<RecordedText>& texts, std::optional<LoadedText> changes);
  LoadedText deck() override;
  LoadedText include(const std::string& name, const LoadedText& including, SearchFolders folders) override;

 private:
  LoadedText find(const std::string& including, const std::string& name) const;

  const std::vector<RecordedText>* texts_;
  std::optional<LoadedText> changes_;
  std::string joint_;  ///< the deck that includes the texts and the changes
};

/// A file with its text, or why there is none.
LoadedText load_text(const std::filesystem::path& path);

}  // namespace crumple::deck
