// SPDX-License-Identifier: BSD-3-Clause
// *CONTACT in decks.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::contacts_test {
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
  const model::Contact& contact = model.contacts[0];
  EXPECT_EQ(contact.id, 5);
  EXPECT_EQ(contact.title, "folding, all parts");
  EXPECT_EQ(contact.side[0].parts, (std::vector<Index>{0}));
  EXPECT_DOUBLE_EQ(contact.static_friction, 0.15);
  EXPECT_DOUBLE_EQ(contact.dynamic_friction, 0.1);
  EXPECT_EQ(contact.friction_decay, 4.0);
  EXPECT_DOUBLE_EQ(contact.viscous_damping, 0.2);
  EXPECT_EQ(contact.birth_time, 0.5);
  EXPECT_EQ(contact.death_time, 1.5);
  EXPECT_EQ(contact.side[0].stiffness_scale, 6.0);
  EXPECT_EQ(contact.side[0].contact_thickness, 0.7);
  EXPECT_EQ(contact.side[0].thickness_scale, 0.9);
}

/// The second contact of a number acts, too, with a warning and a number of its own.
TEST(Contact, OfTheSameNumberIsRenumbered) {
  SmallDeck deck;
  const std::string card = "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n         2first\n0\n\n\n";
  deck.more = card + card + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n\n\n";
  expect_one(deck, "warning: *CONTACT_AUTOMATIC_SINGLE_SURFACE_ID card 1 field ID: read \"2\"");
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model.has_value());
  ASSERT_EQ(result.model->contacts.size(), 3U);
  EXPECT_EQ(result.model->contacts[0].id, 2);
  // By places among three: 2 would be that of the second one, and goes on by three.
  EXPECT_EQ(result.model->contacts[1].id, 5);
  EXPECT_EQ(result.model->contacts[2].id, 3);
}

TEST(Contact, OfTheNumberOfATieToo) {
  SmallDeck deck;
  deck.more =
      "*SET_NODE_LIST\n3\n1,4\n*SET_SEGMENT\n4\n2,5,6,3\n"
      "*CONTACT_TIED_NODES_TO_SURFACE_OFFSET_ID\n         7tie\n3,4,4,0\n\n\n"
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n         7self\n0\n\n\n";
  const std::string messages = listed(read_deck_text(deck.text()).diagnostics);
  EXPECT_NE(messages.find("warning: *CONTACT_TIED_NODES_TO_SURFACE_OFFSET_ID card 1 field ID: read \"7\""),
            std::string::npos)
      << messages;
  EXPECT_NE(messages.find("this one acts, too, and is 2 in outputs"), std::string::npos) << messages;
}

TEST(Contact, WhichPartsTakePart) {
  SmallDeck deck;
  deck.part = "*PART\nfirst\n1,1,1\nsecond\n2,1,1\n";
  deck.shells = "*ELEMENT_SHELL\n11,1,1,2,3,4\n12,2,2,5,6,3\n";
  const auto parts = [&](const std::string& card) {
    deck.more = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + card + "\n\n\n*SET_PART_LIST\n9\n2\n";
    return read_clean(deck.text()).contacts.at(0).side[0].parts;
  };
  using Parts = std::vector<Index>;
  EXPECT_EQ(parts(""), (Parts{0, 1}));
  EXPECT_EQ(parts("0,0,5"), (Parts{0, 1}));
  EXPECT_EQ(parts("9,0,2"), (Parts{1}));
  EXPECT_EQ(parts("1,0,3"), (Parts{0}));
  EXPECT_EQ(parts("9,0,6"), (Parts{0}));
}

TEST(Contact, MortarIsTheSameContactWithAWarningAndWithoutPenmax) {
  for (const std::string name : {"SINGLE_SURFACE", "SURFACE_TO_SURFACE"}) {
    SmallDeck deck;
    deck.more = "*CONTACT_AUTOMATIC_" + name + "_MORTAR_ID\n3,both\n1,1,3,3\n0.3\n\n0\n0.5\n";
    const ReadResult result = read_deck_text(deck.text());
    ASSERT_TRUE(result.model) << listed(result.diagnostics);
    EXPECT_NE(listed(result.diagnostics).find("warning: *CONTACT_AUTOMATIC_" + name + "_MORTAR_ID"),
              std::string::npos)
        << listed(result.diagnostics);
    EXPECT_EQ(result.model->contacts.at(0).static_friction, 0.3);
    EXPECT_EQ(result.model->contacts.at(0).release_depth, 0);
  }
}

TEST(Contact, OfTwoSurfacesWithoutAnyIsOfAllParts) {
  SmallDeck deck;
  deck.more = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n0,0,0,0\n0.3\n\n";
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  EXPECT_NE(listed(result.diagnostics).find("neither surface is named"), std::string::npos);
  EXPECT_EQ(result.model->contacts.at(0).kind, model::ContactKind::SingleSurface);
  // One that is named keeps its meaning, and the other is missing.
  deck.more = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,0,3,0\n0.3\n\n";
  expect_one(deck, "field MSID");
  deck.more = "*CONTACT_SURFACE_TO_SURFACE\n0,0,0,0\n0.3\n\n";
  EXPECT_NE(listed(read_deck_text(deck.text()).diagnostics).find("field SSID"), std::string::npos);
}

TEST(Contact, SoftnessAndLimitOfFriction) {
  SmallDeck deck;
  deck.more = "*CONTACT_SINGLE_SURFACE_ID\n3,both\n0\n0.3,0.2,,0.5\n,,,,,,,2\n1,0.3\n";
  const model::Contact contact = read_clean(deck.text()).contacts.at(0);
  EXPECT_EQ(contact.friction_stress, 1);
  EXPECT_EQ(contact.soft_scale, 0.3);
  deck.more = "*CONTACT_SINGLE_SURFACE\n0\n\n\n1\n";
  EXPECT_EQ(read_clean(deck.text()).contacts.at(0).soft_scale, 0.1);
  deck.more = "*CONTACT_SINGLE_SURFACE\n0\n\n\n0,0.3\n";
  EXPECT_EQ(read_clean(deck.text()).contacts.at(0).soft_scale, 0);
}

// SOFT = 2 has edges where DEPTH ends in 5 and both sides of shells count.
TEST(Contact, StiffnessByMassAlone) {
  SmallDeck deck;
  const auto contact = [&](const std::string& keyword, const std::string& card_1, const std::string& card_a) {
    deck.more = "*CONTACT_" + keyword + "\n" + card_1 + "\n\n\n" + card_a + "\n";
    return read_clean(deck.text()).contacts.at(0);
  };
  EXPECT_TRUE(contact("AUTOMATIC_SINGLE_SURFACE", "0", "2").mass_stiffness);
  EXPECT_EQ(contact("AUTOMATIC_SINGLE_SURFACE", "0", "2").soft_scale, 0);
  EXPECT_EQ(contact("AUTOMATIC_SINGLE_SURFACE", "0", "2,,,,,2").edges, model::ContactEdges::None);
  EXPECT_EQ(contact("AUTOMATIC_SINGLE_SURFACE", "0", "2,,,,,35").edges, model::ContactEdges::All);
  EXPECT_EQ(contact("AUTOMATIC_SINGLE_SURFACE", "0", "1,,,,,5").edges, model::ContactEdges::None);
  const model::Contact two = contact("AUTOMATIC_SURFACE_TO_SURFACE", "1,1,3,3", "2,,,,,5");
  EXPECT_TRUE(two.mass_stiffness);
  EXPECT_EQ(two.edges, model::ContactEdges::All);
  EXPECT_EQ(contact("AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", "1,1,3,3", "2,,,,,5").edges,
            model::ContactEdges::All);
  EXPECT_EQ(contact("SURFACE_TO_SURFACE", "1,1,3,3", "2,,,,,2").edges, model::ContactEdges::None);
}

TEST(Contact, EdgesThatTakeNoPartAreWarnedOf) {
  SmallDeck deck;
  for (const std::string keyword : {"SURFACE_TO_SURFACE", "AUTOMATIC_NODES_TO_SURFACE"})
    for (const std::string card_a : {"2,,,,,35", "0,,,,,5"}) {
      deck.more = "*CONTACT_" + keyword + "\n1,1,3,3\n\n\n" + card_a + "\n";
      const ReadResult result = read_deck_text(deck.text());
      ASSERT_TRUE(result.model) << listed(result.diagnostics);
      EXPECT_EQ(result.model->contacts.at(0).edges, model::ContactEdges::None);
      const bool warned = listed(result.diagnostics).find("DEPTH 35 acts like 2") != std::string::npos;
      EXPECT_EQ(warned, card_a.front() == '2') << keyword << listed(result.diagnostics);
    }
}

TEST(Contact, ReleaseAndSolids) {
  SmallDeck deck;
  deck.more = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n\n\n0\n0.4,,,,,,0.02,50\n";
  const model::Contact contact = read_clean(deck.text()).contacts.at(0);
  EXPECT_EQ(contact.release_depth, 0.4);
  EXPECT_EQ(contact.solid_thickness, 0.02);
  EXPECT_EQ(contact.solid_modulus, 50);
}

/// Two parts of one shell each, sets of all kinds, and a contact.
model::Model read_contact(const std::string& contact) {
  SmallDeck deck;
  deck.part = "*PART\nfirst\n1,1,1\nsecond\n2,1,1\n";
  deck.shells = "*ELEMENT_SHELL\n11,1,1,2,3,4\n12,2,2,5,6,3\n";
  deck.more = contact +
              "*SET_PART_LIST\n9\n2\n*SET_SHELL_LIST\n8\n12\n*SET_NODE_LIST\n7\n5,6\n"
              "*SET_SEGMENT\n6\n3,4,1,2\n*DEFINE_BOX\n5,-0.5,1.5,-1,2,-1,1\n";
  return read_clean(deck.text());
}

TEST(Contact, TwoSides) {
  const model::Model model =
      read_contact("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n4,two\n1,9,3,2\n0.2\n2,3,0.05,0.06,0.8,0.9\n");
  const model::Contact& contact = model.contacts.at(0);
  EXPECT_EQ(contact.id, 4);
  EXPECT_EQ(contact.kind, model::ContactKind::SurfaceToSurface);
  EXPECT_FALSE(contact.oriented);
  EXPECT_TRUE(contact.shell_thickness && contact.rigid_shell_thickness);
  EXPECT_EQ(contact.side[0].parts, (std::vector<Index>{0}));
  EXPECT_EQ(contact.side[1].parts, (std::vector<Index>{1}));
  EXPECT_EQ(contact.side[0].stiffness_scale, 2);
  EXPECT_EQ(contact.side[1].stiffness_scale, 3);
  EXPECT_EQ(contact.side[0].contact_thickness, 0.05);
  EXPECT_EQ(contact.side[1].contact_thickness, 0.06);
  EXPECT_EQ(contact.side[0].thickness_scale, 0.8);
  EXPECT_EQ(contact.side[1].thickness_scale, 0.9);
}

TEST(Contact, SidesBySets) {
  const model::Model model = read_contact("*CONTACT_NODES_TO_SURFACE\n7,6,4,0\n\n\n");
  const model::Contact& contact = model.contacts.at(0);
  EXPECT_EQ(contact.kind, model::ContactKind::NodesToSurface);
  EXPECT_TRUE(contact.oriented);
  EXPECT_FALSE(contact.shell_thickness || contact.rigid_shell_thickness);
  EXPECT_EQ(contact.side[0].nodes, (std::vector<Index>{4, 5}));
  using Segments = std::vector<std::array<Index, 4>>;
  EXPECT_EQ(contact.side[1].segments, (Segments{{2, 3, 0, 1}})) << "in the order of the deck";
  EXPECT_EQ(read_contact("*CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE\n1,8,3,1\n\n\n").contacts.at(0).kind,
            model::ContactKind::NodesToSurface);
  EXPECT_EQ(read_contact("*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n1,8,3,1\n\n\n").contacts.at(0).side[1].shells,
            (std::vector<Index>{1}));
  EXPECT_EQ(read_contact("*CONTACT_ERODING_NODES_TO_SURFACE\n1,,3,5\n\n\n\n").contacts.at(0).side[1].parts,
            (std::vector<Index>{0, 1}));
}

TEST(Contact, BoxesKeepWhatIsInside) {
  const model::Contact contact =
      read_contact("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,,,,5\n\n\n").contacts.at(0);
  EXPECT_TRUE(contact.side[0].parts.empty());
  EXPECT_EQ(contact.side[0].shells, (std::vector<Index>{0})) << "the second shell is half outside";
}

TEST(Contact, ThicknessOfOrientedShells) {
  const auto read = [](const std::string& control, const std::string& card_b) {
    return read_contact(control + "*CONTACT_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n\n" + card_b).contacts.at(0);
  };
  EXPECT_FALSE(read("", ",1,0\n").shell_thickness);
  EXPECT_TRUE(read("", ",1,1\n").shell_thickness);
  EXPECT_FALSE(read("", ",1,1\n").rigid_shell_thickness);
  EXPECT_TRUE(read("", ",1,2\n").rigid_shell_thickness);
  EXPECT_FALSE(read("", ",,1\n").shell_thickness) << "THKOPT = 0 asks *CONTROL_CONTACT";
  EXPECT_FALSE(read("*CONTROL_CONTACT\n,,,2\n", ",2,1\n").shell_thickness);
  EXPECT_TRUE(read("*CONTROL_CONTACT\n,,,2\n", "").rigid_shell_thickness);
}

TEST(Contact, ToolsOfFormingHaveNoThickness) {
  const auto read = [](const std::string& form, const std::string& card_b) {
    return read_contact("*CONTROL_CONTACT\n,,,2\n*CONTACT_FORMING_" + form + "\n1,2,3,3\n\n\n\n" + card_b)
        .contacts.at(0);
  };
  for (const char* form : {"ONE_WAY_SURFACE_TO_SURFACE", "NODES_TO_SURFACE"})
    EXPECT_EQ(read(form, "").kind, model::ContactKind::NodesToSurface);
  const model::Contact contact = read("SURFACE_TO_SURFACE", ",0,2\n");
  EXPECT_EQ(contact.kind, model::ContactKind::SurfaceToSurface);
  EXPECT_TRUE(contact.oriented);
  EXPECT_TRUE(contact.shell_thickness);
  EXPECT_FALSE(contact.rigid_shell_thickness) << "SHLTHK of *CONTROL_CONTACT is not about them";
  EXPECT_TRUE(read("SURFACE_TO_SURFACE", ",1,2\n").rigid_shell_thickness);
}

TEST(Contact, CardsOfOptionsAreSkipped) {
  for (const char* second : {"", "&,,1\n"}) {
    const model::Model model = read_contact("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MPP_ID\n4,two\n0,200\n" +
                                            std::string(second) + "1,9,3,2\n0.2\n\n");
    EXPECT_EQ(model.contacts.at(0).id, 4);
    EXPECT_EQ(model.contacts.at(0).static_friction, 0.2);
    EXPECT_EQ(model.contacts.at(0).side[1].parts, (std::vector<Index>{1}));
  }
}

TEST(Contact, UnnamedOnesGetFreeIds) {
  const model::Model model = read_contact(
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n2,given\n0\n\n\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n\n\n");
  EXPECT_EQ(model.contacts.at(0).id, 2);
  EXPECT_EQ(model.contacts.at(1).id, 4);
}

TEST(Contact, TiedOnesSkipTheCardsOfMppAsWell) {
  const model::Model model = read_contact("*CONTACT_TIED_NODES_TO_SURFACE_MPP\n0,200,3\n&,,1\n1,9,3,2\n\n\n");
  ASSERT_EQ(model.tied_contacts.size(), 1U);
  EXPECT_EQ(model.tied_contacts[0].side[0].parts, (std::vector<Index>{0}));
  EXPECT_EQ(model.tied_contacts[0].side[1].parts, (std::vector<Index>{1}));
}

TEST(Contact, ForceTransducers) {
  const model::Model model = read_contact(
      "*CONTACT_FORCE_TRANSDUCER_PENALTY_ID\n12,on one\n1,,3\n\n\n*CONTACT_FORCE_TRANSDUCER\n1,9,3,2\n\n\n");
  EXPECT_TRUE(model.contacts.empty());
  ASSERT_EQ(model.force_transducers.size(), 2U);
  EXPECT_EQ(model.force_transducers[0].id, 12);
  EXPECT_TRUE(model.force_transducers[0].side[1].empty());
  EXPECT_EQ(model.force_transducers[1].side[0].parts, (std::vector<Index>{0}));
  EXPECT_EQ(model.force_transducers[1].side[1].parts, (std::vector<Index>{1}));
}

TEST(Contact, GeneralHasEdgesAndBeams) {
  const std::string beams =
      "*ELEMENT_BEAM\n      11       2       1       6\n*PART\nframe\n         2         2         1\n"
      "*SECTION_BEAM\n         2         3\n      0.01\n";
  const model::Contact free =
      read_with("*CONTACT_AUTOMATIC_GENERAL_ID\n4,all\n0\n0.2\n\n" + beams).contacts.at(0);
  EXPECT_EQ(free.id, 4);
  EXPECT_EQ(free.kind, model::ContactKind::SingleSurface);
  EXPECT_EQ(free.edges, model::ContactEdges::Free);
  EXPECT_EQ(free.static_friction, 0.2);
  EXPECT_EQ(free.side[0].parts, (std::vector<Index>{0, 1}));
  EXPECT_EQ(read_with("*CONTACT_AUTOMATIC_GENERAL\n2,,3\n\n\n" + beams).contacts.at(0).side[0].parts,
            (std::vector<Index>{1}));
  EXPECT_EQ(read_with("*CONTACT_AUTOMATIC_GENERAL_INTERIOR_MPP_ID\n4,all\n0\n0\n\n\n").contacts.at(0).edges,
            model::ContactEdges::All);
  const auto with_depth = [](const std::string& kind, int depth) {
    return read_with("*CONTACT_" + kind + "\n0\n\n\n0,,,,," + std::to_string(depth) + "\n")
        .contacts.at(0)
        .edges;
  };
  EXPECT_EQ(with_depth("AUTOMATIC_GENERAL", 3), model::ContactEdges::Free);
  EXPECT_EQ(with_depth("AUTOMATIC_GENERAL", 5), model::ContactEdges::All);
  EXPECT_EQ(with_depth("AUTOMATIC_GENERAL", 25), model::ContactEdges::All);
  EXPECT_EQ(with_depth("AUTOMATIC_SINGLE_SURFACE", 5), model::ContactEdges::None);
}

TEST(Contact, NodesOfBeamsTouchSegmentsInOtherKinds) {
  const std::string beams =
      "*ELEMENT_BEAM\n      11       2       1       6\n*PART\nframe\n         2         2         1\n"
      "*SECTION_BEAM\n         2         3\n      0.01\n";
  const auto parts = [&](const std::string& contact) {
    return read_with(contact + beams).contacts.at(0).side;
  };
  using Parts = std::vector<Index>;
  EXPECT_EQ(parts("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n\n\n")[0].parts, (Parts{0, 1}));
  for (const std::string kind : {"NODES_TO_SURFACE", "SURFACE_TO_SURFACE", "BEAMS_TO_SURFACE"}) {
    const auto side = parts("*CONTACT_AUTOMATIC_" + kind + "\n2,1,3,3\n\n\n");
    EXPECT_EQ(side[0].parts, (Parts{1})) << kind;
    EXPECT_EQ(side[1].parts, (Parts{0})) << kind;
  }
  const auto read = [&](const std::string& contact) {
    return read_deck_text(SmallDeck{.more = contact + beams}.text(), {}, {});
  };
  const ReadResult soft = read("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n\n\n2\n");
  ASSERT_TRUE(soft.model.has_value());
  EXPECT_EQ(soft.model->contacts.at(0).side[0].parts, (Parts{0}));
  EXPECT_NE(listed(soft.diagnostics).find("part 2 consists of beams, which take no part in it"),
            std::string::npos);
  const ReadResult constrained = read("*CONTACT_CONSTRAINT_NODES_TO_SURFACE\n2,1,3,3\n\n\n\n");
  EXPECT_FALSE(constrained.model.has_value());
  EXPECT_NE(listed(constrained.diagnostics).find("part 2 consists of beams"), std::string::npos);
}

TEST(Contact, AutomaticWhereTheDeckHasNone) {
  ReadOptions options;
  options.automatic_contact = true;
  SmallDeck deck;
  EXPECT_EQ(read_clean(deck.text(), options).contacts.at(0).side[0].parts, (std::vector<Index>{0}));
  deck.more = "*CONTACT_AUTOMATIC_SINGLE_SURFACE_TITLE\n7,mine\n1,0,3\n0.2\n\n";
  const model::Model model = read_clean(deck.text(), options);
  ASSERT_EQ(model.contacts.size(), 1U);
  EXPECT_EQ(model.contacts[0].title, "mine");
  EXPECT_EQ(model.contacts[0].id, 7);
}

}  // namespace
}  // namespace crumple::deck::test::contacts_test
