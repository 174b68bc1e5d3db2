// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/cards.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "deck/format/numbers.hpp"

namespace crumple::deck {

namespace {

/// A last field of text takes the rest of the line, commas included.
bool ends_in_text(Layout layout) {
  return !layout.empty() && layout.back().type == FieldType::Text && layout.back().width >= 60;
}

std::string list_of_names(Layout layout) {
  std::string names;
  for (const Field& field : layout) names += fmt::format("{}{}", names.empty() ? "" : ", ", field.name);
  return names;
}

std::size_t advance_tab(std::size_t column) {
  constexpr std::size_t tab_stop = 8;
  return (column / tab_stop + 1) * tab_stop;
}

/// What the id before an item is the id of: IDPOFF counts rigid walls, cross-sections and constrained node
/// sets.
IdKind kind_of_heading(const Card& card) {
  constexpr std::string_view like_parts[] = {"*RIGIDWALL_", "*DATABASE_CROSS_SECTION_",
                                             "*CONSTRAINED_NODE_SET"};
  const bool is_like_part =
      std::any_of(std::begin(like_parts), std::end(like_parts),
                  [&](std::string_view family) { return card.where().keyword.starts_with(family); });
  return is_like_part ? IdKind::Part : IdKind::Other;
}

/// What stands behind the last field of a card.
enum class RestOfLine {
  Nothing,  ///< or zeros
  Numbers,
  Remark,
};

RestOfLine rest_of(std::string_view text) {
  RestOfLine found = RestOfLine::Nothing;
  constexpr std::string_view between = ", \t";
  for (std::size_t at = text.find_first_not_of(between); at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(between, at), text.size());
    const std::optional<double> number = parse_real(text.substr(at, end - at));
    if (!number) return RestOfLine::Remark;
    if (*number != 0) found = RestOfLine::Numbers;
    at = text.find_first_not_of(between, end);
  }
  return found;
}

}  // namespace

const Card::Value& Card::value(std::string_view name) const {
  for (std::size_t i = 0; i < layout_.size(); ++i)
    if (layout_[i].name == name) return values_[i];
  assert(false && "the layout has no field of this name");
  return values_[0];
}

IdKind kind_of_target(const Card& card) {
  const std::string_view keyword = card.where().keyword;
  if (keyword.find("_SET") != std::string_view::npos) return IdKind::Set;
  return keyword.ends_with("_RIGID") || keyword.find("_RIGID_") != std::string_view::npos ? IdKind::Part
                                                                                          : IdKind::Node;
}

Cards::Cards(const Block& block, HeadingKind heading, const Parameters& parameters, Report& report)
    : block_(&block), heading_(heading), parameters_(&parameters), report_(&report) {}

bool Cards::more() const {
  return std::any_of(block_->lines.begin() + static_cast<std::ptrdiff_t>(next_), block_->lines.end(),
                     [](const Line& line) { return !trimmed(line.text).empty(); });
}

Card Cards::next_filled(Layout layout) {
  while (has_line() && trimmed(block_->lines[next_].text).empty()) ++next_;
  return next(layout);
}

/// A card of the layout with its defaults, at the keyword's place.
Card Cards::empty_card(Layout layout) {
  assert(layout.size() <= max_fields);
  Card card;
  card.layout_ = layout;
  card.where_ = block_->where;
  card.where_.card = ++card_;
  if (!block_->lines.empty()) card.where_.line = block_->lines.back().number;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    card.values_[i].good = !is_lost_;
    card.values_[i].real = layout[i].fallback;
    if (layout[i].type == FieldType::Integer)
      card.values_[i].integer = static_cast<std::int64_t>(layout[i].fallback);
  }
  return card;
}

/// Cuts the next line into the values of a card.
void Cards::take_line(Layout layout, Card& card) {
  const Line& line = block_->lines[next_++];
  card.where_.line = line.number;
  slots_.fill({});
  rest_ = {};
  cut_by_tab_ = false;
  free_ = is_free(line.text, layout);
  if (free_)
    split_free(line.text, layout);
  else
    split_fixed(without_tabs(line.text, layout, card.where_), layout);
}

/// Whether the line at hand has values, none of which is a number: a title, or a remark, out of its place.
bool Cards::is_stray(Layout layout) const {
  if (layout.empty() || layout[0].type == FieldType::Text || cut_by_tab_) return false;
  bool has_value = false;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    if (slots_[i].empty() || layout[i].type == FieldType::Text) continue;
    if (Parameters::is_reference(slots_[i]) || parse_real(slots_[i])) return false;
    has_value = true;
  }
  return has_value;
}

void Cards::report_missing(const Card& card, Layout layout) {
  // Where a card before was damaged, that may be one too many.
  if (is_damaged_) return;
  report_->error(
      card.where_, "missing card",
      fmt::format("the card is missing, expected one with {}; add it, a blank line takes all defaults",
                  list_of_names(layout)));
}

Card Cards::next(Layout layout) {
  if (uses_ != nullptr) uses_->push_back({layout, {}});
  Card card = empty_card(layout);
  bool is_found = false;
  while (has_line() && !is_found) {
    take_line(layout, card);
    is_found = !is_stray(layout);
    if (!is_found) {
      is_damaged_ = true;
      const auto first = static_cast<std::size_t>(
          std::find_if(slots_.begin(), slots_.end(), [](std::string_view slot) { return !slot.empty(); }) -
          slots_.begin());
      card.values_[first].text = slots_[first];
      read_number(first, card);
      unreadable_.resize(1);
      report_unreadable(card);
      is_lost_ = !has_line();
    }
  }
  if (!is_found) report_missing(card, layout);
  const bool absent = !is_found || cut_by_tab_;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    if (absent)
      card.values_[i].good = false;
    else
      parse(i, card);
  }
  report_unreadable(card);
  if (absent || (!layout.empty() && !card.values_[0].good)) is_damaged_ = true;
  if (!rest_.empty() && !absent) report_rest(card);
  add_offsets(card);
  if (placement().moves && !absent) place(card);
  return card;
}

const Placement& Cards::placement() const {
  static const Placement unmoved;
  return block_->placement != nullptr ? *block_->placement : unmoved;
}

void Cards::add_offsets(Card& card) {
  for (std::size_t i = 0; i < card.layout_.size(); ++i) {
    const Field& field = card.layout_[i];
    Card::Value& value = card.values_[i];
    value.written = value.integer;
    value.written_real = value.real;
    if (!field.is_id()) continue;
    const IdKind kind = field.choose != nullptr ? field.choose(card) : field.kind;
    if (kind == IdKind::None) continue;
    if (field.type == FieldType::Integer)
      value.integer = placement().id(kind, value.written);
    else if (value.real < 0)
      value.real = static_cast<double>(placement().id(kind, static_cast<std::int64_t>(value.real)));
  }
}

Card Cards::next_or_default(Layout layout) {
  return has_line() ? next(layout) : empty_card(layout);
}

bool Cards::is_free(std::string_view line, Layout layout) const {
  if (!ends_in_text(layout)) return line.find(',') != std::string_view::npos;
  int columns = 0;
  for (const Field& field : layout.first(layout.size() - 1)) columns += width_of(field);
  return line.substr(0, static_cast<std::size_t>(columns)).find(',') != std::string_view::npos;
}

int Cards::width_of(const Field& field) const {
  switch (block_->format) {
    case ColumnFormat::Standard:
      return field.width;
    case ColumnFormat::TenDigit:
      return std::max(field.width, 10);
    case ColumnFormat::Long:
      return std::max(field.width, 20);
  }
  return field.width;
}

void Cards::split_fixed(std::string_view line, Layout layout) {
  std::size_t column = 0;
  for (std::size_t i = 0; i < layout.size() && column < line.size(); ++i) {
    const std::size_t width = i + 1 == layout.size() && ends_in_text(layout)
                                  ? line.size()
                                  : static_cast<std::size_t>(width_of(layout[i]));
    slots_[i] = trimmed(line.substr(column, width));
    column += width;
  }
  // Cards of eight fields end at column 80 (or its like); remarks may follow there.
  const std::size_t end_of_card = block_->format == ColumnFormat::Long ? 160 : 80;
  if (column < std::min(line.size(), end_of_card)) rest_ = trimmed(line.substr(column, end_of_card - column));
}

void Cards::split_free(std::string_view line, Layout layout) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < layout.size() && start <= line.size(); ++i) {
    const bool takes_rest = i + 1 == layout.size() && ends_in_text(layout);
    const std::size_t comma = takes_rest ? std::string_view::npos : line.find(',', start);
    const std::size_t end = comma == std::string_view::npos ? line.size() : comma;
    slots_[i] = trimmed(line.substr(start, end - start));
    start = end + 1;
  }
  if (start <= line.size()) rest_ = trimmed(line.substr(start));
}

std::string_view Cards::without_tabs(std::string_view line, Layout layout, const Where& where) {
  if (line.find('\t') == std::string_view::npos) return line;
  expanded_.clear();
  for (const char c : line) {
    if (c == '\t')
      expanded_.append(advance_tab(expanded_.size()) - expanded_.size(), ' ');
    else
      expanded_.push_back(c);
  }
  // A tab shows differently in every editor, so a value cut by the edge of a field is never taken.
  std::size_t edge = 0;
  for (const Field& field : layout) {
    edge += static_cast<std::size_t>(width_of(field));
    if (ends_in_text(layout) && &field == &layout.back()) break;
    if (edge < expanded_.size() && expanded_[edge] != ' ' && expanded_[edge - 1] != ' ') {
      report_->error(
          where, "tab",
          fmt::format("the line has tabs, and with tab stops of 8 columns the field {} cuts a value "
                      "in two; use blanks or commas",
                      field.name));
      cut_by_tab_ = true;
      break;
    }
  }
  return expanded_;
}

std::string Cards::place_of(std::size_t field, Layout layout) const {
  if (free_) return fmt::format("value {} of the line", field + 1);
  int first = 1;
  for (std::size_t i = 0; i < field; ++i) first += width_of(layout[i]);
  return fmt::format("columns {}-{} of the line", first, first + width_of(layout[field]) - 1);
}

void Cards::parse(std::size_t index, Card& card) {
  const Field& field = card.layout_[index];
  Card::Value& value = card.values_[index];
  value.text = slots_[index];
  if (field.type == FieldType::Text) return;
  if (!value.text.empty() && !read_number(index, card)) {
    value.good = false;
    return;
  }
  constexpr double largest_id = 1e15;  // which a real number holds exactly
  if (field.type == FieldType::Real && field.is_id() && value.real < 0 &&
      (value.real < -largest_id || value.real != std::trunc(value.real))) {
    report_->field_error(card.where_,
                         {field.name, std::string(value.text),
                          "a number that is not negative, or minus the id of another item", "", "id"});
    value.real = 0;
    value.good = false;
    return;
  }
  const bool refers = Parameters::is_reference(value.text);
  const CheckResult result =
      check_field(field, value.real, refers ? fmt::format("{} = {:g}", value.text, value.real) : value.text);
  if (!result.fault) return;
  value.good = result.is_harmless;
  if (result.is_harmless) {
    report_->field_warning(card.where_, *result.fault);
  } else if (result.is_unsupported) {
    FieldFault fault = *result.fault;
    if (report_->allow_unsupported()) fault.hint += fmt::format("; {} is used", field.fallback);
    report_->field_unsupported(card.where_, fault);
    value.real = field.fallback;
  } else {
    report_->field_error(card.where_, *result.fault);
  }
}

bool Cards::read_number(std::size_t index, Card& card) {
  const Field& field = card.layout_[index];
  Card::Value& value = card.values_[index];
  std::string_view text = value.text;
  std::optional<std::string> substituted;
  if (Parameters::is_reference(text)) {
    substituted = parameters_->substitute(text);
    if (!substituted) {
      report_->field_error(card.where_, {field.name, std::string(text), "a parameter that is defined",
                                         "define it with *PARAMETER before this line, or give it on the "
                                         "command line with --parameter NAME=NUMBER",
                                         "parameter", upper_case(text)});
      return false;
    }
    text = *substituted;
  }
  const bool whole = field.type == FieldType::Integer;
  const std::optional<std::int64_t> integer = whole ? parse_integer(text) : std::nullopt;
  const std::optional<double> real = whole ? std::nullopt : parse_real(text);
  if (!integer && !real) {
    std::string hint = place_of(index, card.layout_);
    if (substituted) hint += fmt::format(", where {} is \"{}\"", value.text, *substituted);
    unreadable_.push_back(
        {field.name, std::string(value.text), whole ? "a whole number" : "a number", hint, "number"});
    return false;
  }
  const double number = integer ? static_cast<double>(*integer) : *real;
  if (number == 0 && field.zero_is_default) return true;
  value.real = number;
  value.integer = integer.value_or(0);
  return true;
}

/// Two values may be mistyped; more on one card are a card of another layout, or shifted columns.
void Cards::report_unreadable(const Card& card) {
  constexpr std::size_t typing_errors = 2;
  if (unreadable_.size() > typing_errors) {
    unreadable_.front().hint += fmt::format(
        "; {} more fields of the card are not numbers either: does the line stand in its place, and are its "
        "columns right?",
        unreadable_.size() - 1);
    unreadable_.resize(1);
  }
  for (const FieldFault& fault : unreadable_) report_->field_error(card.where_, fault);
  unreadable_.clear();
}

void Cards::report_rest(const Card& card) {
  // Zeros behind the last field are fields of other versions of the format, switched off.
  const RestOfLine rest = rest_of(rest_);
  if (rest == RestOfLine::Nothing) return;
  const std::string message =
      fmt::format("\"{}\" stands behind the last field known ({}) and is not read; remove it", rest_,
                  card.layout_.back().name);
  if (rest == RestOfLine::Numbers)
    report_->unsupported(card.where_, "rest", message);
  else
    report_->warning(card.where_, "rest", message);
}

void Cards::report_unread() {
  for (; has_line(); ++next_) {
    const Line& line = block_->lines[next_];
    if (line.text.find_first_not_of("0.,+-eEdD \t") == std::string_view::npos) continue;
    Where where = block_->where;
    where.line = line.number;
    report_->unsupported(where, "unread",
                         fmt::format("read \"{}\" behind the last card that is known; remove the line",
                                     line.text.substr(0, 80)));
    skip_rest();
    return;
  }
}

Heading Cards::heading() {
  Heading result;
  if (heading_ == HeadingKind::None) return result;
  if (heading_ == HeadingKind::Title) {
    result.title = text_line("a title");
    return result;
  }
  static constexpr Field identity[] = {row::reference("ID", kind_of_heading), row::text("HEADING", 70)};
  const std::int32_t count = card_;
  const Card card = next(identity);
  card_ = count;
  result.id = card.integer("ID");
  result.title = card.text("HEADING");
  return result;
}

std::string Cards::text_line(std::string_view what) {
  if (uses_ != nullptr) uses_->push_back({{}, what});
  if (!has_line()) {
    if (!is_lost_)
      report_->error(block_->where, "missing line", fmt::format("a line is missing, expected {}", what));
    return {};
  }
  return std::string(trimmed(block_->lines[next_++].text));
}

}  // namespace crumple::deck
