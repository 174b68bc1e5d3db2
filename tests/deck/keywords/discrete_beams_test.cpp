// SPDX-License-Identifier: BSD-3-Clause
// Discrete beams and their materials, from the cards to the model.
#include "deck/small_deck.hpp"

namespace crumple::deck::discrete_beams_test {
namespace {

using test::read_with;

std::string with(const std::string& section, const std::string& material,
                 const std::string& nodes = "       1       5       0") {
  return "*ELEMENT_BEAM\n      11       2" + nodes +
         "\n*PART\nspring\n         2         2         2\n*SECTION_BEAM\n" + section + material;
}
const std::string small_section = "2,6\n0.5,0.25\n";

const model::DiscreteBeamLaw& law_of(const model::Model& model) {
  return std::get<model::DiscreteBeamLaw>(model.materials.at(1).law);
}

TEST(DiscreteBeamDecks, HaveVolumeInertiaAndAxes) {
  const model::Model model = read_with(with("2,6,,,,-1\n0.5,0.25,7,0.1,0.2,1,0,1\n",
                                            "*MAT_LINEAR_ELASTIC_DISCRETE_BEAM\n2,1.0,1,2,3,4,5,6\n"
                                            "*DEFINE_COORDINATE_SYSTEM\n7,0,0,0,0,1,0\n-1,0,0\n"));
  const model::BeamSection& section = model.beam_sections.at(0);
  EXPECT_EQ(section.formulation, model::BeamFormulation::Discrete);
  EXPECT_EQ(section.discrete.volume, 0.5);
  EXPECT_EQ(section.discrete.inertia, 0.25);
  EXPECT_EQ(section.discrete.cable_area, 0.1);
  EXPECT_EQ(section.discrete.cable_offset, 0.2);
  EXPECT_EQ(section.discrete.place, -1);
  EXPECT_EQ(section.discrete.held, (std::array<bool, 3>{true, false, true}));
  ASSERT_TRUE(section.discrete.axes.has_value());
  EXPECT_NEAR((*section.discrete.axes)[0][1], 1, 1e-15);
  EXPECT_NEAR((*section.discrete.axes)[1][0], -1, 1e-15);
}

TEST(DiscreteBeamDecks, LinearOnesHaveStiffnessDampingAndPreload) {
  const model::Model model = read_with(
      with(small_section, "*MAT_066\n2,1.0,1,2,3,4,5,6\n0.1,0.2,0.3,0.4,0.5,0.6\n7,8,9,10,11,12\n"));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(law_of(model).direction[i].stiffness, static_cast<double>(i + 1));
    EXPECT_DOUBLE_EQ(law_of(model).direction[i].damping, 0.1 * static_cast<double>(i + 1));
    EXPECT_EQ(law_of(model).direction[i].preload, static_cast<double>(i + 7));
  }
}

TEST(DiscreteBeamDecks, MayHaveBothNodesAtOnePlace) {
  const model::Model model =
      read_with("*NODE\n       7             0.0             0.0             0.0\n" +
                with(small_section, "*MAT_066\n2,1.0,1,2,3,4,5,6\n", "       1       7       0"));
  EXPECT_EQ(model.beams.size(), 1U);
}

const std::string curves =
    "*DEFINE_CURVE\n3\n0.0,0.0\n1.0,2.0\n*DEFINE_CURVE\n4\n-1.0,-3.0\n0.0,0.0\n1.0,2.0\n";

TEST(DiscreteBeamDecks, NonlinearOnesHaveCurves) {
  const model::Model model =
      read_with(with(small_section, "*MAT_067\n2,1.0,3,4,0,0,0,4\n0,3,0,0,0,0\n1,0,0,0,0,2\n" + curves));
  const auto& direction = law_of(model).direction;
  EXPECT_EQ(model.curves.at(static_cast<std::size_t>(direction[0].curve)).id, 3);
  EXPECT_EQ(model.curves.at(static_cast<std::size_t>(direction[1].curve)).id, 4);
  EXPECT_EQ(direction[2].curve, no_index);
  EXPECT_EQ(model.curves.at(static_cast<std::size_t>(direction[5].curve)).id, 4);
  EXPECT_EQ(model.curves.at(static_cast<std::size_t>(direction[1].damping_curve)).id, 3);
  EXPECT_EQ(direction[5].preload, 2);
}

TEST(DiscreteBeamDecks, CablesHaveModulusOrStiffnessOrCurve) {
  using Kind = model::DiscreteBeamLaw::Kind;
  const model::Model modulus =
      read_with(with("2,6\n,,,0.5\n", "*MAT_CABLE_DISCRETE_BEAM\n2,1.0,200,,3,,4\n"));
  EXPECT_EQ(law_of(modulus).kind, Kind::Cable);
  EXPECT_EQ(law_of(modulus).youngs_modulus, 200);
  EXPECT_EQ(law_of(modulus).direction[0].preload, 3);
  EXPECT_EQ(law_of(modulus).ramp_time, 4);
  const model::Model stiffness = read_with(with("2,6\n,,,0.5\n", "*MAT_071\n2,1.0,-7\n"));
  EXPECT_EQ(law_of(stiffness).youngs_modulus, 0);
  EXPECT_EQ(law_of(stiffness).direction[0].stiffness, 7);
  const model::Model curve = read_with(with("2,6\n,,,0.5\n", "*MAT_071\n2,1.0,,3\n" + curves));
  EXPECT_EQ(curve.curves.at(static_cast<std::size_t>(law_of(curve).stress_curve)).id, 3);
}

TEST(DiscreteBeamDecks, SpringsHaveLimits) {
  const model::Model model =
      read_with(with(small_section, "*MAT_ELASTIC_SPRING_DISCRETE_BEAM\n2,1.0,5,6,7,0.1,0.2\n"));
  const model::DiscreteBeamDirection& line = law_of(model).direction[0];
  EXPECT_EQ(law_of(model).kind, model::DiscreteBeamLaw::Kind::Line);
  EXPECT_EQ(line.stiffness, 5);
  EXPECT_EQ(line.preload, 6);
  EXPECT_EQ(line.damping, 7);
  EXPECT_EQ(line.compressive_limit, 0.1);
  EXPECT_EQ(line.tensile_limit, 0.2);
  const model::Model curve = read_with(with(small_section, "*MAT_074\n2,1.0,5\n3\n" + curves));
  EXPECT_EQ(law_of(curve).direction[0].stiffness, 0);
  EXPECT_EQ(curve.curves.at(static_cast<std::size_t>(law_of(curve).direction[0].curve)).id, 3);
}

TEST(DiscreteBeamDecks, GeneralOnesUnloadAndFail) {
  using Unloading = model::DiscreteBeamLaw::Unloading;
  for (const std::string name : {"*MAT_GENERAL_NONLINEAR_6DOF_DISCRETE_BEAM", "*MAT_119"}) {
    const model::Model model =
        read_with(with(small_section, name +
                                          "\n2,1.0,5,6,2,0.25\n3,,,,,3\n,3,,3\n,,3\n,,3\n"
                                          "1,2,3,4,5,6,1\n7,8,9,10,11,12\n" +
                                          curves));
    const model::DiscreteBeamLaw& law = law_of(model);
    EXPECT_EQ(law.kind, model::DiscreteBeamLaw::Kind::Axes);
    EXPECT_EQ(law.unloading, Unloading::Stiffness);
    EXPECT_EQ(law.permanent_share, 0.25);
    EXPECT_TRUE(law.joint_failure);
    for (std::size_t i = 0; i < 6; ++i) {
      const model::DiscreteBeamDirection& one = law.direction[i];
      EXPECT_EQ(one.unloading_stiffness, i < 3 ? 5 : 6);
      EXPECT_EQ(one.curve != no_index, i == 0 || i == 5);
      EXPECT_EQ(one.unloading_curve != no_index, i == 1 || i == 3);
      EXPECT_EQ(one.damping_curve != no_index, i == 2);
      EXPECT_EQ(one.damping_factor != no_index, i == 2);
      EXPECT_EQ(one.tensile_limit, static_cast<double>(i + 1));
      EXPECT_EQ(one.compressive_limit, static_cast<double>(i + 7));
    }
  }
  for (const std::string name : {"*MAT_GENERAL_NONLINEAR_1DOF_DISCRETE_BEAM", "*MAT_121"}) {
    const model::Model model =
        read_with(with(small_section, name + "\n2,1.0,5,1,0.25\n3,3,3,3\n0.5,0.7\n" + curves));
    const model::DiscreteBeamLaw& law = law_of(model);
    EXPECT_EQ(law.kind, model::DiscreteBeamLaw::Kind::Line);
    EXPECT_EQ(law.unloading, Unloading::Curve);
    const model::DiscreteBeamDirection& line = law.direction[0];
    EXPECT_EQ(line.unloading_stiffness, 5);
    for (const Index curve : {line.curve, line.unloading_curve, line.damping_curve, line.damping_factor})
      EXPECT_NE(curve, no_index);
    EXPECT_EQ(line.tensile_limit, 0.5);
    EXPECT_EQ(line.compressive_limit, 0.7);
  }
}

}  // namespace
}  // namespace crumple::deck::discrete_beams_test
