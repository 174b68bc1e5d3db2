// SPDX-License-Identifier: BSD-3-Clause
// *CONTACT in decks.
#include <gtest/gtest.h>

#include "small_deck.hpp"

namespace crumple::deck::test {
namespace {

TEST(Contact, EveryValue) {
  const model::Model model = read_with(
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n         5folding, all parts\n"
      "         0         0         0         0         0         0         1         1\n"
      "       0.3       0.2       4.0       0.0      20.0         0       0.5       1.5\n"
      "       2.0       3.0       0.7       0.0       0.9       1.0       0.5\n"
      "         0       0.1         0     1.025         2         2         0         1\n"
      "       0.0         0         0         0\n"
      "         0         1\n");
  ASSERT_EQ(model.contacts.size(), 1U);
  const model::SingleSurfaceContact& contact = model.contacts[0];
  EXPECT_EQ(contact.id, 5);
  EXPECT_EQ(contact.title, "folding, all parts");
  EXPECT_EQ(contact.parts, (std::vector<Index>{0}));
  EXPECT_DOUBLE_EQ(contact.static_friction, 0.15);
  EXPECT_DOUBLE_EQ(contact.dynamic_friction, 0.1);
  EXPECT_EQ(contact.friction_decay, 4.0);
  EXPECT_DOUBLE_EQ(contact.viscous_damping, 0.2);
  EXPECT_EQ(contact.birth_time, 0.5);
  EXPECT_EQ(contact.death_time, 1.5);
  EXPECT_EQ(contact.stiffness_scale, 6.0);
  EXPECT_EQ(contact.contact_thickness, 0.7);
  EXPECT_EQ(contact.thickness_scale, 0.9);
}

TEST(Contact, WhichPartsTakePart) {
  SmallDeck deck;
  deck.part = "*PART\nfirst\n1,1,1\nsecond\n2,1,1\n";
  deck.shells = "*ELEMENT_SHELL\n11,1,1,2,3,4\n12,2,2,5,6,3\n";
  const auto parts = [&](const std::string& card) {
    deck.more = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + card + "\n\n\n*SET_PART_LIST\n9\n2\n";
    return read_clean(deck.text()).contacts.at(0).parts;
  };
  using Parts = std::vector<Index>;
  EXPECT_EQ(parts(""), (Parts{0, 1}));
  EXPECT_EQ(parts("0,0,5"), (Parts{0, 1}));
  EXPECT_EQ(parts("9,0,2"), (Parts{1}));
  EXPECT_EQ(parts("1,0,3"), (Parts{0}));
  EXPECT_EQ(parts("9,0,6"), (Parts{0}));
}

TEST(Contact, SoftnessAndLimitOfFriction) {
  SmallDeck deck;
  deck.more = "*CONTACT_SINGLE_SURFACE_ID\n3,both\n0\n0.3,0.2,,0.5\n,,,,,,,2\n1,0.3\n";
  const model::SingleSurfaceContact contact = read_clean(deck.text()).contacts.at(0);
  EXPECT_EQ(contact.friction_stress, 1);
  EXPECT_EQ(contact.soft_scale, 0.3);
  deck.more = "*CONTACT_SINGLE_SURFACE\n0\n\n\n1\n";
  EXPECT_EQ(read_clean(deck.text()).contacts.at(0).soft_scale, 0.1);
  deck.more = "*CONTACT_SINGLE_SURFACE\n0\n\n\n0,0.3\n";
  EXPECT_EQ(read_clean(deck.text()).contacts.at(0).soft_scale, 0);
}

TEST(Contact, AutomaticWhereTheDeckHasNone) {
  ReadOptions options;
  options.automatic_contact = true;
  SmallDeck deck;
  EXPECT_EQ(read_clean(deck.text(), options).contacts.at(0).parts, (std::vector<Index>{0}));
  deck.more = "*CONTACT_AUTOMATIC_SINGLE_SURFACE_TITLE\n7,mine\n1,0,3\n0.2\n\n";
  const model::Model model = read_clean(deck.text(), options);
  ASSERT_EQ(model.contacts.size(), 1U);
  EXPECT_EQ(model.contacts[0].title, "mine");
  EXPECT_EQ(model.contacts[0].id, 7);
}

}  // namespace
}  // namespace crumple::deck::test
