// SPDX-License-Identifier: BSD-3-Clause
// *MAT_HONEYCOMB, *MAT_SOIL_AND_FOAM, *MAT_VISCOUS_FOAM, *MAT_SIMPLIFIED_RUBBER/FOAM,
// *MAT_BILKHU/DUBOIS_FOAM.
#include <gtest/gtest.h>

#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::foam_materials_test {
namespace {

std::vector<std::string> messages(const std::string& material, const std::string& more) {
  CubeDeck deck;
  deck.material = material;
  deck.more = more;
  return messages_in(deck);
}
model::Model clean(const std::string& material, const std::string& more) {
  CubeDeck deck;
  deck.material = material;
  deck.more = more;
  return read_clean(deck.text());
}

// Over 1 - V, over V, and of shear.
const std::string curves =
    "*DEFINE_CURVE\n11\n0.0,5.0\n0.6,5.5\n0.7,20.0\n*DEFINE_CURVE\n12\n0.3,9.0\n0.5,2.0\n1.0,1.0\n"
    "*DEFINE_CURVE\n13\n-0.1,2.0\n0.7,3.0\n*DEFINE_CURVE\n14\n0.0,1.0\n100.0,2.0\n";
const std::string honeycomb =
    "*MAT_HONEYCOMB\n1,8.3E-11,70000,0.33,240,0.25,0.08\n11,12,0,13,0,12,0,14\n"
    "1020,340,341,434,214,215,2\n0,0,0,1,2,3\n4,5,7,0.6,0.5\n";

TEST(FoamMaterial, Honeycomb) {
  for (const std::string keyword : {"*MAT_HONEYCOMB", "*MAT_026", "*MAT_26"}) {
    const auto model = clean(replaced(honeycomb, "*MAT_HONEYCOMB", keyword), curves);
    const auto& law = std::get<model::Honeycomb>(model.materials[0].law);
    EXPECT_EQ(law.youngs_modulus, 70000);
    EXPECT_EQ(law.poissons_ratio, 0.33);
    EXPECT_EQ(law.yield_stress, 240);
    EXPECT_EQ(law.compacted_volume, 0.25);
    EXPECT_EQ(law.viscosity, 0.08);
    EXPECT_FALSE(law.standard_viscosity);
    EXPECT_EQ(law.moduli, (std::array<double, 6>{1020, 340, 341, 434, 214, 215}));
    EXPECT_EQ(law.crush[0].crush, (std::vector<double>{0, 0.6, 0.7}));
    EXPECT_EQ(law.crush[0].stress, (std::vector<double>{5, 5.5, 20}));
    // Over the relative volume: turned round.
    EXPECT_EQ(law.crush[1].crush, (std::vector<double>{0, 0.5, 0.7}));
    EXPECT_EQ(law.crush[1].stress, (std::vector<double>{1, 2, 9}));
    EXPECT_EQ(law.crush[2].stress, law.crush[0].stress);
    EXPECT_EQ(law.crush[3].crush, (std::vector<double>{-0.1, 0.7}));
    EXPECT_EQ(law.crush[4].stress, law.crush[1].stress);
    EXPECT_EQ(law.crush[5].stress, law.crush[3].stress);
    EXPECT_EQ(law.rates.rate, (std::vector<double>{0, 100}));
    EXPECT_EQ(law.rates.factor, (std::vector<double>{1, 2}));
    EXPECT_EQ(law.axes, model::Honeycomb::Axes::Vectors);
    EXPECT_EQ(law.a, (std::array<double, 3>{1, 2, 3}));
    EXPECT_EQ(law.d, (std::array<double, 3>{4, 5, 7}));
    EXPECT_EQ(law.failure_tension, 0.6);
    EXPECT_EQ(law.failure_shear, 0.5);
  }
}

TEST(FoamMaterial, HoneycombDefaultsAndAxes) {
  const std::string start = "*MAT_026\n1,8.3E-11,70000,0.33,240,0.25,0,1\n11\n1020,340,341,434,214,215";
  const auto model = clean(start + "\n\n\n", curves);
  const auto& law = std::get<model::Honeycomb>(model.materials[0].law);
  EXPECT_EQ(law.viscosity, 0.05);
  EXPECT_TRUE(law.standard_viscosity);
  for (const auto& crush : law.crush) EXPECT_EQ(crush.stress, law.crush[0].stress);
  EXPECT_EQ(law.axes, model::Honeycomb::Axes::Nodes);
  EXPECT_EQ(law.failure_tension, 0);
  const auto by_point = clean(start + ",1\n7,8,9\n\n", curves);
  const auto& other = std::get<model::Honeycomb>(by_point.materials[0].law);
  EXPECT_EQ(other.axes, model::Honeycomb::Axes::Point);
  EXPECT_EQ(other.a, (std::array<double, 3>{7, 8, 9}));
}

TEST(FoamMaterial, HoneycombFaults) {
  only_message(messages(replaced(honeycomb, "0.25,", "1.25,"), curves), "field VF");
  only_message(messages(replaced(honeycomb, "0.08", "0.08,2"), curves), "field BULK");
  only_message(messages(replaced(honeycomb, ",434,", ",0,"), curves), "field GABU");
  only_message(messages(replaced(honeycomb, "215,2", "215,3"), curves), "field AOPT");
  only_message(messages(replaced(honeycomb, "215,2", "215,2,3"), curves), "field MACF");
  only_message(messages(replaced(honeycomb, "0,0,0,1,2,3", "0,0,0"), curves), "field A1");
  only_message(messages(replaced(honeycomb, "4,5,7", "0,0,0"), curves), "field D1");
  only_message(messages(replaced(honeycomb, "\n11,", "\n0,"), curves), "field LCA");
  only_message(messages(replaced(honeycomb, "12,0,14", "12,0,15"), curves), "the deck has no curve 15");
  only_message(messages(replaced(honeycomb, "\n11,", "\n16,"), curves), "the deck has no curve 16");
  only_message(messages(honeycomb, replaced(curves, "0.6,5.5", "0.6,-5.5")), "not below zero");
  only_message(messages(honeycomb, replaced(curves, "100.0,2.0", "100.0,0.0")), "factors above zero");
}

const std::string soil =
    "*MAT_SOIL_AND_FOAM\n1,1.8E-9,30,200,0.5,0.4,0.03,-0.2\n0,0\n-0.05,-0.2,-0.4\n\n4,10,60\n\n";

TEST(FoamMaterial, SoilAndFoam) {
  for (const std::string keyword : {"*MAT_SOIL_AND_FOAM", "*MAT_005", "*MAT_5"}) {
    std::string text = replaced(soil, "*MAT_SOIL_AND_FOAM", keyword);
    text = replaced(text, "200,", "300,");
    const auto model = clean(text, "");
    const auto& law = std::get<model::SoilAndFoam>(model.materials[0].law);
    EXPECT_EQ(law.shear_modulus, 30);
    EXPECT_EQ(law.unloading_modulus, 300);
    EXPECT_EQ(law.yield, (std::array<double, 3>{0.5, 0.4, 0.03}));
    EXPECT_EQ(law.least_pressure, -0.2);
    EXPECT_TRUE(law.crushes);
    EXPECT_EQ(law.compression, (std::vector<double>{0, 0.05, 0.2, 0.4}));
    EXPECT_EQ(law.pressure, (std::vector<double>{0, 4, 10, 60}));
    EXPECT_NEAR(law.youngs_modulus, 9 * 300.0 * 30 / 930, 1e-12);
    EXPECT_NEAR(law.poissons_ratio, 840.0 / 1860, 1e-14);
  }
}

TEST(FoamMaterial, SoilByACurveOfEitherSign) {
  for (const char* points : {"0,0\n0.05,4\n0.4,60\n", "-0.4,60\n-0.05,4\n0,0\n", "0.05,4\n0.4,60\n"}) {
    const auto model = clean("*MAT_005\n1,1.8E-9,30,300,0.5,0.4,0.03,-0.2\n1,0,7\n",
                             std::string("*DEFINE_CURVE\n7\n") + points);
    const auto& law = std::get<model::SoilAndFoam>(model.materials[0].law);
    EXPECT_EQ(law.compression, (std::vector<double>{0, 0.05, 0.4}));
    EXPECT_EQ(law.pressure, (std::vector<double>{0, 4, 60}));
    EXPECT_FALSE(law.crushes);
  }
}

TEST(FoamMaterial, SoilFaults) {
  only_message(messages(soil, ""), "unloading gives more energy");
  const std::string stiff = replaced(soil, "200,", "300,");
  only_message(messages(replaced(stiff, "-0.2\n0", "0.2\n0"), ""), "field PC");
  only_message(messages(replaced(stiff, "0,0\n-0.05", "2,0\n-0.05"), ""), "field VCR");
  only_message(messages(replaced(stiff, "-0.05,-0.2", "0.05,0.2"), ""), "below zero in compression");
  only_message(messages(replaced(stiff, "4,10,60", "4,3,60"), ""), "must not fall");
  only_message(messages("*MAT_005\n1,1.8E-9,30,300,0.5,0.4,0.03,-0.2\n0,0\n", ""), "two points at least");
}

TEST(FoamMaterial, ViscousFoam) {
  for (const std::string keyword : {"*MAT_VISCOUS_FOAM", "*MAT_062"}) {
    const auto model = clean(keyword + "\n1,6E-11,0.0036,4,0.0015,100,0.2,0.05\n", "");
    const auto& law = std::get<model::ViscousFoam>(model.materials[0].law);
    EXPECT_EQ(law.youngs_modulus, 100);
    EXPECT_EQ(law.poissons_ratio, 0.05);
    EXPECT_EQ(law.elastic_modulus, 0.0036);
    EXPECT_EQ(law.elastic_exponent, 4);
    EXPECT_EQ(law.viscosity, 0.0015);
    EXPECT_EQ(law.viscosity_exponent, 0.2);
  }
  only_message(messages("*MAT_062\n1,6E-11,0,4,0.0015,100,0.2,0.05\n", ""), "field E1");
  only_message(messages("*MAT_062\n1,6E-11,1,4,-1,100,0.2,0.05\n", ""), "field V2");
}

const std::string test_curve = "*DEFINE_CURVE\n7\n-5.0,-120.0\n0.0,0.0\n10.0,100.0\n";

TEST(FoamMaterial, SimplifiedRubber) {
  for (const std::string keyword : {"*MAT_SIMPLIFIED_RUBBER/FOAM", "*MAT_181"}) {
    const auto model = clean(keyword + "\n1,1.1E-9,2000,0.2\n10,2,5,7\n", test_curve);
    const auto& law = std::get<model::SimplifiedRubber>(model.materials[0].law);
    EXPECT_FALSE(law.is_foam);
    EXPECT_EQ(law.bulk_modulus, 2000);
    EXPECT_EQ(law.damping, 0.2);
    EXPECT_EQ(law.stretch, (std::vector<double>{0.5, 1, 2}));
    EXPECT_EQ(law.stress, (std::vector<double>{-12, 0, 10}));
    EXPECT_EQ(law.youngs_modulus, 24);
    EXPECT_NEAR(law.poissons_ratio, 0.5 - 0.002, 1e-15);
  }
  const auto model = clean("*MAT_181\n1,1.1E-10,0\n1,1,1,7,0,0,0,0.1\n0,1\n",
                           "*DEFINE_CURVE\n7\n-0.5,-120.0\n0.0,0.0\n1.0,100.0\n");
  const auto& law = std::get<model::SimplifiedRubber>(model.materials[0].law);
  EXPECT_TRUE(law.is_foam);
  EXPECT_EQ(law.poissons_ratio, 0.1);
  EXPECT_EQ(law.damping, 0.1);
}

TEST(FoamMaterial, SimplifiedRubberFaults) {
  const std::string rubber = "*MAT_181\n1,1.1E-9,2000\n10,2,5,7\n";
  only_message(messages(replaced(rubber, "2000", "0"), test_curve), "field KM");
  only_message(messages(replaced(rubber, "2000", "5"), test_curve), "more than a third");
  only_message(messages(replaced(rubber, "2000", "2000,0,0.1"), test_curve), "field G:");
  only_message(messages(replaced(rubber, "5,7", "5,7,0,0,0,0.7"), test_curve), "field PR");
  only_message(messages(replaced(rubber, "10,2,5", "0,2,5"), test_curve), "field SGL");
  only_message(messages(rubber + "8\n", test_curve), "field LCUNLD");
  only_message(messages(rubber, replaced(test_curve, "-5.0,", "-15.0,")), "must go from compression");
  only_message(messages(rubber, replaced(test_curve, "0.0,0.0", "1.0,0.0")), "must go from compression");
  only_message(messages(rubber, "*DEFINE_TABLE\n7\n0.1\n*DEFINE_CURVE\n8\n-1,-1\n0,0\n1,1\n"),
               "a table of curves by strain rate is not supported");
}

const std::string yields =
    "*DEFINE_CURVE\n21\n0.0,0.5\n1.0,2.0\n*DEFINE_CURVE\n22\n0.0,0.6\n1.2,2.5\n"
    "*DEFINE_CURVE\n23\n5.0,1.0\n50.0,1.5\n";
const std::string bilkhu_dubois = "*MAT_BILKHU/DUBOIS_FOAM\n1,6E-11,40,21,22,0.2,0.1,0\n0,0,23,0.1\n";

TEST(FoamMaterial, BilkhuDubois) {
  for (const std::string keyword : {"*MAT_BILKHU/DUBOIS_FOAM", "*MAT_075", "*MAT_75"}) {
    const auto model = clean(replaced(bilkhu_dubois, "*MAT_BILKHU/DUBOIS_FOAM", keyword), yields);
    const auto& law = std::get<model::BilkhuDuboisFoam>(model.materials[0].law);
    EXPECT_EQ(law.youngs_modulus, 40);
    EXPECT_EQ(law.poissons_ratio, 0.1);
    EXPECT_EQ(law.damping, 0.2);
    EXPECT_EQ(law.tension_pressure, 0.1);
    EXPECT_EQ(law.pressure.abscissa, (std::vector<double>{0, 1}));
    EXPECT_EQ(law.pressure.ordinate, (std::vector<double>{0.5, 2}));
    EXPECT_EQ(law.uniaxial.ordinate, (std::vector<double>{0.6, 2.5}));
    // Constant before the first rate.
    EXPECT_EQ(law.rate_factor.abscissa, (std::vector<double>{0, 5, 50}));
    EXPECT_EQ(law.rate_factor.ordinate, (std::vector<double>{1, 1, 1.5}));
  }
  const auto model = clean("*MAT_075\n1,6E-11,40,21,22,0,0,0.3\n\n", yields);
  const auto& law = std::get<model::BilkhuDuboisFoam>(model.materials[0].law);
  EXPECT_EQ(law.tension_pressure_share, 0.3);
  EXPECT_EQ(law.poissons_ratio, 0);
  EXPECT_TRUE(law.rate_factor.abscissa.empty());
  const auto by_stress = clean("*MAT_075\n1,6E-11,40,21,22\n0.2,0.5\n", yields);
  EXPECT_EQ(std::get<model::BilkhuDuboisFoam>(by_stress.materials[0].law).tension_stress, 0.2);
  EXPECT_EQ(std::get<model::BilkhuDuboisFoam>(by_stress.materials[0].law).tension_stress_share, 0.5);
}

TEST(FoamMaterial, BilkhuDuboisFaults) {
  const auto with = [](const std::string& from, const std::string& to) {
    return messages(replaced(bilkhu_dubois, from, to), yields);
  };
  only_message(with("0,0,23,0.1", "0,0,23,0.5"), "field PR");
  only_message(with("0,0,23,0.1", "0,0,24,0.1"), "the deck has no curve 24");
  only_message(with("0,0,23,0.1", "0,0,23,0.1,12"), "field KCON");
  only_message(with("0,0,23,0.1", "0,0,23,0.1,0,1"), "field ISFLG");
  only_message(with("0,0,23,0.1", "0,0,23,0.1,0,0,12"), "field NCYCLE");
  only_message(with("0,0,23,0.1", "0,1.5,23,0.1"), "field VTSC");
  only_message(with("0,0,23,0.1", "0.2,0,23,0.1"), "the lower one counts");
  only_message(with("21,22,", "0,22,"), "field LCPY");
  only_message(with("21,22,", "21,25,"), "the deck has no curve 25");
  only_message(messages(bilkhu_dubois, replaced(yields, "0.0,0.6", "-0.1,0.2\n0.0,0.6")), "part in tension");
  only_message(messages(bilkhu_dubois, replaced(yields, "0.0,0.5", "0.0,-0.5")), "field LCPY");
  only_message(messages(bilkhu_dubois, replaced(yields, "1.0,2.0", "1.0,0.6")),
               "no ellipse goes through both unless the pressure is above a third");
  only_message(messages(bilkhu_dubois, replaced(yields, "50.0,1.5", "50.0,0.0")), "field LCRATE");
  only_message(messages("*MAT_075\n1,6E-11,40,21,22\n0.7\n", yields), "stays below that in compression");
}

}  // namespace
}  // namespace crumple::deck::test::foam_materials_test
