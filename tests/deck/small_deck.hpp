// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "deck/reader.hpp"

namespace crumple::deck::test {

/// A complete deck of two square shells of side 1 beside each other, in pieces that a test may replace.
struct SmallDeck {
  std::string keyword = "*KEYWORD\n";
  std::string termination = "*CONTROL_TERMINATION\n       2.5\n";
  std::string nodes =
      "*NODE\n"
      "       1             0.0             0.0             0.0\n"
      "       2             1.0             0.0             0.0\n"
      "       3             1.0             1.0             0.0\n"
      "       4             0.0             1.0             0.0\n"
      "       5             2.0             0.0             0.0\n"
      "       6             2.0             1.0             0.0\n";
  std::string shells =
      "*ELEMENT_SHELL\n"
      "      11       1       1       2       3       4\n"
      "      12       1       2       5       6       3\n";
  std::string part = "*PART\nplate\n         1         1         1\n";
  std::string section = "*SECTION_SHELL\n         1         2\n       0.1\n";
  std::string material = "*MAT_ELASTIC\n         1   7.83E-6     207.0       0.3\n";
  std::string more;
  std::string end = "*END\n";

  std::string text() const {
    return keyword + termination + nodes + shells + part + section + material + more + end;
  }
};

/// The same with a cube of side 1 of one solid, number 21.
struct CubeDeck : SmallDeck {
  CubeDeck() {
    nodes =
        "*NODE\n"
        "       1             0.0             0.0             0.0\n"
        "       2             1.0             0.0             0.0\n"
        "       3             1.0             1.0             0.0\n"
        "       4             0.0             1.0             0.0\n"
        "       5             0.0             0.0             1.0\n"
        "       6             1.0             0.0             1.0\n"
        "       7             1.0             1.0             1.0\n"
        "       8             0.0             1.0             1.0\n";
    section = "*SECTION_SOLID\n         1\n";
    shells =
        "*ELEMENT_SOLID\n"
        "      21       1       1       2       3       4       5       6       7       8\n";
  }
};

inline std::string listed(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += to_string(diagnostic) + "\n";
  return text;
}

/// The model of a deck that must have neither error nor warning.
inline model::Model read_clean(const std::string& text, const ReadOptions& options = {},
                               const std::map<std::string, std::string>& included = {}) {
  const ReadResult result = read_deck_text(text, options, included);
  for (const Diagnostic& diagnostic : result.diagnostics)
    EXPECT_EQ(diagnostic.severity, Severity::Note) << to_string(diagnostic);
  EXPECT_TRUE(result.model.has_value()) << text;
  if (!result.model) return {};
  EXPECT_TRUE(model::faults(*result.model).empty());
  return *result.model;
}

/// The model of the small deck with something added.
inline model::Model read_with(const std::string& more) {
  SmallDeck deck;
  deck.more = more;
  return read_clean(deck.text());
}

/// The messages of a deck, errors and warnings.
inline std::vector<std::string> messages_in(const SmallDeck& deck, const ReadOptions& options = {}) {
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : read_deck_text(deck.text(), options).diagnostics)
    if (diagnostic.severity != Severity::Note) found.push_back(to_string(diagnostic));
  return found;
}

/// There is one message, with this text in it.
inline void only_message(const std::vector<std::string>& found, const std::string& text) {
  ASSERT_EQ(found.size(), 1U) << testing::PrintToString(found);
  EXPECT_NE(found[0].find(text), std::string::npos) << found[0];
}

/// A deck has one error or warning, with this text in it.
inline void expect_one(const SmallDeck& deck, const std::string& text) {
  only_message(messages_in(deck), text);
}

/// The messages of the small deck with something added.
inline std::vector<std::string> messages_with(const std::string& more, const ReadOptions& options = {}) {
  SmallDeck deck;
  deck.more = more;
  return messages_in(deck, options);
}

/// The messages of the small deck with this material.
inline std::vector<std::string> messages_of(const std::string& material) {
  SmallDeck deck;
  deck.material = material;
  return messages_in(deck);
}

/// The messages of the cube with this material.
inline std::vector<std::string> messages_of_cube(const std::string& material) {
  CubeDeck deck;
  deck.material = material;
  return messages_in(deck);
}

/// The law of the cube of this material, which must have neither error nor warning.
template <class Law>
Law law_of_cube(const std::string& material) {
  CubeDeck deck;
  deck.material = material;
  return std::get<Law>(read_clean(deck.text()).materials.at(0).law);
}

/// A text with its first `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace crumple::deck::test
