// SPDX-License-Identifier: BSD-3-Clause
// *DEFINE_CURVE, *DEFINE_TABLE, *SET_NODE_LIST, *SET_PART_LIST.
#include <fmt/format.h>

#include <cmath>

#include "base/counted.hpp"
#include "deck/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field curve_card[] = {
    id("LCID"),
    harmless("SIDR", {0, 2}, "there is no dynamic relaxation; the curve holds for the run"),
    real_or_default("SFA", 1.0),
    real_or_default("SFO", 1.0),
    real("OFFA"),
    real("OFFO"),
    only("DATTYP", {0}, "curves are functions, given by points"),
    unused("LCINT"),  // the points are used as they are, not resampled
};

constexpr Field table_card[] = {id("TBID"), real_or_default("SFA", 1.0), real("OFFA")};

constexpr Field value_card[] = {sized(20, real("VALUE"))};

constexpr Field value_curve_card[] = {sized(20, real("VALUE")), sized(20, id("CURVEID"))};

constexpr Field point_card[] = {sized(20, real("A")), sized(20, real("O"))};

// DA1-4 are values that other keywords may take from the set; those here do not.
constexpr Field set_card[] = {id("SID"),     unused("DA1"),      unused("DA2"), unused("DA3"),
                              unused("DA4"), text("SOLVER", 10), unused("ITS")};

constexpr Field member_card[] = {reference("ID1"), reference("ID2"), reference("ID3"), reference("ID4"),
                                 reference("ID5"), reference("ID6"), reference("ID7"), reference("ID8")};

enum class Members { Single, Ranges };

void read_set(Cards& cards, std::vector<RawSet>& sets, Members members) {
  RawSet set;
  set.title = cards.heading().title;
  const Card card = cards.next(set_card);
  set.id = card.integer("SID");
  set.where = card.where();
  while (cards.more()) {
    const Card list = cards.next_filled(member_card);
    const std::size_t stride = members == Members::Ranges ? 2 : 1;
    for (std::size_t i = 0; i < std::size(member_card); i += stride) {
      const std::int64_t first = list.good(i) ? list.integer(i) : 0;
      const std::int64_t last = members == Members::Ranges && list.good(i + 1) ? list.integer(i + 1) : first;
      if (first == 0) continue;
      if (last < first)
        cards.report().field_error(list.where(), {member_card[i + 1].name, std::to_string(last),
                                                  fmt::format("a number not below {}", first),
                                                  "ranges go from the first to the last id", "range"});
      else
        set.members.push_back({first, last, list.where().line, list.where().card});
    }
  }
  if (card.good("SID")) sets.push_back(std::move(set));
}

}  // namespace

void read_define_curve(Cards& cards, RawDeck& deck) {
  cards.heading();
  const Card card = cards.next(curve_card);
  RawCurve raw;
  raw.curve.id = card.integer("LCID");
  raw.where = card.where();
  while (cards.more()) {
    const Card point = cards.next_filled(point_card);
    if (!point.good("A") || !point.good("O")) continue;
    const double abscissa = card.real("SFA") * (point.real("A") + card.real("OFFA"));
    const double ordinate = card.real("SFO") * (point.real("O") + card.real("OFFO"));
    if (!std::isfinite(abscissa) || !std::isfinite(ordinate))
      cards.report().error(point.where(), "range", "the point is out of the range of numbers once scaled");
    if (!raw.curve.abscissa.empty() && abscissa <= raw.curve.abscissa.back())
      cards.report().field_error(
          point.where(), {"A", std::string(point.text("A")), "a value above that of the point before it",
                          "the points of a curve ascend", "order"});
    raw.curve.abscissa.push_back(abscissa);
    raw.curve.ordinate.push_back(ordinate);
  }
  if (raw.curve.abscissa.size() < 2)
    cards.report().error(
        card.where(), "points",
        fmt::format("the curve has {}, expected at least two", counted(raw.curve.abscissa.size(), "point")));
  if (card.good("LCID")) deck.curves.push_back(std::move(raw));
}

namespace {

/// The first card of a table.
RawTable table_of(Cards& cards, const RawDeck& deck, Card& card) {
  cards.heading();
  card = cards.next(table_card);
  RawTable raw;
  raw.id = card.integer("TBID");
  raw.where = card.where();
  raw.first_curve = deck.curves.size();
  return raw;
}

void add_value(const Card& card, const Card& point, RawTable& raw, Report& report) {
  const double value = card.real("SFA") * (point.real("VALUE") + card.real("OFFA"));
  if (!raw.value.empty() && value <= raw.value.back())
    report.field_error(point.where(),
                       {"VALUE", std::string(point.text("VALUE")), "a value above the one before it",
                        "the values of a table ascend", "order"});
  raw.value.push_back(value);
}

}  // namespace

void read_define_table(Cards& cards, RawDeck& deck) {
  Card card;
  RawTable raw = table_of(cards, deck, card);
  while (cards.more()) add_value(card, cards.next_filled(value_card), raw, cards.report());
  if (card.good("TBID")) deck.tables.push_back(std::move(raw));
}

void read_define_table_2d(Cards& cards, RawDeck& deck) {
  Card card;
  RawTable raw = table_of(cards, deck, card);
  while (cards.more()) {
    const Card point = cards.next_filled(value_curve_card);
    add_value(card, point, raw, cards.report());
    raw.curve.push_back(point.integer("CURVEID"));
  }
  if (card.good("TBID")) deck.tables.push_back(std::move(raw));
}

void read_set_node_list(Cards& cards, RawDeck& deck) {
  read_set(cards, deck.node_sets, Members::Single);
}

void read_set_node_list_generate(Cards& cards, RawDeck& deck) {
  read_set(cards, deck.node_sets, Members::Ranges);
}

void read_set_part_list(Cards& cards, RawDeck& deck) {
  read_set(cards, deck.part_sets, Members::Single);
}

void read_set_part_list_generate(Cards& cards, RawDeck& deck) {
  read_set(cards, deck.part_sets, Members::Ranges);
}

}  // namespace crumple::deck
