// SPDX-License-Identifier: BSD-3-Clause
// FS = -1 and -2 of *CONTACT: friction of *PART_CONTACT and *DEFINE_FRICTION.
#include <gtest/gtest.h>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::part_friction_test {
namespace {

/// Two shells in two parts, of which the first may have friction of its own, and a third without elements.
SmallDeck two_parts(const std::string& of_first, const std::string& more) {
  SmallDeck deck;
  deck.part = "*PART_CONTACT\nfirst\n1,1,1\n" + of_first + "\n*PART\nsecond\n2,1,1\n";
  deck.shells = "*ELEMENT_SHELL\n11,1,1,2,3,4\n12,2,2,5,6,3\n";
  deck.more = more;
  return deck;
}

std::string contact(const std::string& card) {
  return "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n" + card + "\n,,,,,,0.5,2\n";
}

void expect_friction(const model::Friction& friction, double at_rest, double when_sliding, double decay,
                     double stress) {
  EXPECT_DOUBLE_EQ(friction.at_rest, at_rest);
  EXPECT_DOUBLE_EQ(friction.when_sliding, when_sliding);
  EXPECT_DOUBLE_EQ(friction.decay, decay);
  EXPECT_DOUBLE_EQ(friction.stress, stress);
}

TEST(PartFriction, OfParts) {
  SmallDeck deck;
  deck.part = "*PART_CONTACT\nonly\n1,1,1\n0.4,0.2,3,0.6\n";
  deck.more = contact("-1");
  const model::Contact alike = read_clean(deck.text()).contacts.at(0);
  EXPECT_EQ(alike.part_friction.groups, 1);
  // FSF and VSF scale them.
  expect_friction(alike.friction_between(0, 0), 0.2, 0.1, 3, 1.2);
}

TEST(PartFriction, BetweenPartsOfDifferentFrictionIsTheMeanWithAWarning) {
  const SmallDeck deck = two_parts("0.4,0.2,3,0.6", contact("-1"));
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model);
  const model::Contact& both = result.model->contacts.at(0);
  expect_friction(both.friction_between(0, 0), 0.2, 0.1, 3, 1.2);
  expect_friction(both.friction_between(1, 1), 0, 0, 0, 0);
  expect_friction(both.friction_between(1, 0), 0.1, 0.05, 1.5, 1.2);
  expect_friction(both.friction_between(0, 1), 0.1, 0.05, 1.5, 1.2);
  expect_one(deck, "field FS: read \"-1\", expected parts of the same FS, FD, DC and VC");
}

TEST(PartFriction, OfATable) {
  const std::string table =
      "*DEFINE_FRICTION_TITLE\nwhich pairs\n7,0.1,0.05,1,0.2\n"
      "         1         2       0.6       0.3       2.0       0.4\n"
      "         1         9       0.8       0.7       0.0       0.0                PSET\n"
      "*SET_PART_LIST\n9\n1\n";
  for (const std::string card : {"-2", "-2,7"}) {
    const model::Contact found = read_clean(two_parts(",", contact(card) + table).text()).contacts.at(0);
    expect_friction(found.friction_between(0, 1), 0.3, 0.15, 2, 0.8);
    expect_friction(found.friction_between(1, 0), 0.3, 0.15, 2, 0.8);
    expect_friction(found.friction_between(0, 0), 0.4, 0.35, 0, 0);
    expect_friction(found.friction_between(1, 1), 0.05, 0.025, 1, 0.4);
    expect_friction(found.friction_between(1, no_index), 0.05, 0.025, 1, 0.4);
  }
}

TEST(PartFriction, MissingPartsOfATable) {
  const auto table = [](const std::string& icnep) {
    return contact("-2") + "*DEFINE_FRICTION\n7,0.1,,,," + icnep + "\n1,8,0.3\n";
  };
  EXPECT_EQ(read_clean(two_parts(",", table("1")).text()).contacts.at(0).part_friction.groups, 2);
  expect_one(two_parts(",", table("0")), "field PID_J: read \"8\", expected the id of a part");
}

TEST(PartFriction, Faults) {
  expect_one(two_parts(",", contact("-2")), "expected the id of a *DEFINE_FRICTION");
  expect_one(two_parts(",", contact("-2,3") + "*DEFINE_FRICTION\n7\n"),
             "expected the id of a friction table");
  expect_one(two_parts(",", contact("-2") + "*DEFINE_FRICTION\n7\n*DEFINE_FRICTION\n8\n"), "the deck has 2");
  expect_one(two_parts(",", contact("-2") + "*DEFINE_FRICTION\n7\n1,2,0.1,,,,PART\n"), "expected PSET");
  expect_one(two_parts(",", contact("2,5")), "expected a coefficient from 0 to below 2, -1 or -2");
  SmallDeck plain;
  plain.more = contact("-1");
  expect_one(plain, "expected a part with *PART_CONTACT in the contact");
  expect_one(two_parts("-0.1", ""), "field FS: read \"-0.1\"");
}

TEST(PartFriction, AnIncludedFileHasItsOffsets) {
  const std::string deck = two_parts(",",
                                     "*INCLUDE_TRANSFORM\nfriction.k\n,,1,,,,100\n\n\n\n"
                                     "*DEFINE_FRICTION\n7,0.5\n")
                               .text();
  const std::string file = contact("-2,7") + "*DEFINE_FRICTION\n7\n1,1,0.6\n";
  const model::Contact found = read_clean(deck, {}, {{"friction.k", file}}).contacts.at(0);
  expect_friction(found.friction_between(1, 1), 0.3, 0, 0, 0);
  expect_friction(found.friction_between(0, 1), 0, 0, 0, 0);
}

}  // namespace
}  // namespace crumple::deck::test::part_friction_test
