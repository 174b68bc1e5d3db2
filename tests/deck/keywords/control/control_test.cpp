// SPDX-License-Identifier: BSD-3-Clause
// What *CONTROL, *HOURGLASS and *DATABASE put into the model, and `$crumple` lines.
#include <algorithm>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::control_test {
namespace {

using Vector = std::array<double, 3>;

TEST(Control, MassIsAddedWhenItIsNeededOrOnce) {
  SmallDeck deck;
  deck.more = "*CONTROL_TIMESTEP\n0,0.9,0,0,-1e-3,0,0,1\n";
  EXPECT_TRUE(read_clean(deck.text()).control.scales_mass_once);
  deck.more = "*CONTROL_TIMESTEP\n0,0.9,0,0,-1e-3\n";
  EXPECT_FALSE(read_clean(deck.text()).control.scales_mass_once);
}

TEST(Control, EveryValue) {
  SmallDeck deck;
  deck.termination = "*CONTROL_TERMINATION\n       2.5       900       0.1       5.0      10.0\n";
  deck.more =
      "*TITLE\nA plate\n"
      "*CONTROL_TIMESTEP\n    1.0E-5       0.8         0       0.0   -1.0E-4\n"
      "*CONTROL_ENERGY\n         2         2         2         2\n"
      "*CONTROL_HOURGLASS\n         4      0.03\n"
      "*CONTROL_SHELL\n      20.0         0        -1         1         1         2\n       1.0         1\n"
      "*CONTROL_ACCURACY\n         1\n"
      "*CONTROL_BULK_VISCOSITY\n       1.5      0.06\n"
      "*CONTROL_CONTACT\n       0.2\n";
  deck.section = "*SECTION_SHELL\n         1         0     0.833         5\n       0.1\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.title, "A plate");
  EXPECT_EQ(model.control.end_time, 2.5);
  EXPECT_EQ(model.control.end_cycle, 900);
  EXPECT_EQ(model.control.minimum_step_factor, 0.1);
  EXPECT_EQ(model.control.end_energy_ratio, 5.0);
  EXPECT_EQ(model.control.end_mass_increase, 10.0);
  EXPECT_EQ(model.control.initial_step, 1e-5);
  EXPECT_EQ(model.control.step_scale, 0.8);
  EXPECT_EQ(model.control.mass_scaling_step, -1e-4);
  EXPECT_EQ(model.control.hourglass.form, model::HourglassForm::Stiffness);
  EXPECT_EQ(model.control.hourglass.bending, 0.03);
  EXPECT_TRUE(model.control.thickness_change);
  EXPECT_EQ(model.control.contact_stiffness_scale, 0.2);
  // ELFORM=0 takes THEORY; INTGRD=1 is Lobatto's rule.
  EXPECT_EQ(model.shell_sections[0].formulation, model::ShellFormulation::HughesLiu);
  EXPECT_EQ(model.shell_sections[0].thickness_rule, model::ThicknessRule::Lobatto);
  EXPECT_EQ(model.shell_sections[0].shear_factor, 0.833);
}

/// ERODE with DTMIN, whichever comes first.
TEST(Control, SolidsMayGoByTheirStep) {
  SmallDeck deck;
  deck.termination = "*CONTROL_TIMESTEP\n0,0.9,0,0,0,0,1\n*CONTROL_TERMINATION\n2.5,0,0.1\n";
  EXPECT_TRUE(read_clean(deck.text()).control.erodes_short_solids);
  deck.termination = "*CONTROL_TERMINATION\n2.5,0,0.1\n*CONTROL_TIMESTEP\n0,0.9,0,0,0,0,1\n";
  EXPECT_TRUE(read_clean(deck.text()).control.erodes_short_solids);
  deck.termination = "*CONTROL_TERMINATION\n2.5,0,0.1\n*CONTROL_TIMESTEP\n0,0.9\n";
  EXPECT_FALSE(read_clean(deck.text()).control.erodes_short_solids);
}

TEST(Control, DefaultsOfLsDyna) {
  const model::Model model = read_with("$crumple defaults=ls-dyna\n");
  EXPECT_EQ(model.control.step_scale, 0.9);
  EXPECT_EQ(model.control.hourglass.form, model::HourglassForm::Viscous);
  EXPECT_EQ(model.control.hourglass.coefficient, 0.1);
  EXPECT_EQ(model.control.contact_stiffness_scale, 0.1);
  EXPECT_FALSE(model.control.thickness_change);
  EXPECT_EQ(model.shell_sections[0].shear_factor, 1.0);
  EXPECT_EQ(model.shell_sections[0].thickness_points, 2);
  EXPECT_EQ(model.shell_sections[0].thickness_rule, model::ThicknessRule::Gauss);
  EXPECT_EQ(model.search.method, "production");
  EXPECT_TRUE(model.run.precision.empty());
}

/// With LS-DYNA's meaning of what is blank on a card that is there.
TEST(Control, ShellsThatTheDeckLeavesOpen) {
  const model::Model open = read_with("");
  EXPECT_TRUE(open.control.thickness_change);
  EXPECT_EQ(open.control.hourglass.form, model::HourglassForm::Material);
  const model::Model with_shell = read_with("*CONTROL_SHELL\n\n");
  EXPECT_FALSE(with_shell.control.thickness_change);
  EXPECT_EQ(with_shell.control.hourglass.form, model::HourglassForm::Material);
  const model::Model with_hourglass = read_with("*CONTROL_HOURGLASS\n\n");
  EXPECT_TRUE(with_hourglass.control.thickness_change);
  EXPECT_EQ(with_hourglass.control.hourglass.form, model::HourglassForm::Viscous);
  EXPECT_EQ(with_hourglass.control.hourglass.coefficient, 0.1);
  ReadOptions options;
  options.ls_dyna_defaults = true;
  const model::Model asked = read_clean(SmallDeck().text(), options);
  EXPECT_FALSE(asked.control.thickness_change);
  EXPECT_EQ(asked.control.hourglass.form, model::HourglassForm::Viscous);
}

TEST(Control, SecondOneReplacesTheFirstWithAWarning) {
  const auto messages = messages_with("*CONTROL_TERMINATION\n3.0,\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0],
            "deck.k:22: warning: *CONTROL_TERMINATION: replaces what the same keyword says at deck.k:2");
}

/// Used, with a warning.
TEST(Control, StepAboveTheUsualShareOfTheStableOne) {
  const auto messages = messages_with("*CONTROL_TIMESTEP\n0.0,0.95\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(
      messages[0],
      "deck.k:23: warning: *CONTROL_TIMESTEP card 1 field TSSFAC: read \"0.95\", expected a factor up to "
      "0.9; it is used, but leaves little of the stable step to contact, friction and damping");
  SmallDeck deck;
  deck.more = "*CONTROL_TIMESTEP\n0.0,0.95\n";
  EXPECT_EQ(read_deck_text(deck.text()).model.value().control.step_scale, 0.95);
}

/// Used, with a warning.
TEST(Hourglass, CoefficientAboveWhatIsRecommended) {
  EXPECT_EQ(messages_with("*CONTROL_HOURGLASS\n1,0.15\n*HOURGLASS\n1,4,0.15,0,0,0,0.15,0.15\n").size(), 0U);
  const std::string expected =
      ", expected a coefficient up to 0.15; it is used, and the run may become unstable";
  const auto messages = messages_with("*CONTROL_HOURGLASS\n1,0.2\n*HOURGLASS\n1,4,0.3,0,0,0,0.1,0.4\n");
  ASSERT_EQ(messages.size(), 3U);
  EXPECT_EQ(messages[0], "deck.k:23: warning: *CONTROL_HOURGLASS card 1 field QH: read \"0.2\"" + expected);
  EXPECT_EQ(messages[1], "deck.k:25: warning: *HOURGLASS card 1 field QM: read \"0.3\"" + expected);
  EXPECT_EQ(messages[2], "deck.k:25: warning: *HOURGLASS card 1 field QW: read \"0.4\"" + expected);
  SmallDeck deck;
  deck.more = "*CONTROL_HOURGLASS\n1,0.2\n";
  EXPECT_EQ(read_deck_text(deck.text()).model.value().control.hourglass.coefficient, 0.2);
}

TEST(Database, IntervalsAndHistories) {
  const model::Model model = read_with(
      "*DATABASE_GLSTAT\n      "
      "0.01\n*DATABASE_MATSUM\n0.02,3\n*DATABASE_RWFORC\n0.03,\n*DATABASE_RCFORC\n0.04,\n"
      "*DATABASE_NODOUT\n0.05,\n*DATABASE_BINARY_D3PLOT\n0.5,\n"
      "*DATABASE_HISTORY_NODE\n         3         1\n*DATABASE_HISTORY_NODE_ID\n         6the tip\n"
      "*DATABASE_HISTORY_NODE_SET\n         2\n*SET_NODE_LIST\n         2\n         1         2\n");
  EXPECT_EQ(model.output.of(model::HistoryFile::Glstat).interval, 0.01);
  EXPECT_EQ(model.output.of(model::HistoryFile::Matsum).interval, 0.02);
  EXPECT_EQ(model.output.of(model::HistoryFile::Rwforc).interval, 0.03);
  EXPECT_EQ(model.output.of(model::HistoryFile::Rcforc).interval, 0.04);
  EXPECT_EQ(model.output.of(model::HistoryFile::Nodout).interval, 0.05);
  EXPECT_EQ(model.output.state_interval, 0.5);
  EXPECT_EQ(model.output.history_nodes, (std::vector<Index>{2, 0, 5, 1}));
}

TEST(Database, RigidBodiesAndWeldsAreAskedForInTheFormOfTheCard) {
  const model::Model model = read_with("*DATABASE_RBDOUT\n0.01,1\n*DATABASE_SWFORC\n0.02,2\n");
  const model::HistoryRequest& bodies = model.output.of(model::HistoryFile::Rbdout);
  EXPECT_TRUE(bodies.asked && bodies.ascii && !bodies.binary);
  EXPECT_EQ(bodies.interval, 0.01);
  const model::HistoryRequest& welds = model.output.of(model::HistoryFile::Swforc);
  EXPECT_TRUE(welds.asked && !welds.ascii && welds.binary);
  EXPECT_EQ(welds.interval, 0.02);
}

TEST(Database, HistoriesOfElements) {
  const model::Model model = read_with(
      "*DATABASE_ELOUT\n0.5,2\n*DATABASE_HISTORY_SHELL_SET\n4\n*SET_SHELL_LIST\n4\n12,11\n"
      "*DATABASE_HISTORY_SHELL_ID\n11,first\n*DATABASE_HISTORY_NODE\n2\n");
  const model::HistoryRequest& asked = model.output.of(model::HistoryFile::Elout);
  EXPECT_TRUE(asked.asked);
  EXPECT_EQ(asked.interval, 0.5);
  EXPECT_FALSE(asked.ascii);
  EXPECT_TRUE(asked.binary);
  EXPECT_EQ(model.output.history_shells, (std::vector<Index>{1, 0}));
  EXPECT_EQ(model.output.history_nodes, (std::vector<Index>{1}));
  EXPECT_TRUE(model.output.history_solids.empty());
  EXPECT_FALSE(model.output.of(model::HistoryFile::Deforc).asked);
}

TEST(Database, NumberOfStatesOverTheRun) {
  EXPECT_EQ(
      read_with("*DATABASE_BINARY_D3PLOT\n       0.0         0         0        50\n").output.state_interval,
      0.05);
}

TEST(Settings, CommentLinesOfOurOwn) {
  const model::Model model = read_with(
      "$crumple method=nbs expansion=0.25\n"
      "$Crumple cells=60,8,8 domain=0,0.3,-1,0.04,0,4e-2\n"
      "$crumple precision=double\n"
      "$crumpled is another word\n");
  EXPECT_EQ(model.search.method, "nbs");
  EXPECT_EQ(model.search.expansion, 0.25);
  EXPECT_TRUE(model.search.has_cells);
  EXPECT_EQ(model.search.cells, (std::array<Index, 3>{60, 8, 8}));
  EXPECT_EQ(model.search.domain_minimum, (Vector{0, -1, 0}));
  EXPECT_EQ(model.search.domain_maximum, (Vector{0.3, 0.04, 0.04}));
  EXPECT_EQ(model.run.precision, "double");
}

TEST(Settings, MethodMustBeOneOfThose) {
  ReadOptions options;
  options.search_methods = {"linked-cell", "brute-force"};
  const auto messages = messages_with("$crumple method=quick\n", options);
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0],
            "deck.k:22: error: $crumple method: read \"quick\", expected one of linked-cell, brute-force");
}

TEST(Terminations, BoundPlacesDisplacementsForcesAndErosion) {
  SmallDeck deck;
  deck.part += "*PART\nstiff\n2,1,2\n";
  deck.shells =
      "*ELEMENT_SHELL\n"
      "      11       1       1       2       3       4\n"
      "      12       2       2       5       6       3\n";
  deck.material += "*MAT_RIGID\n2,7.83E-6,207.0,0.3\n\n\n";
  deck.more =
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n4\n1,2,3,3\n\n\n"
      "*TERMINATION_NODE\n3,2,0.0\n3,3,,-5.0\n4,4\n"
      "*TERMINATION_BODY\n2,1,0.0,-2.5\n2,4,3.0\n"
      "*TERMINATION_CONTACT\n4,0.1,0.2,0.3,2\n4\n"
      "*SET_PART_LIST\n8\n1,2\n*TERMINATION_DELETED_SHELLS\n1,3\n*TERMINATION_DELETED_SOLIDS_SET\n8\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.terminations.size(), 9U);
  using Kind = model::Termination::Kind;
  const auto& t = model.terminations;
  EXPECT_EQ(t[0].kind, Kind::Place);
  EXPECT_EQ(t[0].item, 2);
  EXPECT_EQ(t[0].axis, 1);
  EXPECT_EQ(t[0].most, 0);
  EXPECT_EQ(t[0].least, -1e21);
  EXPECT_EQ(t[1].axis, 2);
  EXPECT_EQ(t[1].most, 1e21);
  EXPECT_EQ(t[1].least, -5);
  EXPECT_EQ(t[2].kind, Kind::Touch);
  EXPECT_EQ(t[3].kind, Kind::Displacement);
  EXPECT_EQ(t[3].item, 0);
  EXPECT_EQ(t[3].most, 1e21);
  EXPECT_EQ(t[3].least, -2.5);
  EXPECT_EQ(t[4].kind, Kind::Distance);
  EXPECT_EQ(t[4].most, 3);
  EXPECT_EQ(t[5].kind, Kind::NoContact);
  EXPECT_EQ(t[5].activation, 0.1);
  EXPECT_EQ(t[5].duration, 0.2);
  EXPECT_EQ(t[5].threshold, 0.3);
  EXPECT_EQ(t[5].axis, 1);
  EXPECT_EQ(t[6].axis, -1);
  EXPECT_EQ(t[7].kind, Kind::Deleted);
  EXPECT_EQ(t[7].count, 3);
  EXPECT_EQ(t[7].parts, std::vector<Index>{0});
  EXPECT_EQ(t[8].count, 1);
  EXPECT_EQ(t[8].parts, (std::vector<Index>{0, 1}));
}

}  // namespace
}  // namespace crumple::deck::test::control_test
