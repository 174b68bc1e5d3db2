// SPDX-License-Identifier: BSD-3-Clause
#include "deck/parameters.hpp"

#include <fmt/format.h>

#include "deck/cards.hpp"
#include "deck/numbers.hpp"

namespace crumple::deck {

namespace {

constexpr Field parameter_card[] = {row::text("PRMR1", 10), row::text("VAL1", 10),  row::text("PRMR2", 10),
                                    row::text("VAL2", 10),  row::text("PRMR3", 10), row::text("VAL3", 10),
                                    row::text("PRMR4", 10), row::text("VAL4", 10)};

bool is_name(std::string_view text) {
  if (text.empty() || (text.front() >= '0' && text.front() <= '9')) return false;
  for (const char c : text) {
    const bool letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (!letter && c != '_' && !(c >= '0' && c <= '9')) return false;
  }
  return true;
}

std::string_view without_sign(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  return text;
}

}  // namespace

bool Parameters::is_reference(std::string_view text) {
  return without_sign(text).starts_with('&');
}

std::optional<std::string> Parameters::substitute(std::string_view reference) const {
  const std::string_view name = trimmed(without_sign(reference).substr(1));
  const auto found = values_.find(upper_case(name));
  if (found == values_.end()) return std::nullopt;
  const std::string& text = found->second.text;
  if (!reference.starts_with('-')) return text;
  if (text.starts_with('-')) return text.substr(1);
  return fmt::format("-{}", without_sign(text));
}

void Parameters::read(Cards& cards) {
  while (cards.more()) {
    const Card card = cards.next_filled(parameter_card);
    for (std::size_t i = 0; i < std::size(parameter_card); i += 2) {
      const std::string_view name = card.text(parameter_card[i].name);
      const std::string_view value = card.text(parameter_card[i + 1].name);
      if (name.empty() && value.empty()) continue;
      define(name, value, card.where(), cards.report());
    }
  }
}

void Parameters::define(std::string_view name_and_type, std::string_view text, const Where& where,
                        Report& report) {
  const std::string name = upper_case(trimmed(name_and_type.substr(name_and_type.empty() ? 0 : 1)));
  const char type = name_and_type.empty() ? ' ' : upper_case(name_and_type.substr(0, 1)).front();
  if ((type != 'R' && type != 'I') || !is_name(name)) {
    report.error(
        where, "name",
        fmt::format("read \"{}\", expected R (real) or I (integer) and the name of a parameter, such "
                    "as \"R thick\"{}",
                    name_and_type, type == 'C' ? "; text parameters (C) are not supported" : ""));
    return;
  }
  std::string value(text);
  if (is_reference(text)) {
    std::optional<std::string> found = substitute(text);
    if (!found) {
      report.error(
          where, "undefined",
          fmt::format("parameter {} is set to \"{}\", which is not defined before this line", name, text));
      return;
    }
    value = std::move(*found);
  }
  const bool good = type == 'I' ? parse_integer(value).has_value() : parse_real(value).has_value();
  if (!good) {
    report.error(where, "value",
                 fmt::format("parameter {}: read \"{}\", expected {}", name, text,
                             type == 'I' ? "a whole number" : "a number"));
    return;
  }
  const auto [entry, is_new] = values_.try_emplace(name, Value{value, where});
  if (is_new || entry->second.text == value) return;
  report.error(where, "twice",
               fmt::format("parameter {} is already set to \"{}\" at {}; give it one value", name,
                           entry->second.text, report.place(entry->second.where)));
}

}  // namespace crumple::deck
