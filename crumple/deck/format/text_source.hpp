// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
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

/// The name of a file or folder with `/` between its parts, as decks from Windows have `\`.
std::string with_slashes(std::string name);

/// Folders of *INCLUDE_PATH and *INCLUDE_PATH_RELATIVE, in the order in which they are searched.
using SearchFolders = std::span<const std::filesystem::path>;

/// Where the text of a deck and of its included files comes from.
class TextSource {
 public:
  virtual ~TextSource() = default;
  TextSource() = default;
  TextSource(const TextSource&) = delete;
  TextSource& operator=(const TextSource&) = delete;

  virtual LoadedText deck() = 0;
  /// The file that *INCLUDE names in `including`; where it is not beside that one, from the first folder that
  /// has it.
  virtual LoadedText include(const std::string& name, const LoadedText& including, SearchFolders folders) = 0;
};

/// Files on disk. An included file is searched beside the including one, beside the deck, in the folders.
class DiskSource final : public TextSource {
 public:
  explicit DiskSource(std::filesystem::path deck) : deck_(std::move(deck)) {}
  LoadedText deck() override;
  LoadedText include(const std::string& name, const LoadedText& including, SearchFolders folders) override;

 private:
  std::filesystem::path deck_;
};

/// Texts in memory, by name; reads no file.
class MemorySource final : public TextSource {
 public:
  MemorySource(std::string name, std::string_view text, const std::map<std::string, std::string>& included)
      : name_(std::move(name)), text_(text), included_(&included) {}
  LoadedText deck() override;
  LoadedText include(const std::string& name, const LoadedText& including, SearchFolders folders) override;

 private:
  std::string name_;
  std::string_view text_;
  const std::map<std::string, std::string>* included_;
};

}  // namespace crumple::deck
