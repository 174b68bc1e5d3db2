// SPDX-License-Identifier: BSD-3-Clause
// *SET_NODE, *SET_PART, *SET_SHELL, *SET_SOLID, *SET_BEAM, *SET_DISCRETE, *SET_SEGMENT, *DEFINE_BOX.
#include <fmt/core.h>

#include <algorithm>
#include <span>

#include "deck/format/numbers.hpp"
#include "deck/keywords/families.hpp"
#include "deck/keywords/mirrored.hpp"

namespace crumple::deck {

namespace {

using namespace row;
using What = RawMember::What;

constexpr Field box_card[] = {id("BOXID"), real("XMN"), real("XMX"), real("YMN"),
                              real("YMX"), real("ZMN"), real("ZMX")};

// DA1-4 are values that other keywords may take from the set: *CONTACT_INTERIOR does.
constexpr Field set_card[] = {id("SID"),     unused("DA1"),      unused("DA2"), unused("DA3"),
                              unused("DA4"), text("SOLVER", 10), unused("ITS")};

/// What the members of a set are.
IdKind kind_of_members(const Card& card) {
  if (card.where().keyword.starts_with("*SET_NODE")) return IdKind::Node;
  return card.where().keyword.starts_with("*SET_PART") ? IdKind::Part : IdKind::Element;
}

/// What the first field of a card of a GENERAL set says that the others are.
IdKind kind_of_option(const Card& card);

constexpr Field member_card[] = {
    reference("ID1", kind_of_members), reference("ID2", kind_of_members), reference("ID3", kind_of_members),
    reference("ID4", kind_of_members), reference("ID5", kind_of_members), reference("ID6", kind_of_members),
    reference("ID7", kind_of_members), reference("ID8", kind_of_members),
};

// The numbers behind a member are its own values of DA1-4.
constexpr Field column_card[] = {reference("ID", kind_of_members), unused("A1"), unused("A2"), unused("A3"),
                                 unused("A4")};

constexpr Field increment_card[] = {reference("BBEG", kind_of_members), reference("BEND", kind_of_members),
                                    integer_or_default("INCR", 1, above_zero)};

// A set below zero ends a range of sets.
constexpr Field sets_card[] = {
    signed_id("SID1", IdKind::Set), signed_id("SID2", IdKind::Set), signed_id("SID3", IdKind::Set),
    signed_id("SID4", IdKind::Set), signed_id("SID5", IdKind::Set), signed_id("SID6", IdKind::Set),
    signed_id("SID7", IdKind::Set), signed_id("SID8", IdKind::Set),
};

constexpr Field segment_card[] = {
    id("N1"),     id("N2"),     id("N3"),     reference("N4"),
    unused("A1"), unused("A2"), unused("A3"), unused("A4"),  // values that other keywords may take
};

constexpr Field general_card[] = {
    text("OPTION", 10),
    signed_id("E1", kind_of_option),
    signed_id("E2", kind_of_option),
    signed_id("E3", kind_of_option),
    signed_id("E4", kind_of_option),
    signed_id("E5", kind_of_option),
    signed_id("E6", kind_of_option),
    signed_id("E7", kind_of_option),
};

/// What the first field of a card of a GENERAL set may say. Behind the ids stand attributes of segments.
struct Option {
  std::string_view name;
  What what;
  bool removes;
  std::size_t ids;
};

constexpr Option node_options[] = {
    {"ALL", What::All, false, 0},
    {"NODE", What::Member, false, 7},
    {"DNODE", What::Member, true, 7},
    {"PART", What::Part, false, 7},
    {"DPART", What::Part, true, 7},
    {"BOX", What::Box, false, 7},
    {"DBOX", What::Box, true, 7},
    {"SHELL", What::Shell, false, 7},
    {"DSHELL", What::Shell, true, 7},
    {"SOLID", What::Solid, false, 7},
    {"DSOLID", What::Solid, true, 7},
    {"BEAM", What::Beam, false, 7},
    {"DBEAM", What::Beam, true, 7},
    {"DISCRETE", What::Discrete, false, 7},
    {"DDISCRETE", What::Discrete, true, 7},
    {"SET", What::OwnSet, false, 7},
    {"DSET", What::OwnSet, true, 7},
    {"SET_NODE", What::OwnSet, false, 7},
    {"DSET_NODE", What::OwnSet, true, 7},
    {"SET_SHELL", What::ShellSet, false, 7},
    {"DSET_SHELL", What::ShellSet, true, 7},
    {"SET_SOLID", What::SolidSet, false, 7},
    {"DSET_SOLID", What::SolidSet, true, 7},
    {"SET_BEAM", What::BeamSet, false, 7},
    {"DSET_BEAM", What::BeamSet, true, 7},
    {"SET_DISCRETE", What::DiscreteSet, false, 7},
    {"DSET_DISCRETE", What::DiscreteSet, true, 7},
};

constexpr Option part_options[] = {
    {"ALL", What::All, false, 0},    {"PART", What::Member, false, 7}, {"DPART", What::Member, true, 7},
    {"SET", What::OwnSet, false, 7}, {"DSET", What::OwnSet, true, 7},
};

constexpr Option element_options[] = {
    {"ALL", What::All, false, 0},   {"ELEM", What::Member, false, 7}, {"DELEM", What::Member, true, 7},
    {"PART", What::Part, false, 7}, {"DPART", What::Part, true, 7},   {"BOX", What::Box, false, 7},
    {"DBOX", What::Box, true, 7},
};

constexpr Option segment_options[] = {
    {"ALL", What::All, false, 0},
    {"BOX", What::Box, false, 3},
    {"BOX_SHELL", What::BoxOfShells, false, 3},
    {"BOX_SLDIO", What::BoxOfAllFaces, false, 3},
    {"BOX_SOLID", What::BoxOfSolids, false, 3},
    {"PART", What::Part, false, 3},
    {"PART_IO", What::PartWithInside, false, 3},
    {"SEG", What::Segment, false, 4},
    {"SET", What::OwnSet, false, 7},
    {"SET_SHELL", What::ShellSet, false, 3},
    {"SET_SLDIO", What::SolidSetWithInside, false, 3},
    {"SET_SOLID", What::SolidSet, false, 3},
    {"SHELL", What::Shell, false, 3},
    {"DBOX", What::Box, true, 7},
    {"DBOX_SHELL", What::BoxOfShells, true, 7},
    {"DBOX_SOLID", What::BoxOfSolids, true, 7},
    {"DPART", What::Part, true, 7},
    {"DSEG", What::Segment, true, 4},
    {"DSET", What::OwnSet, true, 7},
};

IdKind kind_of_option(const Card& card) {
  const std::string name = upper_case(card.text("OPTION"));
  const bool removes = name.starts_with('D') && name != "DISCRETE";
  const std::string_view what = removes ? std::string_view(name).substr(1) : name;
  if (what.starts_with("BOX")) return IdKind::Definition;
  if (what.starts_with("SET")) return IdKind::Set;
  if (what == "PART" || what == "PART_IO") return IdKind::Part;
  return what == "NODE" || what == "SEG" ? IdKind::Node : IdKind::Element;
}

/// The first card of a set, the members to come. `good` is false if it has no id.
RawSet begin_set(Cards& cards, bool& good) {
  RawSet set;
  set.title = cards.heading().title;
  const Card card = cards.next(set_card);
  set.id = card.integer("SID");
  set.attributes = {card.real("DA1"), card.real("DA2"), card.real("DA3"), card.real("DA4")};
  set.where = card.where();
  set.collects = set.where.keyword.find("_COLLECT") != std::string_view::npos;
  good = card.good("SID");
  return set;
}

/// Adds a set to those of its kind, or its members to the one that it continues.
void end_set(RawSet&& set, std::vector<RawSet>& sets) {
  const auto is_same = [&](const RawSet& other) { return other.collects && other.id == set.id; };
  const auto first = set.collects ? std::find_if(sets.begin(), sets.end(), is_same) : sets.end();
  if (first == sets.end())
    sets.push_back(std::move(set));
  else
    first->members.insert(first->members.end(), set.members.begin(), set.members.end());
}

RawMember member_of(const Card& card, std::string_view field, UserId id) {
  RawMember member;
  member.first = member.last = id;
  member.field = field;
  member.where = card.where();
  return member;
}

/// Adds a range; one that ends before it begins is reported.
void add_range(const Card& card, std::string_view field, RawMember member, RawSet& set, Report& report) {
  if (member.last < member.first)
    report.field_error(
        card.where(), {field, std::to_string(member.last), fmt::format("a number not below {}", member.first),
                       "ranges go from the first to the last id", "range"});
  else
    set.members.push_back(member);
}

void read_ids(const Card& card, SetForm form, RawSet& set, Report& report) {
  const std::size_t stride = form == SetForm::Generate ? 2 : 1;
  for (std::size_t i = 0; i < std::size(member_card); i += stride) {
    const std::int64_t first = card.good(i) ? card.integer(i) : 0;
    if (first == 0) continue;
    RawMember member = member_of(card, "ID", first);
    if (form == SetForm::Generate && card.good(i + 1)) member.last = card.integer(i + 1);
    add_range(card, member_card[std::min(i + 1, std::size(member_card) - 1)].name, member, set, report);
  }
}

void read_list(Cards& cards, std::vector<RawSet>& sets, SetForm form) {
  bool good = false;
  RawSet set = begin_set(cards, good);
  while (cards.more()) {
    if (form == SetForm::Column) {
      const Card card = cards.next_filled(column_card);
      if (card.good("ID") && card.integer("ID") != 0)
        set.members.push_back(member_of(card, "ID", card.integer("ID")));
      continue;
    }
    if (form != SetForm::GenerateIncrement) {
      read_ids(cards.next_filled(member_card), form, set, cards.report());
      continue;
    }
    const Card card = cards.next_filled(increment_card);
    if (!card.good("BBEG") || !card.good("BEND") || !card.good("INCR")) continue;
    RawMember member = member_of(card, "BBEG", card.integer("BBEG"));
    member.last = card.integer("BEND");
    member.increment = card.integer("INCR");
    add_range(card, "BEND", member, set, cards.report());
  }
  if (good) end_set(std::move(set), sets);
}

void read_add(Cards& cards, std::vector<RawSet>& sets) {
  bool good = false;
  RawSet set = begin_set(cards, good);
  while (cards.more()) {
    const Card card = cards.next_filled(sets_card);
    for (std::size_t i = 0; i < std::size(sets_card); ++i) {
      const std::int64_t id = card.good(i) ? card.integer(i) : 0;
      if (id == 0) continue;
      RawMember member = member_of(card, sets_card[i].name, id);
      member.what = What::OwnSet;
      if (id > 0) {
        set.members.push_back(member);
      } else if (set.members.empty()) {
        cards.report().field_error(card.where(),
                                   {sets_card[i].name, std::to_string(id), "a number above zero",
                                    "a set below zero ends a range, which the id before it begins", "range"});
      } else {
        member.first = set.members.back().last;
        member.last = -id;
        add_range(card, sets_card[i].name, member, set, cards.report());
      }
    }
  }
  if (good) end_set(std::move(set), sets);
}

/// N4 of zero is a triangle.
std::array<UserId, 4> nodes_of(const Card& card, std::size_t first, const Affine& map) {
  std::array<UserId, 4> node{};
  for (std::size_t i = 0; i < 4; ++i) node[i] = card.integer(first + i);
  if (node[3] == 0) node[3] = node[2];
  if (map.mirrors()) mirror_face(node, node[2] == node[3]);
  return node;
}

/// The nodes of SEG and DSEG, of which only the fourth may be zero.
void add_segment(const Card& card, const Affine& map, RawMember member, RawSet& set, Report& report) {
  for (std::size_t i = 1; i <= 4; ++i) {
    const UserId id = card.integer(i);
    if (!card.good(i) || id > 0 || (i == 4 && id == 0)) continue;
    report.field_error(card.where(), {general_card[i].name, std::to_string(id), "the id of a node",
                                      "a segment has three or four nodes", "value"});
    return;
  }
  member.node = nodes_of(card, 1, map);
  set.members.push_back(member);
}

void add_general(const Card& card, std::span<const Option> options, const Affine& map, RawSet& set,
                 Report& report) {
  const std::string name = upper_case(card.text("OPTION"));
  const auto option =
      std::find_if(options.begin(), options.end(), [&](const Option& o) { return o.name == name; });
  if (option == options.end()) {
    std::string names;
    for (const Option& known : options) names += fmt::format("{}{}", names.empty() ? "" : ", ", known.name);
    report.code_unsupported(card.where(), {"OPTION", std::string(card.text("OPTION")), "one of " + names,
                                           "others are not supported", "option"});
    return;
  }
  RawMember member = member_of(card, "OPTION", 0);
  member.what = option->what;
  member.removes = option->removes;
  if (option->what == What::All) {
    set.members.push_back(member);
    return;
  }
  if (option->what == What::Segment) {
    add_segment(card, map, member, set, report);
    return;
  }
  for (std::size_t i = 1; i <= option->ids; ++i) {
    if (!card.good(i) || card.integer(i) == 0) continue;
    member.first = member.last = card.integer(i);
    member.field = general_card[i].name;
    set.members.push_back(member);
  }
}

void read_general(Cards& cards, std::vector<RawSet>& sets, std::span<const Option> options) {
  bool good = false;
  RawSet set = begin_set(cards, good);
  while (cards.more())
    add_general(cards.next_filled(general_card), options, cards.placement().map, set, cards.report());
  if (good) end_set(std::move(set), sets);
}

/// The box in the place to which its file goes; it has its sides along the global axes there, too.
void place_box(const Card& card, const Affine& map, RawBox& box, Report& report) {
  if (!map.keeps_axes()) {
    report.error(card.where(), "placed",
                 "*INCLUDE_TRANSFORM turns the file, and boxes have their sides along the global axes; give "
                 "the box outside of the file");
    return;
  }
  const Vector one = map.of_point(box.lowest);
  const Vector other = map.of_point(box.highest);
  for (std::size_t i = 0; i < 3; ++i) {
    box.lowest[i] = std::min(one[i], other[i]);
    box.highest[i] = std::max(one[i], other[i]);
  }
}

std::vector<RawSet>& sets_of(RawDeck& deck, SetItem item) {
  switch (item) {
    case SetItem::Node:
      return deck.node_sets;
    case SetItem::Part:
      return deck.part_sets;
    case SetItem::Shell:
      return deck.shell_sets;
    case SetItem::Solid:
      return deck.solid_sets;
    case SetItem::Beam:
      return deck.beam_sets;
    case SetItem::Discrete:
      break;
  }
  return deck.discrete_sets;
}

std::span<const Option> options_of(SetItem item) {
  if (item == SetItem::Node) return node_options;
  if (item == SetItem::Part) return part_options;
  return element_options;
}

}  // namespace

void read_define_box(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(box_card);
    RawBox box;
    box.id = card.integer("BOXID");
    box.where = card.where();
    constexpr std::array<std::string_view, 3> lowest = {"XMN", "YMN", "ZMN"};
    constexpr std::array<std::string_view, 3> highest = {"XMX", "YMX", "ZMX"};
    for (std::size_t i = 0; i < 3; ++i) {
      box.lowest[i] = card.real(lowest[i]);
      box.highest[i] = card.real(highest[i]);
      if (box.highest[i] < box.lowest[i] && card.good(lowest[i]) && card.good(highest[i]))
        cards.report().field_error(card.where(),
                                   {highest[i], std::string(card.text(highest[i])),
                                    fmt::format("a number not below {} ({})", lowest[i], box.lowest[i]),
                                    "exchange the two", "order"});
    }
    place_box(card, cards.placement().map, box, cards.report());
    if (card.good("BOXID")) deck.boxes.push_back(box);
  }
}

void read_set_segment(Cards& cards, RawDeck& deck) {
  bool good = false;
  RawSet set = begin_set(cards, good);
  while (cards.more()) {
    const Card card = cards.next_filled(segment_card);
    if (!card.good("N1") || !card.good("N2") || !card.good("N3") || !card.good("N4")) continue;
    RawMember member = member_of(card, "N1", 0);
    member.what = What::Segment;
    member.node = nodes_of(card, 0, cards.placement().map);
    set.members.push_back(member);
  }
  if (good) end_set(std::move(set), deck.segment_sets);
}

void read_set_segment_general(Cards& cards, RawDeck& deck) {
  read_general(cards, deck.segment_sets, segment_options);
}

void read_set_segment_add(Cards& cards, RawDeck& deck) {
  read_add(cards, deck.segment_sets);
}

void read_set_of(Cards& cards, RawDeck& deck, SetItem item, SetForm form) {
  std::vector<RawSet>& sets = sets_of(deck, item);
  switch (form) {
    case SetForm::List:
    case SetForm::Column:
    case SetForm::Generate:
    case SetForm::GenerateIncrement:
      return read_list(cards, sets, form);
    case SetForm::General:
      return read_general(cards, sets, options_of(item));
    case SetForm::Add:
      return read_add(cards, sets);
  }
}

}  // namespace crumple::deck
