// SPDX-License-Identifier: BSD-3-Clause
// *DATABASE: what to write, and how often.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view constant_interval =
    "the interval is DT throughout; give the smallest one that the curve has";

constexpr Field interval_card[] = {
    real("DT", 0, not_negative),
    harmless("BINARY", {0, 1, 2, 3}, "the file is written in both forms"),
    harmless("LCUR", {0}, constant_interval),
    unused("IOOPT"),
    unused("OPTION1"),
    unused("OPTION2"),
    unused("OPTION3"),
    unused("OPTION4"),
};

constexpr Field state_card[] = {
    real("DT", 0, not_negative),       harmless("LCDT", {0}, constant_interval),         unused("BEAM"),
    integer("NPLTC", 0, not_negative), harmless("PSETID", {0}, "all parts are written"), unused("CID"),
};

constexpr Field dump_card[] = {
    integer("CYCL", 0, not_negative),
};

constexpr Field running_card[] = {
    integer("CYCL", 0, not_negative),
    integer_or_default("NR", 1, not_negative),
};

constexpr std::string_view written = "the values are written";
constexpr std::string_view not_written = "the states hold no such values";

constexpr Field extent_card_1[] = {
    integer("NEIPH", 0, not_negative),      integer("NEIPS", 0, not_negative),
    integer_or_default("MAXINT", 3),        harmless("STRFLG", {0}, not_written),
    harmless("SIGFLG", {1, 0, 2}, written), harmless("EPSFLG", {1, 0, 2}, written),
    harmless("RLTFLG", {1, 0, 2}, written), harmless("ENGFLG", {1, 0, 2}, written),
};

constexpr Field extent_card_2[] = {
    harmless("CMPFLG", {0}, "stresses are along global axes"),
    harmless("IEVERP", {0}, "files hold as many states as fit"),
    harmless("BEAMIP", {0}, not_written),
    unused("DCOMP"),
    unused("SHGE"),
    unused("STSSZ"),
    unused("N3THDT"),
    unused("IALEMAT"),
};

/// What a keyword of histories names.
IdKind kind_of_history(const Card& card) {
  if (card.where().keyword.find("_SET") != std::string_view::npos) return IdKind::Set;
  return card.where().keyword.find("_NODE") != std::string_view::npos ? IdKind::Node : IdKind::Element;
}

constexpr Field history_card[] = {
    reference("ID1", kind_of_history), reference("ID2", kind_of_history), reference("ID3", kind_of_history),
    reference("ID4", kind_of_history), reference("ID5", kind_of_history), reference("ID6", kind_of_history),
    reference("ID7", kind_of_history), reference("ID8", kind_of_history),
};

constexpr Field reference_axes =
    only("REF", {0, 1}, "0: axes at time zero, 1: axes that move with the three nodes of the system");
constexpr Field high_frequency = harmless("HFO", {0}, "there is one file for all times");
constexpr Field local_node_card[] = {id("ID", IdKind::Node), reference("CID"), reference_axes,
                                     high_frequency};
constexpr Field local_set_card[] = {id("ID", IdKind::Set), reference("CID"), reference_axes, high_frequency};

constexpr Field named_history_card[] = {id("ID", kind_of_history), text("HEADING", 70)};

void read_histories(Cards& cards, RawDeck& deck, HistoryItem item, bool is_set) {
  while (cards.more()) {
    const Card card = cards.next_filled(history_card);
    for (std::size_t i = 0; i < std::size(history_card); ++i)
      if (card.good(i) && card.integer(i) > 0)
        deck.histories.push_back({card.integer(i), is_set, card.where(), item});
  }
}

void read_local_history(Cards& cards, Layout layout, bool is_set, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(layout);
    RawHistory raw;
    raw.id = card.integer("ID");
    raw.is_set = is_set;
    raw.where = card.where();
    raw.system = card.integer("CID");
    raw.moving = card.real("REF") == 1;
    if (card.good("ID") && card.good("CID") && card.good("REF")) deck.histories.push_back(raw);
  }
}

}  // namespace

void read_database_history_node_local(Cards& cards, RawDeck& deck) {
  read_local_history(cards, local_node_card, false, deck);
}

void read_database_history_node_set_local(Cards& cards, RawDeck& deck) {
  read_local_history(cards, local_set_card, true, deck);
}

void read_database_history_file(Cards& cards, RawDeck& deck, model::HistoryFile file) {
  const Card card = cards.next(interval_card);
  model::HistoryRequest& request = deck.output.of(file);
  request.asked = true;
  request.interval = card.real("DT");
  const double form = card.real("BINARY");
  request.ascii = form != 2;
  request.binary = form != 1;
}

void read_database_history_ids(Cards& cards, RawDeck& deck, HistoryItem item) {
  read_histories(cards, deck, item, false);
}

void read_database_history_sets(Cards& cards, RawDeck& deck, HistoryItem item) {
  read_histories(cards, deck, item, true);
}

void read_database_history_named(Cards& cards, RawDeck& deck, HistoryItem item) {
  while (cards.more()) {
    const Card card = cards.next_filled(named_history_card);
    if (card.good("ID")) deck.histories.push_back({card.integer("ID"), false, card.where(), item});
  }
}

void read_database_binary_d3plot(Cards& cards, RawDeck& deck) {
  const Card card = cards.next(state_card);
  deck.output.state_interval = card.real("DT");
  deck.state_count = card.good("NPLTC") ? card.integer("NPLTC") : 0;
  cards.skip_rest();  // further cards choose what LS-DYNA's own file holds
}

void read_database_binary_d3dump(Cards& cards, RawDeck& deck) {
  const Card card = cards.next(dump_card);
  if (card.good("CYCL")) deck.output.restart.dump_cycles = card.integer("CYCL");
}

void read_database_binary_runrsf(Cards& cards, RawDeck& deck) {
  const Card card = cards.next(running_card);
  if (card.good("CYCL")) deck.output.restart.running_cycles = card.integer("CYCL");
  if (card.good("NR")) deck.output.restart.running_files = static_cast<int>(card.integer("NR"));
}

void read_database_extent_binary(Cards& cards, RawDeck& deck) {
  constexpr int default_points = 3;
  constexpr double off = 2;
  const Card card = cards.next(extent_card_1);
  model::StateExtent& extent = deck.output.extent;
  if (card.good("NEIPH")) extent.solid_history = static_cast<int>(card.integer("NEIPH"));
  if (card.good("NEIPS")) extent.shell_history = static_cast<int>(card.integer("NEIPS"));
  if (card.good("MAXINT")) extent.shell_points = static_cast<int>(card.integer("MAXINT"));
  if (extent.shell_points < default_points) {
    cards.report().field_warning(
        card.where(), {"MAXINT", std::string(card.text("MAXINT")), "3 or more",
                       "the states hold the middle, the inner and the outer surface of shells", "value"});
    extent.shell_points = default_points;
  }
  extent.stresses = card.real("SIGFLG") != off;
  extent.plastic_strain = card.real("EPSFLG") != off;
  extent.resultants = card.real("RLTFLG") != off;
  extent.energy = card.real("ENGFLG") != off;
  if (cards.more()) cards.next(extent_card_2);
  cards.skip_rest();  // further cards are about kinds of elements and values that the states do not have
}

}  // namespace crumple::deck
