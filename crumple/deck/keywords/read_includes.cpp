// SPDX-License-Identifier: BSD-3-Clause
// *INCLUDE_TRANSFORM.
#include "deck/keywords/read_includes.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "deck/format/numbers.hpp"

namespace crumple::deck {

namespace {

using namespace row;

/// Ids with an offset stay far from the end of the whole numbers, and above zero.
constexpr Field offset(std::string_view name) {
  return integer(name, 0, within(0, 1e15, "what is added to the ids of this kind"));
}

constexpr Field offset_card[] = {offset("IDNOFF"), offset("IDEOFF"), offset("IDPOFF"), offset("IDMOFF"),
                                 offset("IDSOFF"), offset("IDFOFF"), offset("IDDOFF")};

constexpr Field other_offset_card[] = {
    offset("IDROFF"),
    unused("-"),
    text("PREFIX", 10),  // of titles, which nothing is found by
    text("SUFFIX", 10),
};

/// A factor of units, of which a blank one and a zero are one.
constexpr Field unit_factor(std::string_view name) {
  Field field =
      only(name, {1}, "the units of a file cannot be changed; convert the file to those of the deck");
  field.zero_is_default = true;
  return field;
}

constexpr Field unit_card[] = {
    unit_factor("FCTMAS"), unit_factor("FCTTIM"), unit_factor("FCTLEN"), text("FCTTEM", 10),
    unused("INCOUT1"),  // LS-DYNA writes the file as it has become
};

constexpr Field transform_card[] = {reference("TRANID")};

/// The name of the file; empty if it is not finished.
std::string name_of_file(Cards& cards) {
  std::string name;
  while (cards.has_line()) {
    const std::string line = cards.text_line("the name of a file");
    if (!append_name(name, line) && !line.empty()) return name;
  }
  if (!name.empty()) report_unfinished_name(cards.where(), "file", cards.report());
  return {};
}

void take_offsets(const Card& first, const Card& second, IdOffsets& offsets) {
  struct Offset {
    std::string_view field;
    IdKind kind;
  };
  constexpr Offset all[] = {{"IDNOFF", IdKind::Node},       {"IDEOFF", IdKind::Element},
                            {"IDPOFF", IdKind::Part},       {"IDMOFF", IdKind::Material},
                            {"IDSOFF", IdKind::Set},        {"IDFOFF", IdKind::Function},
                            {"IDDOFF", IdKind::Definition}, {"IDROFF", IdKind::Other}};
  for (const Offset& one : all) {
    const Card& card = one.kind == IdKind::Other ? second : first;
    if (card.good(one.field)) offsets[static_cast<std::size_t>(one.kind)] += card.integer(one.field);
  }
}

/// FCTTEM names a change of the unit of temperature.
void check_temperature(const Card& card, const Cards& cards) {
  const std::string_view text = card.text("FCTTEM");
  const std::optional<std::string> value =
      Parameters::is_reference(text) ? cards.parameters().substitute(text) : std::nullopt;
  const std::optional<double> number = parse_real(value ? std::string_view(*value) : text);
  if (text.empty() || (number && (*number == 0 || *number == 1))) return;
  cards.report().field_unsupported(card.where(), {"FCTTEM", std::string(text), "1, or nothing",
                                                  "the units of a file cannot be changed", "value"});
}

/// The file goes where the transformation puts it, and from there with the file around it.
void take_transformation(const Card& card, const RawDeck& deck, Placement& placement, Report& report) {
  const UserId id = card.integer("TRANID");
  if (id == 0 || !card.good("TRANID")) return;
  const auto found = std::find_if(deck.transformations.begin(), deck.transformations.end(),
                                  [&](const RawTransformation& raw) { return raw.id == id; });
  if (found == deck.transformations.end()) {
    report.field_error(card.where(), {"TRANID", std::to_string(id), "the id of a transformation",
                                      "define it with *DEFINE_TRANSFORMATION before this line", "reference"});
    return;
  }
  placement.map = then(found->map, placement.map);
  placement.moves = true;
}

}  // namespace

std::vector<Inclusion> read_include_transform(Cards& cards, const RawDeck& deck,
                                              std::deque<Placement>& placements) {
  std::vector<Inclusion> inclusions;
  const auto next_or_blank = [&](Layout layout) {
    return cards.has_line() ? std::optional<Card>(cards.next(layout)) : std::nullopt;
  };
  while (cards.more()) {
    Inclusion inclusion{name_of_file(cards), cards.where(), nullptr};
    if (inclusion.name.empty()) return inclusions;
    Placement placement = cards.placement();
    const Card first = cards.next(offset_card);
    inclusion.where.line = first.where().line - 1;
    if (const auto second = next_or_blank(other_offset_card)) {
      take_offsets(first, *second, placement.offsets);
      if (const auto units = next_or_blank(unit_card)) check_temperature(*units, cards);
      if (const auto transform = next_or_blank(transform_card))
        take_transformation(*transform, deck, placement, cards.report());
    } else if (first.good("IDNOFF")) {
      cards.report().error(first.where(), "missing card",
                           "the card with IDROFF is missing; add it, a blank line is zero");
    }
    placements.push_back(placement);
    inclusion.placement = &placements.back();
    inclusions.push_back(std::move(inclusion));
  }
  if (inclusions.empty())
    cards.report().warning(
        cards.where(), "name",
        "the name of the file is missing, expected it on the next line; nothing is included");
  return inclusions;
}

}  // namespace crumple::deck
