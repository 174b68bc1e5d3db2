// SPDX-License-Identifier: BSD-3-Clause
// Beams, trusses, springs and dampers from the cards to the model.
#include "deck/small_deck.hpp"

namespace crumple::deck::beams_test {
namespace {

using test::read_clean;
using test::read_with;

const std::string frame = "*PART\nframe\n         2         2         1\n";

std::string beams(const std::string& section, const std::string& elements) {
  return "*ELEMENT_BEAM\n" + elements + frame + "*SECTION_BEAM\n" + section;
}

TEST(Beams, OfResultantsHaveTheirSectionAndOrientation) {
  const model::Model model =
      read_with(beams("         2         2\n      25.0      52.0      26.0     100.0      20.0\n",
                      "      11       2       1       5       4\n"));
  ASSERT_EQ(model.beams.size(), 1U);
  EXPECT_EQ(model.beams[0].id, 11);
  EXPECT_EQ(model.beams[0].part, 1);
  EXPECT_EQ(model.beams[0].node, (std::array<Index, 2>{0, 4}));
  EXPECT_EQ(model.beams[0].orientation_node, 3);
  EXPECT_EQ(model.parts[1].beam_section, 0);
  EXPECT_EQ(model::kind_of(model.parts[1]), model::ElementKind::Beam);
  const model::BeamSection& section = model.beam_sections[0];
  EXPECT_EQ(section.formulation, model::BeamFormulation::BelytschkoSchwer);
  EXPECT_EQ(section.area, 25);
  EXPECT_EQ(section.inertia_s, 52);
  EXPECT_EQ(section.inertia_t, 26);
  EXPECT_EQ(section.torsion, 100);
  EXPECT_EQ(section.shear_area, 20);
}

TEST(Beams, WithoutATorsionalConstantTakeTheSumOfBothMoments) {
  const model::Model model = read_with(
      beams("         2         2\n      25.0      52.0      52.0\n", "      11       2       1       5\n"));
  EXPECT_EQ(model.beam_sections[0].torsion, 104);
  EXPECT_EQ(model.beams[0].orientation_node, no_index);
}

TEST(Beams, MayHaveAVectorOfOrientation) {
  const model::Model model = read_with(
      "*ELEMENT_BEAM_ORIENTATION\n      11       2       1       5\n       0.0       2.0       1.0\n" +
      frame + "*SECTION_BEAM_TITLE\nbox\n         2         2\n      25.0      52.0      26.0\n");
  EXPECT_EQ(model.beams[0].orientation, (std::array<double, 3>{0, 2, 1}));
  EXPECT_EQ(model.beam_sections[0].title, "box");
}

TEST(Beams, TrussesHaveAnAreaOnly) {
  const model::Model model =
      read_with(beams("         2         3\n      25.0\n", "      11       2       1       5\n"));
  EXPECT_EQ(model.beam_sections[0].formulation, model::BeamFormulation::Truss);
  EXPECT_EQ(model.beam_sections[0].area, 25);
}

TEST(Beams, MayHaveHinges) {
  const model::Model model = read_with(
      "*ELEMENT_BEAM\n      11       2       1       5       4\n"
      "*PART\nframe\n         2         2         2\n"
      "*SECTION_BEAM\n         2         2\n      25.0      52.0      26.0\n"
      "*MAT_RESULTANT_PLASTICITY\n         2   7.83E-6     207.0       0.3       0.2\n");
  const auto law = std::get<model::ResultantPlasticity>(model.materials[1].law);
  EXPECT_EQ(law.youngs_modulus, 207);
  EXPECT_EQ(law.yield_stress, 0.2);
}

TEST(Beams, AreAmongTheNodesOfTheirPart) {
  const model::Model model =
      read_with(beams("         2         3\n      25.0\n", "      11       2       1       5\n") +
                "*SET_NODE_GENERAL\n         3\nPART               2\n");
  EXPECT_EQ(model.node_sets[0].nodes, (std::vector<Index>{0, 4}));
}

const std::string springs =
    "*PART\nsprings\n         2         2         2\n*SECTION_DISCRETE\n         2\n\n";

TEST(Springs, HaveScaleOffsetAndDirection) {
  const model::Model model = read_with(
      "*ELEMENT_DISCRETE\n"
      "       1       2       1       5       0             2.5       0             0.1\n"
      "       2       2       3       0       9\n" +
      springs +
      "*MAT_SPRING_ELASTIC\n         2       0.5\n"
      "*DEFINE_SD_ORIENTATION\n         9         0       3.0       0.0       4.0\n");
  ASSERT_EQ(model.discretes.size(), 2U);
  const model::DiscreteElement& first = model.discretes[0];
  EXPECT_EQ(first.node, (std::array<Index, 2>{0, 4}));
  EXPECT_FALSE(first.grounded);
  EXPECT_EQ(first.scale, 2.5);
  EXPECT_EQ(first.offset, 0.1);
  EXPECT_EQ(first.axis, (std::array<double, 3>{}));
  const model::DiscreteElement& second = model.discretes[1];
  EXPECT_TRUE(second.grounded);
  EXPECT_EQ(second.node, (std::array<Index, 2>{2, 2}));
  EXPECT_EQ(second.scale, 1);
  EXPECT_EQ(second.axis, (std::array<double, 3>{0.6, 0, 0.8}));
  EXPECT_EQ(model.parts[1].spring_material, 0);
  EXPECT_EQ(model.parts[1].material, no_index);
  EXPECT_FALSE(model.discrete_sections[0].torsional);
  EXPECT_EQ(std::get<model::LinearSpring>(model.spring_materials[0].law).stiffness, 0.5);
}

/// The law of a part of springs.
model::SpringLaw law_of(const std::string& material) {
  const model::Model model =
      read_with("*ELEMENT_DISCRETE\n       1       2       1       5\n" + springs + material);
  return model.spring_materials.at(0).law;
}

TEST(Springs, HaveTheirLaws) {
  EXPECT_EQ(std::get<model::LinearDamper>(law_of("*MAT_DAMPER_VISCOUS\n         2       0.5\n")).damping,
            0.5);
  const auto plastic = std::get<model::ElastoplasticSpring>(
      law_of("*MAT_S03_TITLE\nhinge\n         2       0.5       0.1       7.0\n"));
  EXPECT_EQ(plastic.stiffness, 0.5);
  EXPECT_EQ(plastic.tangent_stiffness, 0.1);
  EXPECT_EQ(plastic.yield_force, 7);
  const std::string curves =
      "*DEFINE_CURVE\n         3\n                -1.0                -2.0\n"
      "                 1.0                 2.0\n"
      "*DEFINE_CURVE\n         4\n                 0.0                 1.0\n"
      "                 1.0                 2.0\n";
  const auto nonlinear = std::get<model::NonlinearSpring>(
      law_of("*MAT_SPRING_NONLINEAR_ELASTIC\n         2         3         4\n" + curves));
  EXPECT_EQ(nonlinear.curve, 0);
  EXPECT_EQ(nonlinear.rate_curve, 1);
  const auto damper = std::get<model::NonlinearDamper>(law_of("*MAT_S05\n         2         3\n" + curves));
  EXPECT_EQ(damper.curve, 0);
}

TEST(Springs, RelaxOrStayDeformed) {
  const auto maxwell = std::get<model::MaxwellSpring>(
      law_of("*MAT_SPRING_MAXWELL\n         2       0.5       0.1       7.0       3.0       0.2\n"));
  EXPECT_EQ(maxwell.stiffness, 0.5);
  EXPECT_EQ(maxwell.final_stiffness, 0.1);
  EXPECT_EQ(maxwell.decay, 7);
  EXPECT_EQ(maxwell.cut_off, 3);
  EXPECT_EQ(maxwell.cut_off_force, 0.2);
  EXPECT_EQ(std::get<model::MaxwellSpring>(law_of("*MAT_S07\n         2       0.5\n")).cut_off, 1e20);
  const std::string curve =
      "*DEFINE_CURVE\n         3\n                 0.0                 0.0\n"
      "                 1.0                 2.0\n";
  const auto inelastic = std::get<model::InelasticSpring>(
      law_of("*MAT_SPRING_INELASTIC\n         2         3       5.0      -1.0\n" + curve));
  EXPECT_EQ(inelastic.curve, 0);
  EXPECT_EQ(inelastic.unloading_stiffness, 5);
  EXPECT_TRUE(inelastic.tension);
  EXPECT_FALSE(std::get<model::InelasticSpring>(law_of("*MAT_S08\n         2         3\n" + curve)).tension);
}

TEST(Springs, MayBeTorsionalBetweenInertias) {
  const model::Model model = read_clean(
      "*KEYWORD\n*CONTROL_TERMINATION\n       1.0\n*NODE\n"
      "       1             0.0             0.0             0.0\n"
      "       2             0.0             0.0             1.0\n"
      "*ELEMENT_DISCRETE\n       1       2       1       2\n"
      "*ELEMENT_INERTIA\n       1       1\n"
      "       0.5       0.0       0.0       0.5       0.0       0.5       2.0\n"
      "*ELEMENT_MASS\n       2       2             1.0\n"
      "*PART\nsprings\n         2         2         2\n*SECTION_DISCRETE\n         2         1\n\n"
      "*MAT_SPRING_ELASTIC\n         2       0.5\n*END\n");
  EXPECT_TRUE(model.discrete_sections[0].torsional);
  EXPECT_EQ(model.lumped_masses[0].mass, 2);
  EXPECT_EQ(model.lumped_masses[0].inertia, 0.5);
}

}  // namespace
}  // namespace crumple::deck::beams_test
