// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/parameters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "deck/format/cards.hpp"
#include "deck/format/edit_distance.hpp"
#include "deck/format/expression.hpp"
#include "deck/format/numbers.hpp"

namespace crumple::deck {

namespace {

constexpr Field parameter_card[] = {row::text("PRMR1", 10), row::text("VAL1", 10),  row::text("PRMR2", 10),
                                    row::text("VAL2", 10),  row::text("PRMR3", 10), row::text("VAL3", 10),
                                    row::text("PRMR4", 10), row::text("VAL4", 10)};

constexpr Field expression_card[] = {row::text("PRMR1", 10), row::text("EXPRESSION1", 70)};

constexpr Field duplication_card[] = {
    row::integer_or_default("DFLAG", 1,
                            row::within(1, 5,
                                        "of two values 1 takes the first with a warning, 2 the last with a "
                                        "warning, 3 is an error, 4 takes the last, 5 the first"))};

constexpr double exact_limit = 9007199254740992.0;  // 2^53: whole numbers are exact below it

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
  if (!is_name(name)) return computed(reference);
  const Value* found = use(name);
  if (found == nullptr) return std::nullopt;
  const std::string& text = found->text;
  if (!reference.starts_with('-')) return text;
  if (text.starts_with('-')) return text.substr(1);
  return fmt::format("-{}", without_sign(text));
}

/// `&end-0.001`: of references and numbers.
std::optional<std::string> Parameters::computed(std::string_view text) const {
  const Evaluated result = evaluated(std::string(text));
  if (!result.fault.empty()) return std::nullopt;
  const double value = result.number.value;
  const bool whole = std::floor(value) == value && std::fabs(value) < exact_limit;
  return whole ? fmt::format("{}", static_cast<std::int64_t>(value)) : fmt::format("{}", value);
}

Evaluated Parameters::evaluated(const std::string& expression) const {
  return evaluate(expression, [&](std::string_view other) -> std::optional<Number> {
    const Value* found = use(other);
    const std::optional<double> number = found == nullptr ? std::nullopt : parse_real(found->text);
    if (!number) return std::nullopt;
    return Number{*number, found->is_whole};
  });
}

bool Parameters::is_keyword(std::string_view name) {
  constexpr std::string_view names[] = {"PARAMETER",
                                        "PARAMETER_EXPRESSION",
                                        "PARAMETER_LOCAL",
                                        "PARAMETER_EXPRESSION_LOCAL",
                                        "PARAMETER_MUTABLE",
                                        "PARAMETER_EXPRESSION_MUTABLE",
                                        "PARAMETER_DUPLICATION"};
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

const Parameters::Value* Parameters::find(std::string_view name) const {
  for (auto scope = locals_.rbegin(); scope != locals_.rend(); ++scope)
    if (const auto found = scope->find(name); found != scope->end()) return &found->second;
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : &found->second;
}

const Parameters::Value* Parameters::use(std::string_view name) const {
  std::string upper = upper_case(name);
  const Value* found = find(upper);
  if (found != nullptr)
    found->is_used = true;
  else if (is_name(upper))
    names_.insert(std::move(upper));
  return found;
}

void Parameters::note_references(std::string_view text) {
  constexpr std::string_view of_names = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_";
  for (std::size_t at = text.find('&'); at != std::string_view::npos; at = text.find('&', at + 1)) {
    const std::size_t end = std::min(text.find_first_not_of(of_names, at + 1), text.size());
    const std::string_view name = text.substr(at + 1, end - at - 1);
    if (is_name(name)) use(name);
  }
}

void Parameters::report_unused_presets(Report& report) const {
  for (const auto& [name, value] : values_) {
    if (!value.is_preset || value.is_used) continue;
    if (value.is_in_the_deck) {
      report.error(
          {{}, 0, 0, 0}, "preset",
          fmt::format("parameter {} of the command line has no effect: the deck sets it, but never uses "
                      "&{}",
                      name, name));
      continue;
    }
    std::string_view nearest;
    std::size_t least = 1 + (name.size() + 1) / 2;
    for (const std::string& other : names_)
      if (const std::size_t distance = edit_distance(name, other); distance < least) {
        least = distance;
        nearest = other;
      }
    std::string advice = names_.empty() ? "it has no parameters" : "it has others";
    if (!nearest.empty()) advice = fmt::format("did you mean {}?", nearest);
    report.error({{}, 0, 0, 0}, "preset",
                 fmt::format("parameter {} of the command line is not in the deck; {}", name, advice));
  }
}

std::vector<SetParameter> Parameters::all() const {
  std::vector<SetParameter> list;
  list.reserve(values_.size());
  for (const auto& [name, value] : values_) list.push_back({name, value.text, value.is_preset});
  return list;
}

bool Parameters::preset(std::string_view name, std::string_view value) {
  if (!is_name(name) || !parse_real(value)) return false;
  values_.insert_or_assign(upper_case(name),
                           Value{std::string(value), {}, parse_integer(value).has_value(), true});
  return true;
}

void Parameters::read(std::string_view keyword, Cards& cards) {
  const bool is_local = keyword.ends_with("_LOCAL");
  is_mutable_ = keyword.ends_with("_MUTABLE");
  if (keyword == "PARAMETER_DUPLICATION")
    read_duplication(cards);
  else if (keyword.starts_with("PARAMETER_EXPRESSION"))
    read_expressions(cards, is_local);
  else
    read_values(cards, is_local);
}

void Parameters::read_duplication(Cards& cards) {
  constexpr Duplicate choices[] = {Duplicate::WarnAndKeep, Duplicate::WarnAndReplace, Duplicate::Refuse,
                                   Duplicate::Replace, Duplicate::Keep};
  const Card card = cards.next(duplication_card);
  cards.report_unread();
  if (duplication_) {
    cards.report().warning(
        card.where(), "again",
        fmt::format("does not count; the one at {} does", cards.report().place(*duplication_)));
    return;
  }
  duplication_ = card.where();
  if (card.good("DFLAG")) duplicate_ = choices[card.integer("DFLAG") - 1];
}

void Parameters::read_values(Cards& cards, bool is_local) {
  while (cards.more()) {
    const Card card = cards.next_filled(parameter_card);
    for (std::size_t i = 0; i < std::size(parameter_card); i += 2) {
      const std::string_view name = card.text(parameter_card[i].name);
      const std::string_view value = card.text(parameter_card[i + 1].name);
      if (name.empty() && value.empty()) continue;
      define(name, value, is_local, card.where(), cards.report());
    }
  }
}

void Parameters::read_expressions(Cards& cards, bool is_local) {
  std::optional<Name> name;
  std::string expression;
  Where where;
  const auto finish = [&] {
    if (name) define_by(expression, *name, where, cards.report());
  };
  while (cards.more()) {
    const Card card = cards.next_filled(expression_card);
    // A line without a name goes on with the expression before it.
    const bool goes_on = card.text("PRMR1").empty() && where.line > 0;
    if (goes_on) {
      expression += fmt::format(" {}", card.text("EXPRESSION1"));
      continue;
    }
    finish();
    where = card.where();
    expression = card.text("EXPRESSION1");
    name = name_of(card.text("PRMR1"), where, cards.report());
    if (name) name->is_local = is_local;
  }
  finish();
}

std::optional<Parameters::Name> Parameters::name_of(std::string_view name_and_type, const Where& where,
                                                    Report& report) {
  const std::string name = upper_case(trimmed(name_and_type.substr(name_and_type.empty() ? 0 : 1)));
  const char type = name_and_type.empty() ? ' ' : upper_case(name_and_type.substr(0, 1)).front();
  if ((type == 'R' || type == 'I' || type == 'C') && is_name(name))
    return Name{name, type == 'I', false, type == 'C'};
  report.error(where, "name",
               fmt::format("read \"{}\", expected R (real), I (integer) or C (text) and the name of a "
                           "parameter, such as \"R thick\"",
                           name_and_type));
  return std::nullopt;
}

void Parameters::define(std::string_view name_and_type, std::string_view text, bool is_local,
                        const Where& where, Report& report) {
  std::optional<Name> name = name_of(name_and_type, where, report);
  if (!name) return;
  name->is_local = is_local;
  std::string value(text);
  if (is_reference(text)) {
    std::optional<std::string> found = substitute(text);
    if (!found) {
      report.error(where, "undefined",
                   fmt::format("parameter {} is set to \"{}\", which is not defined before this line",
                               name->name, text));
      return;
    }
    value = std::move(*found);
  }
  const bool good = name->is_whole ? parse_integer(value).has_value() : parse_real(value).has_value();
  if (!good && !name->is_text) {
    report.error(where, "value",
                 fmt::format("parameter {}: read \"{}\", expected {}", name->name, text,
                             name->is_whole ? "a whole number" : "a number"));
    return;
  }
  enter(*name, value, where, report);
}

void Parameters::define_by(const std::string& expression, const Name& name, const Where& where,
                           Report& report) {
  const Evaluated result = evaluated(expression);
  const double value = result.number.value;
  if (!result.fault.empty())
    report.error(where, "expression",
                 fmt::format("parameter {}: read \"{}\", but {}", name.name, expression, result.fault));
  else if (name.is_whole && (std::floor(value) != value || std::fabs(value) > exact_limit))
    report.error(
        where, "whole",
        fmt::format("parameter {}: read \"{}\", which is {}, expected a whole number; take int() or nint(), "
                    "or make it real (R)",
                    name.name, expression, value));
  else
    enter(name,
          name.is_whole ? fmt::format("{}", static_cast<std::int64_t>(value)) : fmt::format("{}", value),
          where, report);
}

void Parameters::enter(const Name& name, const std::string& text, const Where& where, Report& report) {
  names_.insert(name.name);
  const auto preset = values_.find(name.name);
  if (preset != values_.end() && preset->second.is_preset) {
    preset->second.is_in_the_deck = true;
    if (preset->second.text != text)
      report.warning(where, "preset",
                     fmt::format("parameter {} is \"{}\" by the command line, not \"{}\"", name.name,
                                 preset->second.text, text));
    return;
  }
  Values& scope = name.is_local && !locals_.empty() ? locals_.back() : values_;
  const Value value{text, where, name.is_whole};
  const auto [entry, is_new] = scope.try_emplace(name.name, value);
  if (is_new || entry->second.text == text) return;
  const std::optional<double> known_number = parse_real(entry->second.text);
  if (known_number && known_number == parse_real(text)) return;
  if (is_mutable_) {
    entry->second = value;
    return;
  }
  const std::string known = fmt::format("parameter {} is already set to \"{}\" at {}", name.name,
                                        entry->second.text, report.place(entry->second.where));
  const bool replaces = duplicate_ == Duplicate::WarnAndReplace || duplicate_ == Duplicate::Replace;
  if (duplicate_ == Duplicate::Refuse)
    report.error(where, "twice", fmt::format("{}; give it one value", known));
  else if (duplicate_ == Duplicate::WarnAndReplace || duplicate_ == Duplicate::WarnAndKeep)
    report.warning(where, "twice",
                   fmt::format("{}; \"{}\" is taken", known, replaces ? text : entry->second.text));
  if (replaces) entry->second = value;
}

}  // namespace crumple::deck
