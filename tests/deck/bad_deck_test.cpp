// SPDX-License-Identifier: BSD-3-Clause
// Every deck in tests/deck/bad has exactly the errors and warnings that its `$ expect:` lines say.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "deck/reader.hpp"

namespace crumple::deck::bad_deck_test {
namespace {

const std::filesystem::path folder = "tests/deck/bad";

std::vector<std::string> bad_decks() {
  std::vector<std::string> names;
  std::error_code fault;
  for (const auto& entry : std::filesystem::directory_iterator(folder, fault))
    if (entry.path().extension() == ".k") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> expected_messages(const std::filesystem::path& deck) {
  constexpr std::string_view mark = "$ expect: ";
  std::vector<std::string> messages;
  std::ifstream stream(deck);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(mark)) messages.push_back(line.substr(mark.size()));
  return messages;
}

/// Messages name files as they were opened; the expectations have the names alone.
std::string without_folder(std::string text) {
  const std::string prefix = folder.generic_string() + "/";
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
    text.erase(at, prefix.size());
  return text;
}

class BadDeck : public testing::TestWithParam<std::string> {};

TEST_P(BadDeck, HasTheExpectedMessages) {
  const std::filesystem::path deck = folder / (GetParam() + ".k");
  const std::vector<std::string> expected = expected_messages(deck);
  ASSERT_FALSE(expected.empty()) << "the deck has no $ expect: line";

  const ReadResult result = read_deck(deck);
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : result.diagnostics)
    if (diagnostic.severity != Severity::Note) messages.push_back(without_folder(to_string(diagnostic)));
  EXPECT_EQ(messages, expected);
  EXPECT_GT(error_count(result.diagnostics), 0);
  EXPECT_FALSE(result.model.has_value());
}

INSTANTIATE_TEST_SUITE_P(Decks, BadDeck, testing::ValuesIn(bad_decks()),
                         [](const auto& test) { return test.param; });

TEST(BadDecks, AreAllThere) {
  EXPECT_GE(bad_decks().size(), 40U);
}

/// The first error of a text, without name and place.
std::string first_error(const ReadResult& result) {
  for (const Diagnostic& diagnostic : result.diagnostics)
    if (diagnostic.severity == Severity::Error) return to_string(diagnostic);
  return "no error";
}

TEST(BadText, EmptyFile) {
  const std::string expected = "deck.k: error: the file is empty, expected LS-DYNA keywords";
  EXPECT_EQ(first_error(read_deck_text("")), expected);
  EXPECT_EQ(first_error(read_deck_text(" \r\n\r\n  \n")), expected);
}

TEST(BadText, CommentsOnly) {
  EXPECT_EQ(first_error(read_deck_text("$ nothing\n$ here\n")),
            "deck.k: error: the file has no keywords, expected lines such as *NODE");
}

TEST(BadText, BinaryJunk) {
  const std::string junk(
      "*KEYWORD\n\x7f"
      "ELF\0\1\2",
      16);
  EXPECT_EQ(first_error(read_deck_text(junk)),
            "deck.k: error: this is not a text file (byte 13 is 0x00), expected LS-DYNA keywords");
}

TEST(BadText, CompressedFile) {
  EXPECT_EQ(first_error(read_deck_text(std::string("\x1f\x8b\x08\x00", 4))),
            "deck.k: error: this is not a text file (byte 0 is 0x1f); it is compressed, unpack it first");
}

TEST(BadText, WideCharacters) {
  EXPECT_EQ(
      first_error(read_deck_text(std::string("\xff\xfe*\0K\0", 6))),
      "deck.k: error: this is not a text file (byte 3 is 0x00); it is UTF-16, save it as UTF-8 or ASCII");
}

TEST(BadText, NoSuchDeck) {
  EXPECT_EQ(first_error(read_deck("tests/deck/bad/there_is_no_such_deck.k")),
            "tests/deck/bad/there_is_no_such_deck.k: error: there is no such file");
}

TEST(BadText, FolderInsteadOfDeck) {
  EXPECT_EQ(first_error(read_deck("tests/deck/bad")),
            "tests/deck/bad: error: this is a folder, expected a file");
}

TEST(BadText, IncludesThatGrowWithoutEnd) {
  // Every level includes the next one twice: 2^40 files if nobody counted.
  std::map<std::string, std::string> files;
  for (int level = 0; level < 40; ++level) {
    const std::string next = "level" + std::to_string(level + 1);
    files["level" + std::to_string(level)] = "*INCLUDE\n" + next + "\n" + next + "\n";
  }
  const ReadResult result = read_deck_text("*KEYWORD\n*INCLUDE\nlevel0\n", {}, files);
  EXPECT_GT(error_count(result.diagnostics), 0);
}

}  // namespace
}  // namespace crumple::deck::bad_deck_test
