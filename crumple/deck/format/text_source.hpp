// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace crumple::deck {

/// A file of the deck with its text, or why there is none.
struct LoadedText {
  std::string name;                 ///< for messages
  std::string identity;             ///< equal for the same file reached by different names
  std::filesystem::path path;       ///< empty for text from memory
  std::optional<std::string> text;  ///< absent: `fault` says why
  std::string fault;
};

/// Where the text of a deck and of its included files comes from.
class TextSource {
 public:
  virtual ~TextSource() = default;
  TextSource() = default;
  TextSource(const TextSource&) = delete;
  TextSource& operator=(const TextSource&) = delete;

  virtual LoadedText deck() = 0;
  /// The file that *INCLUDE names in `including`.
  virtual LoadedText include(const std::string& name, const LoadedText& including) = 0;
};

/// Files on disk. An included file is looked for beside the including one, then beside the deck.
class DiskSource final : public TextSource {
 public:
  explicit DiskSource(std::filesystem::path deck) : deck_(std::move(deck)) {}
  LoadedText deck() override;
  LoadedText include(const std::string& name, const LoadedText& including) override;

 private:
  std::filesystem::path deck_;
};

/// Texts in memory, by name; reads no file.
class MemorySource final : public TextSource {
 public:
  MemorySource(std::string name, std::string_view text, const std::map<std::string, std::string>& included)
      : name_(std::move(name)), text_(text), included_(&included) {}
  LoadedText deck() override;
  LoadedText include(const std::string& name, const LoadedText& including) override;

 private:
  std::string name_;
  std::string_view text_;
  const std::map<std::string, std::string>* included_;
};

}  // namespace crumple::deck
