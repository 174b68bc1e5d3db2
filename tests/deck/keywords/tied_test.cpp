// SPDX-License-Identifier: BSD-3-Clause
// *CONTACT_TIED and *CONTACT_..._TIEBREAK in decks.
#include <gtest/gtest.h>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::tied_test {
namespace {

/// Two plates in two parts.
SmallDeck plates(const std::string& more) {
  SmallDeck deck;
  deck.part = "*PART\nfirst\n1,1,1\nsecond\n2,1,1\n";
  deck.shells = "*ELEMENT_SHELL\n11,1,1,2,3,4\n12,2,2,5,6,3\n";
  deck.more = more;
  return deck;
}

model::TiedContact tied(const std::string& more) {
  const model::Model model = read_clean(plates(more).text());
  EXPECT_EQ(model.tied_contacts.size(), 1U);
  return model.tied_contacts.at(0);
}

std::vector<std::string> messages(const std::string& more) {
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : read_deck_text(plates(more).text()).diagnostics)
    if (diagnostic.severity != Severity::Note) found.push_back(to_string(diagnostic));
  return found;
}

TEST(Tied, EveryValue) {
  const model::TiedContact contact = tied(
      "*CONTACT_TIED_SURFACE_TO_SURFACE_ID\n         5glue\n"
      "         2         1         3         3         0         0         1         1\n"
      "       0.3       0.2       4.0       0.0      20.0         0       0.0       1.5\n"
      "       2.0       3.0       0.7       0.8       0.9       1.1\n");
  EXPECT_EQ(contact.id, 5);
  EXPECT_EQ(contact.title, "glue");
  EXPECT_EQ(contact.method, model::TieMethod::Constraint);
  EXPECT_FALSE(contact.ties_rotations);
  EXPECT_FALSE(contact.failure.has_value());
  EXPECT_EQ(contact.side[0].parts, (std::vector<Index>{1}));
  EXPECT_EQ(contact.side[1].parts, (std::vector<Index>{0}));
  EXPECT_EQ(contact.side[0].stiffness_scale, 2);
  EXPECT_EQ(contact.side[1].stiffness_scale, 3);
  EXPECT_EQ(contact.side[0].contact_thickness, 0.7);
  EXPECT_EQ(contact.side[1].thickness_scale, 1.1);
  EXPECT_EQ(contact.tolerance, 0);
  EXPECT_EQ(contact.death_time, 1.5);
}

TEST(Tied, KindsOfSides) {
  EXPECT_EQ(tied("*CONTACT_TIED_NODES_TO_SURFACE\n9,1,4,3\n\n\n*SET_NODE_LIST\n9\n6,5\n").side[0].nodes,
            (std::vector<Index>{4, 5}));
  const model::TiedContact segments =
      tied("*CONTACT_TIED_SURFACE_TO_SURFACE\n2,9,3,0\n\n\n*SET_SEGMENT\n9\n1,2,3,4\n");
  ASSERT_EQ(segments.side[1].segments.size(), 1U);
  EXPECT_EQ(segments.side[1].segments[0], (std::array<Index, 4>{0, 1, 2, 3}));
  EXPECT_EQ(tied("*CONTACT_TIED_SURFACE_TO_SURFACE\n9,1,1,3\n\n\n*SET_SHELL_LIST\n9\n12\n").side[0].shells,
            (std::vector<Index>{1}));
  EXPECT_EQ(tied("*CONTACT_TIED_SURFACE_TO_SURFACE\n9,0,2,5\n\n\n*SET_PART_LIST\n9\n2\n").side[1].parts,
            (std::vector<Index>{0, 1}));
  EXPECT_EQ(tied("*CONTACT_TIED_SURFACE_TO_SURFACE\n9,1,6,3\n\n\n*SET_PART_LIST\n9\n1\n").side[0].parts,
            (std::vector<Index>{1}));
}

TEST(Tied, BeamsAreTiedByTheirNodes) {
  EXPECT_EQ(tied("*PART\nrod\n3,3,1\n*SECTION_BEAM\n3,3\n0.5\n*ELEMENT_BEAM\n31,3,5,6\n"
                 "*CONTACT_TIED_NODES_TO_SURFACE\n3,1,3,3\n\n\n")
                .side[0]
                .nodes,
            (std::vector<Index>{4, 5}));
}

TEST(Tied, Forms) {
  const auto form = [](const std::string& name) {
    return tied("*CONTACT_TIED_" + name + "\n2,1,3,3\n\n,,-0.3,-0.5\n");
  };
  EXPECT_EQ(form("NODES_TO_SURFACE").tolerance, 0.4);
  EXPECT_EQ(form("NODES_TO_SURFACE").side[0].contact_thickness, 0);
  EXPECT_EQ(form("NODES_TO_SURFACE_OFFSET").method, model::TieMethod::Offset);
  EXPECT_EQ(form("SURFACE_TO_SURFACE_OFFSET").method, model::TieMethod::Offset);
  EXPECT_TRUE(form("SHELL_EDGE_TO_SURFACE").ties_rotations);
  EXPECT_EQ(form("SHELL_EDGE_TO_SURFACE").method, model::TieMethod::Constraint);
  EXPECT_FALSE(form("SHELL_EDGE_TO_SURFACE_OFFSET").ties_rotations);
  EXPECT_TRUE(form("SHELL_EDGE_TO_SURFACE_BEAM_OFFSET").ties_rotations);
  EXPECT_EQ(form("SHELL_EDGE_TO_SURFACE_BEAM_OFFSET").method, model::TieMethod::Offset);
  EXPECT_FALSE(form("SHELL_EDGE_TO_SURFACE_BEAM_OFFSET").turns_on_faces);
  EXPECT_TRUE(form("SHELL_EDGE_TO_SOLID").turns_on_faces);
  EXPECT_TRUE(form("SHELL_EDGE_TO_SOLID").ties_rotations);
  EXPECT_EQ(tied("*CONTACT_TIED_SURFACE_TO_SURFACE_OFFSET\n2,1,3,3\n\n0.5\n").method,
            model::TieMethod::Penalty)
      << "SFS asks for softer springs";
}

TEST(Tied, Tiebreak) {
  const std::string cards = "\n2,1,3,3\n0.3,0.2\n\n";
  const model::Model stress = read_clean(
      plates("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_ID\n4,glue" + cards + "2,0.5,0.7\n").text());
  const model::TieFailure& failure = stress.tied_contacts.at(0).failure.value();
  EXPECT_EQ(failure.normal_strength, 0.5);
  EXPECT_EQ(failure.shear_strength, 0.7);
  EXPECT_EQ(failure.normal_exponent, 2);
  EXPECT_TRUE(failure.by_stress);
  EXPECT_EQ(stress.tied_contacts[0].method, model::TieMethod::Penalty);
  // Where it has broken, the two touch as any others.
  ASSERT_EQ(stress.contacts.size(), 1U);
  EXPECT_EQ(stress.contacts[0].id, 4);
  EXPECT_EQ(stress.contacts[0].kind, model::ContactKind::SurfaceToSurface);
  EXPECT_EQ(stress.contacts[0].static_friction, 0.3);
  EXPECT_EQ(stress.contacts[0].side[1].parts, (std::vector<Index>{0}));
  const model::Model force =
      read_clean(plates("*CONTACT_TIEBREAK_NODES_TO_SURFACE" + cards + "5,7,3,1\n").text());
  EXPECT_EQ(force.tied_contacts.at(0).failure->normal_exponent, 3);
  EXPECT_EQ(force.tied_contacts.at(0).failure->shear_exponent, 1);
  EXPECT_FALSE(force.tied_contacts.at(0).failure->by_stress);
  EXPECT_EQ(force.contacts.at(0).kind, model::ContactKind::NodesToSurface);
  EXPECT_EQ(tied("*CONTACT_TIEBREAK_SURFACE_TO_SURFACE" + cards + "5,7\n").failure->shear_strength, 7);
}

TEST(Tied, TiebreakByOption) {
  const auto read_option = [](const std::string& card) {
    const ReadResult result = read_deck_text(
        plates("*CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n\n" + card + "\n").text());
    EXPECT_TRUE(result.model) << listed(result.diagnostics);
    // Between shells there is a warning of what springs do not see.
    EXPECT_EQ(listed(result.diagnostics).find("which mixes the modes") != std::string::npos, card[0] != '2');
    return result.model.value().tied_contacts.at(0);
  };
  const model::TieSoftening power = read_option("9,35,45,1.45,0.25,0.75,0.5").softening.value();
  EXPECT_EQ(power.law, model::TieSoftening::Law::PowerLaw);
  EXPECT_EQ(power.normal_energy, 0.25);
  EXPECT_EQ(power.shear_energy, 0.75);
  EXPECT_EQ(power.exponent, 1.45);
  EXPECT_EQ(power.shear_ratio, 0.5);
  const ReadResult stiff = read_deck_text(
      plates("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n\n9,35,45,1.45,0.25,0.75,0.5,1e3\n")
          .text());
  ASSERT_TRUE(stiff.model);
  EXPECT_EQ(stiff.model->tied_contacts.at(0).softening->stiffness, 1e3);
  EXPECT_NE(listed(stiff.diagnostics).find("beyond half of the stability budget of contact is cut"),
            std::string::npos);
  const model::TiedContact kenane = read_option("11,35,45,-2,0.25,0.75");
  EXPECT_EQ(kenane.softening->law, model::TieSoftening::Law::BenzeggaghKenane);
  EXPECT_EQ(kenane.softening->exponent, 2);
  EXPECT_EQ(kenane.softening->shear_ratio, 1);
  EXPECT_EQ(kenane.softening->stiffness, 0);
  EXPECT_EQ(kenane.failure->normal_strength, 35);
  EXPECT_EQ(read_option("9,35,45,,0.25,0.75").softening->exponent, 1);
  for (const std::string option : {"6", "8"}) {
    const model::TiedContact opening = read_option(option + ",35,45,0.2");
    EXPECT_EQ(opening.softening->law, model::TieSoftening::Law::CriticalOpening);
    EXPECT_EQ(opening.softening->critical_opening, 0.2);
    EXPECT_EQ(opening.failure->normal_strength, 35);
  }
  EXPECT_FALSE(read_option("2,35,45").softening.has_value());
}

TEST(Tied, OptionOneNeverBreaksAndWarns) {
  const SmallDeck deck = plates("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n\n1\n");
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model);
  EXPECT_FALSE(result.model->tied_contacts.at(0).failure.has_value());
  EXPECT_EQ(result.model->contacts.size(), 1U);
  EXPECT_NE(listed(result.diagnostics).find("nodes that come into contact later touch, and do not stick"),
            std::string::npos);
}

TEST(Tied, Faults) {
  const auto only = [](const std::string& more) {
    const std::vector<std::string> found = messages(more);
    return found.size() == 1 ? found[0] : std::to_string(found.size()) + " messages";
  };
  const auto has = [&](const std::string& more, const std::string& text) {
    const std::string message = only(more);
    EXPECT_NE(message.find(text), std::string::npos) << message;
  };
  has("*CONTACT_TIED_SURFACE_TO_SURFACE\n8,1,2,3\n\n\n", "SSID");
  has("*CONTACT_TIED_SURFACE_TO_SURFACE\n2,7,3,3\n\n\n", "MSID");
  has("*CONTACT_TIED_SURFACE_TO_SURFACE\n2,1,3,4\n\n\n", "MSTYP");
  has("*CONTACT_TIED_SURFACE_TO_SURFACE\n2,1,3,3,5\n\n\n", "SBOXID");
  has("*CONTACT_TIED_SURFACE_TO_SURFACE\n2,9,3,0\n\n\n*SET_SEGMENT\n9\n1,2,3,6\n", "neither a shell nor");
  has("*CONTACT_TIED_SURFACE_TO_SURFACE\n2,1,3,3\n,,,,,,0.1\n\n", "BT");
  has("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n\n5,1,1\n", "OPTION");
  has("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n\n2,0,0\n", "a strength above zero");
  const std::string tiebreak = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n\n";
  has(tiebreak + "3,1,1\n", "there is no failure after sticking (3)");
  has(tiebreak + "2,1,1,1\n", "field PARAM");
  has(tiebreak + "2,1,1,,,,,5\n", "warning");
  const auto among = [&](const std::string& card, const std::string& text) {
    const std::string found = listed(read_deck_text(plates(tiebreak + card).text()).diagnostics);
    EXPECT_NE(found.find(text), std::string::npos) << found;
  };
  among("6,1,1\n", "error: *CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK card 4 field PARAM");
  among("6,1,0,0.2\n", "field SFLS: read \"0\", expected a number above zero");
  among("8,0,1,0.2\n", "field NFLS: read \"0\", expected a number above zero");
  among("9,1,1,,1,0\n", "field ERATES: read \"0\", expected a number above zero");
  among("9,1,1,,0,1\n", "field ERATEN: read \"0\", expected a number above zero");
  among("9,1,0,,1,1\n", "field SFLS: read \"0\", expected a number above zero");
  has("*CONTACT_TIEBREAK_SURFACE_TO_SURFACE\n9,1,4,3\n\n\n1,1\n*SET_NODE_LIST\n9\n5,6\n",
      "nodes alone have no area");
}

}  // namespace
}  // namespace crumple::deck::test::tied_test
