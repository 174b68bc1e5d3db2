// SPDX-License-Identifier: BSD-3-Clause
// *DEFINE_FRICTION.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field friction_card[] = {
    id("ID", IdKind::Definition),  real("FS_D", 0, not_negative),
    real("FD_D", 0, not_negative), real("DC_D", 0, not_negative),
    real("VC_D", 0, not_negative), only("ICNEP", {0, 1}, "1 leaves out lines with parts that are not there"),
};

constexpr std::string_view of_sets = "PSET";

IdKind kind_of_first(const Card& card) {
  return card.text("PTYPEI") == of_sets ? IdKind::Set : IdKind::Part;
}
IdKind kind_of_second(const Card& card) {
  return card.text("PTYPEJ") == of_sets ? IdKind::Set : IdKind::Part;
}

constexpr Field pair_card[] = {
    id("PID_I", kind_of_first),
    id("PID_J", kind_of_second),
    real("FS_IJ", 0, not_negative),
    real("FD_IJ", 0, not_negative),
    real("DC_IJ", 0, not_negative),
    real("VC_IJ", 0, not_negative),
    text("PTYPEI", 10),
    text("PTYPEJ", 10),
};

/// Whether an id is that of a part set; reports an error if the type is neither.
bool is_set(const Card& card, std::string_view field, Report& report) {
  const std::string_view type = card.text(field);
  if (!type.empty() && type != of_sets)
    report.field_error(card.where(), {field, std::string(type), "PSET, or nothing",
                                      "PSET is a part set, without it the number is that of a part", "type"});
  return type == of_sets;
}

}  // namespace

void read_define_friction(Cards& cards, RawDeck& deck) {
  cards.heading();
  const Card card = cards.next(friction_card);
  RawFrictionTable table;
  table.id = card.integer("ID");
  table.others = {card.real("FS_D"), card.real("FD_D"), card.real("DC_D"), card.real("VC_D")};
  table.skips_missing = card.real("ICNEP") == 1;
  table.where = card.where();
  while (cards.more()) {
    const Card line = cards.next_filled(pair_card);
    RawFrictionTable::Pair pair;
    pair.id = {line.integer("PID_I"), line.integer("PID_J")};
    pair.is_set = {is_set(line, "PTYPEI", cards.report()), is_set(line, "PTYPEJ", cards.report())};
    pair.friction = {line.real("FS_IJ"), line.real("FD_IJ"), line.real("DC_IJ"), line.real("VC_IJ")};
    pair.where = line.where();
    if (line.good("PID_I") && line.good("PID_J")) table.pairs.push_back(pair);
  }
  if (card.good("ID")) deck.friction_tables.push_back(std::move(table));
}

}  // namespace crumple::deck
