// SPDX-License-Identifier: BSD-3-Clause
// *ELEMENT_SOLID, *SECTION_SOLID, and what solids take from other keywords.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::solids_test {
namespace {

using model::SolidHourglassForm;
using Corners = std::array<Index, 8>;

/// A cube on nodes 1 to 8, node 9 above the middle of its top.
struct SolidDeck : CubeDeck {
  SolidDeck() { nodes += "       9             0.5             0.5             2.0\n"; }
};

model::Model with_elements(const std::string& elements) {
  SolidDeck deck;
  deck.shells = "*ELEMENT_SOLID\n" + elements;
  return read_clean(deck.text());
}

std::vector<std::string> solid_messages(const std::string& elements, const std::string& more = "") {
  SolidDeck deck;
  deck.shells = "*ELEMENT_SOLID\n" + elements;
  deck.more = more;
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : read_deck_text(deck.text()).diagnostics)
    if (diagnostic.severity != Severity::Note) messages.push_back(to_string(diagnostic));
  return messages;
}

TEST(Solid, OneCard) {
  SolidDeck deck;
  deck.section = "*SECTION_SOLID_TITLE\nblock\n         1         1\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.solids.size(), 1U);
  EXPECT_EQ(model.solids[0].id, 21);
  EXPECT_EQ(model.solids[0].part, 0);
  EXPECT_EQ(model.solids[0].node, (Corners{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(model.parts[0].section, no_index);
  EXPECT_EQ(model.parts[0].solid_section, 0);
  EXPECT_EQ(model.solid_sections[0].title, "block");
  EXPECT_EQ(model.solid_sections[0].formulation, model::SolidFormulation::OnePointHexahedron);
  EXPECT_TRUE(model.shells.empty());
}

TEST(Solid, TwoCards) {
  SolidDeck deck;
  deck.shells =
      "*ELEMENT_SOLID (ten nodes format)\n"
      "      21       1\n"
      "       1       2       3       4       5       6       7       8       0       0\n"
      "      22       1\n"
      "       5       6       7       8       9       9       9       9\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.solids.size(), 2U);
  EXPECT_EQ(model.solids[0].node, (Corners{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(model.solids[1].id, 22);
  EXPECT_EQ(model.solids[1].node, (Corners{4, 5, 6, 7, 8, 8, 8, 8}));
}

TEST(Solid, WiderFieldsAndCommas) {
  SolidDeck deck;
  deck.keyword = "*KEYWORD I10=Y\n";
  deck.nodes =
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.,0.,1.\n6,1.,0.,1.\n7,1.,1.,1.\n8,0.,1.,1."
      "\n";
  deck.shells =
      "*ELEMENT_SOLID\n"
      "        21         1         1         2         3         4         5         6         7         8\n"
      "22,1,1,2,3,4,5,6,7,8\n"
      "23,1\n1,2,3,4,5,6,7,8\n";
  const ReadResult result = read_deck_text(deck.text(), {});
  ASSERT_TRUE(result.model.has_value()) << listed(result.diagnostics);
  for (const Diagnostic& diagnostic : result.diagnostics)
    if (diagnostic.severity != Severity::Note) {
      EXPECT_NE(to_string(diagnostic).find("has the nodes of solid"), std::string::npos)
          << to_string(diagnostic);
    }
  const model::Model& model = *result.model;
  ASSERT_EQ(model.solids.size(), 3U);
  for (const model::SolidElement& solid : model.solids)
    EXPECT_EQ(solid.node, (Corners{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(Solid, WedgesPyramidsAndTetrahedraRepeatNodes) {
  const model::Model model = with_elements(
      "1,1,1,2,3,4,5,5,8,8\n"
      "2,1,5,6,7,8,9,9,9,9\n"
      "3,1,1,2,3,5,5,5,5,5\n"
      "4,1,1,2,2,4,5,6,6,8\n");
  EXPECT_EQ(model.solids[0].node, (Corners{0, 1, 2, 3, 4, 4, 7, 7}));
  EXPECT_EQ(model.solids[1].node, (Corners{4, 5, 6, 7, 8, 8, 8, 8}));
  EXPECT_EQ(model.solids[2].node, (Corners{0, 1, 2, 2, 4, 4, 4, 4}));
  EXPECT_EQ(model.solids[3].node, (Corners{0, 1, 1, 3, 4, 5, 5, 7}));
}

TEST(Solid, NodesLeftOutAtTheEndRepeatTheLast) {
  const model::Model model = with_elements("2,1,5,6,7,8,9\n3,1,1,2,3,5,0,0,0,0\n4,1\n2,3,4,6\n");
  EXPECT_EQ(model.solids[0].node, (Corners{4, 5, 6, 7, 8, 8, 8, 8}));
  EXPECT_EQ(model.solids[1].node, (Corners{0, 1, 2, 2, 4, 4, 4, 4}));
  EXPECT_EQ(model.solids[2].node, (Corners{1, 2, 3, 3, 5, 5, 5, 5}));
}

/// Volumes known in closed form: the cube's is 1, the wedge's half of it, the pyramid's base times height by
/// 3, the tetrahedron's a sixth; whichever way round they are given, only the sign changes.
TEST(Solid, NegativeVolumesAreReportedWithTheirValue) {
  const auto volume = [](const std::string& element) {
    const auto messages = solid_messages(element);
    if (messages.size() != 1) return std::string("no message");
    const std::string mark = "has the negative volume ";
    const std::size_t at = messages[0].find(mark);
    return at == std::string::npos
               ? messages[0]
               : messages[0].substr(at + mark.size(), messages[0].find(';') - at - mark.size());
  };
  EXPECT_EQ(volume("1,1,5,6,7,8,1,2,3,4\n"), "-1");
  EXPECT_EQ(volume("1,1,2,1,4,3,5,5,8,8\n"), "-0.5");
  EXPECT_EQ(volume("1,1,5,8,7,6,9,9,9,9\n"), "-0.3333");
  EXPECT_EQ(volume("1,1,1,3,2,5,5,5,5,5\n"), "-0.1667");
}

TEST(Solid, CornerTurnedInsideOutIsAWarning) {
  SolidDeck deck;
  deck.nodes.replace(deck.nodes.find("       7             1.0             1.0             1.0"), 56,
                     "       7             0.1             0.1             0.1");
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model);
  ASSERT_FALSE(result.diagnostics.empty());
  EXPECT_NE(listed(result.diagnostics).find("warning: *ELEMENT_SOLID card 1: solid 21 is so distorted"),
            std::string::npos)
      << listed(result.diagnostics);
}

TEST(Solid, BesideShellsWithSectionsOfBothKinds) {
  SolidDeck deck;
  deck.shells += "*ELEMENT_SHELL\n      21       2       1       2       3       4\n";
  deck.part = "*PART\nblock\n         1         7         1\nplate\n         2         1         1\n";
  deck.section = "*SECTION_SOLID\n         7\n*SECTION_SHELL\n         1         2\n       0.1\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.parts[0].solid_section, 0);
  EXPECT_EQ(model.parts[0].section, no_index);
  EXPECT_EQ(model.parts[1].solid_section, no_index);
  EXPECT_EQ(model.parts[1].section, 0);
  EXPECT_EQ(model.solids[0].part, 0);
  EXPECT_EQ(model.shells[0].part, 1);
}

TEST(SolidSection, EveryFormulation) {
  const auto read = [](const std::string& number) {
    SolidDeck deck;
    deck.section = "*SECTION_SOLID\n1," + number + "\n";
    deck.shells =
        "*ELEMENT_SOLID\n      21       1       1       2       3       5       5       5       5       5\n";
    return read_clean(deck.text()).solid_sections.at(0).formulation;
  };
  using enum model::SolidFormulation;
  EXPECT_EQ(read("1"), OnePointHexahedron);
  EXPECT_EQ(read("2"), SelectiveHexahedron);
  EXPECT_EQ(read("10"), Tetrahedron);
  EXPECT_EQ(read("13"), NodalPressureTetrahedron);
}

TEST(SolidSection, PoorAspectRatiosAreTheHexahedronWithAssumedStrains) {
  for (const char* number : {"-1", "-2"}) {
    SolidDeck deck;
    deck.section = std::string("*SECTION_SOLID\n1,") + number + "\n";
    const ReadResult result = read_deck_text(deck.text());
    ASSERT_TRUE(result.model);
    EXPECT_EQ(result.model->solid_sections[0].formulation, model::SolidFormulation::AssumedStrainHexahedron);
  }
}

TEST(SolidSection, FormulationsThatAreNotThereNameAnother) {
  const auto message = [](const std::string& number) {
    SolidDeck deck;
    deck.section = "*SECTION_SOLID\n1," + number + "\n";
    ReadOptions without_note;
    without_note.ls_dyna_defaults = true;
    return listed(read_deck_text(deck.text(), without_note).diagnostics);
  };
  EXPECT_EQ(
      message("4"),
      "deck.k:20: error: *SECTION_SOLID card 1 field ELFORM: read \"4\", expected 1 (the hexahedron with "
      "one point), 2 (the selectively reduced hexahedron), 10 (the tetrahedron with one point), 13 (the "
      "tetrahedron with averaged nodal pressure), 16 (the ten-node tetrahedron), 19 (the cohesive "
      "hexahedron); 4 is the tetrahedron with rotations at its nodes; take 13, or 10, with four nodes\n");
  EXPECT_EQ(
      message("15"),
      "deck.k: note: densities and moduli look like the units kg, mm, ms\n"
      "deck.k:20: warning: *SECTION_SOLID card 1 field ELFORM: read \"15\", expected 1, 2, 10, 13, 16 or "
      "19; of the wedge with two points: wedges are computed as hexahedra with equal nodes\n");
  EXPECT_EQ(message("115").find("error"), std::string::npos);
  for (const char* number : {"-1", "-2"}) {
    EXPECT_NE(message(number).find("warning: *SECTION_SOLID card 1 field ELFORM"), std::string::npos);
    EXPECT_NE(message(number).find("by assumed strains in elements of any shape"), std::string::npos);
    EXPECT_EQ(message(number).find("error"), std::string::npos);
  }
  for (const char* number : {"3", "18"}) {
    EXPECT_NE(message(number).find("warning: *SECTION_SOLID card 1 field ELFORM"), std::string::npos);
    EXPECT_NE(message(number).find("computed as 2"), std::string::npos);
  }
  EXPECT_NE(message("9").find("computed as 1, with the curves of *MAT_MODIFIED_HONEYCOMB"),
            std::string::npos);
  EXPECT_NE(message("77").find("read \"77\", expected 1"), std::string::npos);
  EXPECT_EQ(message("0").find("error"), std::string::npos);
  SolidDeck deck;
  deck.section = "*SECTION_SOLID\n1,6\n";
  ReadOptions options;
  options.allow_unsupported = true;
  const ReadResult result = read_deck_text(deck.text(), options);
  ASSERT_TRUE(result.model);
  EXPECT_EQ(result.model->solid_sections[0].formulation, model::SolidFormulation::OnePointHexahedron);
}

TEST(Solid, InteriorContactTakesItsNumbersFromThePartSet) {
  SolidDeck deck;
  deck.more = "*CONTACT_INTERIOR\n4\n*SET_PART_LIST\n4,2,0.2,30\n1\n";
  const auto interior = read_clean(deck.text()).parts.at(0).interior;
  ASSERT_TRUE(interior);
  EXPECT_EQ(interior->scale, 2);
  EXPECT_EQ(interior->relative_volume, 0.2);
  EXPECT_EQ(interior->modulus, 30);
  deck.more = "*CONTACT_INTERIOR\n4\n*SET_PART_LIST\n4\n1\n";
  const auto defaults = read_clean(deck.text()).parts.at(0).interior;
  ASSERT_TRUE(defaults);
  EXPECT_EQ(defaults->relative_volume, 0.1);
  deck.more = "*CONTACT_INTERIOR\n5\n";
  EXPECT_NE(listed(read_deck_text(deck.text()).diagnostics).find("no part set 5"), std::string::npos);
}

TEST(SolidHourglass, FormsAndCoefficients) {
  SolidDeck deck;
  deck.part = "*PART\nblock\n1,1,1,0,4\n";
  deck.more = "*CONTROL_HOURGLASS\n5,0.05\n";
  const std::array forms = {SolidHourglassForm::FlanaganBelytschkoViscous,
                            SolidHourglassForm::StandardViscous,
                            SolidHourglassForm::FlanaganBelytschkoViscous,
                            SolidHourglassForm::ExactVolumeViscous,
                            SolidHourglassForm::FlanaganBelytschkoStiffness,
                            SolidHourglassForm::ExactVolumeStiffness,
                            SolidHourglassForm::AssumedStrain};
  for (std::size_t i = 0; i < forms.size(); ++i)
    deck.more += "*HOURGLASS\n" + std::to_string(i + 1) + "," + std::to_string(i) + ",0.03,0,2.0,0.2\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.control.hourglass.solid_form, SolidHourglassForm::ExactVolumeStiffness);
  EXPECT_EQ(model.control.hourglass.coefficient, 0.05);
  for (std::size_t i = 0; i < forms.size(); ++i)
    EXPECT_EQ(model.hourglass_controls[i].solid_form, forms[i]) << i;
  EXPECT_EQ(model::hourglass_of(model, model.parts[0]).coefficient, 0.03);
  EXPECT_EQ(model::bulk_viscosity_of(model, model.parts[0]).quadratic, 2.0);
  EXPECT_EQ(model::bulk_viscosity_of(model, model.parts[0]).linear, 0.2);
}

TEST(SolidHourglass, OtherFormsOfAssumedStrainsAreComputedAsOne) {
  for (const char* form : {"7", "9", "10"}) {
    SolidDeck deck;
    deck.more = "*CONTROL_HOURGLASS\n" + std::string(form) + ",1.0\n";
    const ReadResult result = read_deck_text(deck.text());
    ASSERT_TRUE(result.model) << form;
    EXPECT_EQ(result.model->control.hourglass.solid_form, SolidHourglassForm::AssumedStrain) << form;
    EXPECT_EQ(result.model->control.hourglass.coefficient, 1) << form;
    EXPECT_NE(listed(result.diagnostics).find("field IHQ: read \"" + std::string(form) + "\""),
              std::string::npos);
  }
}

TEST(SolidHourglass, AssumedStrainMayHaveTheWholeStiffnessAndIsNotForShells) {
  EXPECT_TRUE(solid_messages("1,1,1,2,3,4,5,6,7,8\n", "*CONTROL_HOURGLASS\n6,1.0\n").empty());
  EXPECT_EQ(solid_messages("1,1,1,2,3,4,5,6,7,8\n", "*CONTROL_HOURGLASS\n6,1.5\n").size(), 1U);
  SmallDeck shells;
  shells.more = "*CONTROL_HOURGLASS\n6,0.1\n";
  const ReadResult result = read_deck_text(shells.text());
  EXPECT_EQ(result.model->control.hourglass.form, model::HourglassForm::Stiffness);
  EXPECT_NE(listed(result.diagnostics)
                .find("part 1 of shells is under hourglass control IHQ 6, which is for "
                      "solids; its shells take the stiffness form, IHQ 4"),
            std::string::npos)
      << listed(result.diagnostics);
}

TEST(SolidHourglass, DefaultIsTheStiffnessOfTheMaterial) {
  SolidDeck deck;
  const auto control_of = [&](const std::string& material, const ReadOptions& options = {}) {
    deck.material = material;
    const model::Model model = read_clean(deck.text(), options);
    return model::solid_hourglass_of(model, model.parts[0]);
  };
  const std::string elastic = "*MAT_ELASTIC\n1,7.85e-6,210.0,0.3\n";
  EXPECT_EQ(control_of(elastic).solid_form, SolidHourglassForm::AssumedStrain);
  EXPECT_EQ(control_of(elastic).coefficient, 1);
  const std::string plastic = "*MAT_PLASTIC_KINEMATIC\n1,7.85e-6,210.0,0.3,0.3,1.0\n\n";
  EXPECT_EQ(control_of(plastic).solid_form, SolidHourglassForm::AssumedStrain);
  EXPECT_EQ(control_of(plastic).coefficient, 0.01);
  deck.part = "*PART\nblock\n1,1,1,4\n";
  const std::string fluid = "*MAT_NULL\n1,1.0e-6\n*EOS_LINEAR_POLYNOMIAL\n4,0,2.2,0,0,0,0,0\n0\n";
  EXPECT_EQ(control_of(fluid).solid_form, SolidHourglassForm::FlanaganBelytschkoViscous);
  EXPECT_EQ(control_of(fluid).coefficient, 0.1);
  deck.part = SolidDeck().part;
  ReadOptions as_ls_dyna;
  as_ls_dyna.ls_dyna_defaults = true;
  EXPECT_EQ(control_of(elastic, as_ls_dyna).solid_form, SolidHourglassForm::FlanaganBelytschkoViscous);
  EXPECT_EQ(control_of(elastic, as_ls_dyna).coefficient, 0.1);
  deck.more = "*CONTROL_HOURGLASS\n0,0.05\n";
  EXPECT_EQ(control_of(elastic).solid_form, SolidHourglassForm::FlanaganBelytschkoViscous);
  EXPECT_EQ(control_of(elastic).coefficient, 0.05);
}

TEST(SolidHourglass, DefaultIsSaid) {
  const auto said = [](const ReadOptions& options) {
    return listed(read_deck_text(SolidDeck().text(), options).diagnostics);
  };
  EXPECT_NE(said({}).find("no *CONTROL_HOURGLASS: one-point hexahedra resist hourglassing by assumed strains "
                          "(IHQ 6); --ls-dyna-defaults takes viscous control instead"),
            std::string::npos)
      << said({});
  ReadOptions as_ls_dyna;
  as_ls_dyna.ls_dyna_defaults = true;
  EXPECT_EQ(said(as_ls_dyna).find("assumed strains"), std::string::npos);
}

TEST(BulkViscosity, CoefficientsAndDefaults) {
  SolidDeck deck;
  EXPECT_EQ(read_clean(deck.text()).control.bulk_quadratic, 1.5);
  EXPECT_EQ(read_clean(deck.text()).control.bulk_linear, 0.06);
  deck.more = "*CONTROL_BULK_VISCOSITY\n       1.2       0.1         1\n";
  EXPECT_EQ(read_clean(deck.text()).control.bulk_quadratic, 1.2);
  EXPECT_EQ(read_clean(deck.text()).control.bulk_linear, 0.1);
  deck.more = "*CONTROL_BULK_VISCOSITY\n         0         0\n";
  EXPECT_EQ(read_clean(deck.text()).control.bulk_quadratic, 1.5);
  EXPECT_EQ(read_clean(deck.text()).control.bulk_linear, 0.06);
  deck.part = "*PART\nblock\n1,1,1,0,4\n";
  deck.more = "*CONTROL_BULK_VISCOSITY\n       1.2       0.1\n*HOURGLASS\n4,5,0.1\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model::bulk_viscosity_of(model, model.parts[0]).quadratic, 1.2);
  EXPECT_EQ(model::bulk_viscosity_of(model, model.parts[0]).linear, 0.1);
}

TEST(Solid, InitialVelocityByPartAndFixedNodes) {
  SolidDeck deck;
  deck.nodes.replace(deck.nodes.find("       2             1.0             0.0             0.0\n"), 57,
                     "       2             1.0             0.0             0.0       3       7\n");
  deck.more =
      "*INITIAL_VELOCITY_GENERATION\n         1         2       0.0       5.0\n"
      "       0.0       0.0       0.0       0.0       0.0       0.0\n"
      "*BOUNDARY_SPC_NODE\n         3         0         1\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.initial_velocities.size(), 8U);  // node 9 belongs to no element
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(model.initial_velocities[i].node, static_cast<Index>(i));
    EXPECT_EQ(model.initial_velocities[i].velocity, (std::array<double, 3>{5, 0, 0}));
  }
  ASSERT_EQ(model.fixed_nodes.size(), 2U);
  EXPECT_EQ(model.fixed_nodes[0].node, 1);
  EXPECT_EQ(model.fixed_nodes[0].translation, (std::array<bool, 3>{false, false, true}));
  EXPECT_EQ(model.fixed_nodes[1].translation, (std::array<bool, 3>{true, false, false}));
}

TEST(Solid, TakePartInContact) {
  SolidDeck deck;
  deck.shells += "*ELEMENT_SHELL\n      21       2       1       2       3       4\n";
  deck.part = "*PART\nblock\n1,7,1\nplate\n2,1,1\n";
  deck.section = "*SECTION_SOLID\n7\n*SECTION_SHELL\n1,2\n0.1\n";
  deck.section.replace(deck.section.find("7\n*"), 2, "7,1\n")
      .replace(deck.section.find("0.1\n"), 4, "0.1,\n");
  deck.more = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0\n\n\n";
  EXPECT_EQ(read_clean(deck.text()).contacts.at(0).side[0].parts, (std::vector<Index>{0, 1}));
  deck.more = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         2         0         3\n\n\n";
  EXPECT_EQ(read_clean(deck.text()).contacts.at(0).side[0].parts, std::vector<Index>{1});
}

}  // namespace
}  // namespace crumple::deck::test::solids_test
