// SPDX-License-Identifier: BSD-3-Clause
#include "app/commands/keywords_command.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <string_view>

#include "app/console/print.hpp"
#include "deck/keywords/keyword_cards.hpp"
#include "deck/keywords/nearest_keyword.hpp"

namespace crumple::app {

namespace {

using deck::Check;
using deck::Field;
using deck::FieldType;
using deck::HeadingKind;
using deck::Keyword;

const char* heading_word(HeadingKind heading) {
  switch (heading) {
    case HeadingKind::Title:
      return "title";
    case HeadingKind::Identity:
      return "id";
    case HeadingKind::None:
      break;
  }
  return "none";
}

/// What becomes of a value of the field.
const char* effect_word(const Field& field) {
  if (!field.has_effect) return "none";
  if (field.check.kind == Check::Kind::Only) return "only";
  return field.check.kind == Check::Kind::Harmless ? "warned" : "used";
}

const char* type_word(FieldType type) {
  return type == FieldType::Integer ? "whole number" : type == FieldType::Real ? "number" : "text";
}

nlohmann::json json_of(const Field& field) {
  return {{"name", field.name},
          {"type", type_word(field.type)},
          {"default", field.fallback},
          {"zero_is_default", field.zero_is_default},
          {"width", field.width},
          {"effect", effect_word(field)},
          {"expected", expectation(field)},
          {"note", field.check.text}};
}

nlohmann::json json_of(const deck::KeywordCard& card) {
  nlohmann::json fields = nlohmann::json::array();
  for (const Field& field : card.fields) fields.push_back(json_of(field));
  return {{"number", card.number},
          {"text", card.text},
          {"repeats", card.repeats},
          {"optional", card.optional},
          {"fields", fields}};
}

void print_json(std::ostream& out) {
  nlohmann::json keywords = nlohmann::json::array();
  for (const Keyword& keyword : deck::keyword_table()) {
    const deck::KeywordForm form = cards_of(keyword);
    nlohmann::json cards = nlohmann::json::array();
    for (const deck::KeywordCard& card : form.cards) cards.push_back(json_of(card));
    keywords.push_back({{"name", keyword.name},
                        {"heading", heading_word(keyword.heading)},
                        {"several", keyword.repeats},
                        {"repeats", form.repeats},
                        {"cards", cards}});
  }
  nlohmann::json ignored = nlohmann::json::array();
  for (const deck::IgnoredRow& row : deck::ignored_table())
    ignored.push_back({{"name", row.name}, {"is_prefix", row.is_prefix}, {"reason", row.reason}});
  out << nlohmann::json{{"keywords", keywords}, {"ignored", ignored}}.dump(1) << "\n";
}

std::string default_of(const Field& field) {
  if (field.type == FieldType::Text) return {};
  return fmt::format("{:g}", field.fallback);
}

std::string words_of(const Field& field) {
  if (!field.has_effect) return "no effect";
  std::string words = expectation(field);
  if (field.check.kind == Check::Kind::Harmless) words = fmt::format("others than {} are warned of", words);
  if (!field.check.text.empty()) words += fmt::format("{}{}", words.empty() ? "" : "; ", field.check.text);
  return words;
}

void print_cards(const Keyword& keyword, std::ostream& out) {
  const deck::KeywordForm form = cards_of(keyword);
  print(out, "*{}\n", keyword.name);
  if (keyword.heading == HeadingKind::Title) print(out, "  with _TITLE: a line of text before the cards\n");
  if (keyword.heading == HeadingKind::Identity)
    print(out, "  with _ID or _TITLE: a card with a number and a text before the others\n");
  for (const deck::KeywordCard& card : form.cards) {
    const char* const again = card.repeats    ? ", as often as needed"
                              : card.optional ? ", may be left out"
                                              : "";
    if (card.number == 0)
      print(out, "  line: {}{}\n", card.text, again);
    else
      print(out, "  card {}{}\n", card.number, again);
    for (const Field& field : card.fields)
      print(out, "    {:<10} {:<12} default {:<8} {}\n", field.name, type_word(field.type), default_of(field),
            words_of(field));
  }
  if (form.repeats) print(out, "  all of it again for each further item\n");
}

std::string upper(std::string name) {
  if (name.starts_with('*')) name.erase(0, 1);
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

}  // namespace

ExitCode list_keywords(const KeywordsOptions& options, const Console& console) {
  if (options.json) {
    print_json(console.out);
    return ExitCode::Normal;
  }
  if (options.names.empty())
    for (const Keyword& keyword : deck::keyword_table()) print(console.out, "{}\n", keyword.name);
  ExitCode code = ExitCode::Normal;
  for (const std::string& given : options.names) {
    const std::string name = upper(given);
    if (const auto found = deck::find_keyword(name)) {
      print_cards(*found->keyword, console.out);
    } else if (const deck::IgnoredRow* form = deck::find_format_keyword(name)) {
      print(console.out, "*{}\n  {}\n", name, form->reason);
    } else if (const deck::IgnoredRow* row = deck::find_ignored(name)) {
      print(console.out, "*{}\n  is left out with a warning: {}\n", name, row->reason);
    } else {
      print(console.err, "crumple: *{} is not supported{}\n", name, deck::advice_on(name));
      code = ExitCode::Input;
    }
  }
  return code;
}

}  // namespace crumple::app
