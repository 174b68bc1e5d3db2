// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ISOTROPIC_ELASTIC_FAILURE, *MAT_PLASTICITY_COMPRESSION_TENSION.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::failing_materials_test {
namespace {

const std::string metal = "\n1,7.83E-9,80000,250,1000,170000\n";

TEST(IsotropicFailure, EveryField) {
  for (const std::string keyword : {"*MAT_ISOTROPIC_ELASTIC_FAILURE", "*MAT_013", "*MAT_13"}) {
    const auto law = law_of_cube<model::FailingSolid>(keyword + metal + "0.2,-900\n");
    EXPECT_NEAR(law.youngs_modulus, 9 * 170000.0 * 80000 / (3 * 170000 + 80000), 1e-9);
    EXPECT_NEAR(law.youngs_modulus / (2 * (1 + law.poissons_ratio)), 80000, 1e-9);
    EXPECT_EQ(law.yield_stress, 250);
    EXPECT_EQ(law.hardening, 1000);
    EXPECT_EQ(law.failure_strain, 0.2);
    EXPECT_EQ(law.failure_pressure, -900);
    EXPECT_FALSE(law.keeps_failed);
  }
}

TEST(IsotropicFailure, Removal) {
  const auto read = [](const std::string& failure) {
    CubeDeck deck;
    deck.material = "*MAT_013" + metal + failure;
    return read_clean(deck.text()).materials.at(0);
  };
  const auto keeps = [](const model::Material& material) {
    return std::get<model::FailingSolid>(material.law).keeps_failed;
  };
  EXPECT_TRUE(keeps(read("0.2,-900,1\n")));
  EXPECT_EQ(read("0.2,-900,1\n").least_step, 0);
  EXPECT_TRUE(keeps(read("0.2,-900,0,1E-7\n")));
  EXPECT_EQ(read("0.2,-900,0,1E-7\n").least_step, 1e-7);
  EXPECT_FALSE(keeps(read("0.2,-900,0,1E20\n")));
  // Numbers that stand for none.
  const auto none = std::get<model::FailingSolid>(read("1E20,-1E20\n").law);
  EXPECT_EQ(none.failure_strain, 0);
  EXPECT_EQ(none.failure_pressure, 0);
}

TEST(IsotropicFailure, Faults) {
  const auto expect = [](const std::string& material, const std::string& text) {
    only_message(messages_of_cube(material), text);
  };
  expect("*MAT_013" + metal + "0.2\n", "field PRF");
  expect("*MAT_013" + metal + "0.2,5\n", "a pressure not above zero");
  expect("*MAT_013" + metal + "-0.2,-5\n", "field EPF");
  expect("*MAT_013" + metal + "0.2,-5,0,-1\n", "field TREM");
  expect("*MAT_013" + replaced(metal, "170000", "50000") + "0.2,-5\n", "field BULK");
  expect("*MAT_013" + replaced(metal, "250", "0") + "0.2,-5\n", "field SIGY");
  only_message(messages_of("*MAT_013" + metal + "0.2,-5\n"), "is there for solids only");
}

const std::string curves = "*DEFINE_CURVE\n7\n0,50\n0.1,70\n0.2,90\n*DEFINE_CURVE\n8\n0,30\n0.1,45\n20,45\n";
const std::string two_sided = "\n1,1.1E-9,2000,0.4,100,3,0.8,1E-7\n7,8,0,0,2,0,0,0.5\n15,8\n";

CubeDeck cube(const std::string& material, const std::string& more = curves) {
  CubeDeck deck;
  deck.material = material;
  deck.more = more;
  return deck;
}

TEST(CompressionTension, EveryField) {
  for (const std::string keyword : {"*MAT_PLASTICITY_COMPRESSION_TENSION", "*MAT_124"}) {
    const auto model = read_clean(cube(keyword + two_sided).text());
    EXPECT_EQ(model.materials.at(0).least_step, 1e-7);
    const auto& law = std::get<model::CompressionTension>(model.materials[0].law);
    EXPECT_EQ(law.youngs_modulus, 2000);
    EXPECT_EQ(law.poissons_ratio, 0.4);
    EXPECT_EQ(law.cowper_symonds_rate, 100);
    EXPECT_EQ(law.cowper_symonds_exponent, 3);
    EXPECT_EQ(law.failure_strain, 0.8);
    EXPECT_EQ(law.compression_pressure, 15);
    EXPECT_EQ(law.tension_pressure, 8);
    // Continued with the last slope.
    ASSERT_EQ(law.compression_strain, (std::vector<double>{0, 0.1, 0.2, 10}));
    EXPECT_NEAR(law.compression_stress[3], 90 + 200 * 9.8, 1e-9);
    EXPECT_EQ(law.tension_strain, (std::vector<double>{0, 0.1, 20}));
    EXPECT_EQ(law.tension_stress, (std::vector<double>{30, 45, 45}));
  }
  // Of shells, too; the last cards may be missing.
  SmallDeck shells;
  shells.material = "*MAT_124\n1,1.1E-9,2000,0.4\n7,8\n";
  shells.more = curves;
  const auto law = std::get<model::CompressionTension>(read_clean(shells.text()).materials.at(0).law);
  EXPECT_EQ(law.failure_strain, 0);
  EXPECT_EQ(law.compression_pressure, 0);
}

TEST(CompressionTension, Faults) {
  const auto expect = [](const std::string& old, const std::string& value, const std::string& text) {
    expect_one(cube("*MAT_124" + replaced(two_sided, old, value)), text);
  };
  expect(",0.8,", ",-1,", "failure routine of the user");
  expect(",3,0.8", ",0,0.8", "field P:");
  expect("\n7,8,", "\n0,8,", "field LCIDC");
  expect("\n7,8,", "\n7,0,", "field LCIDT");
  expect("\n7,8,", "\n9,8,", "the deck has no curve 9");
  expect("7,8,0,0,2", "7,8,5,0,2", "field LCSRC");
  expect("7,8,0,0,2", "7,8,0,5,2", "field LCSRT");
  expect("7,8,0,0,2", "7,8,0,0,3", "field SRFLAG");
  expect("7,8,0,0,2,0", "7,8,0,0,2,5", "field LCFAIL");
  expect("7,8,0,0,2,0,0", "7,8,0,0,2,0,500", "field EC");
  expect("\n15,8", "\n-15,8", "field PC");
  expect("\n15,8", "\n15,-8", "field PT");
  expect("\n15,8\n", "\n15,8,0,0,1\n", "field PCUTF");
  expect("\n15,8\n", "\n15,8,0,0,0,2\n", "field SCALEC");
  expect("\n15,8\n", "\n15,8,0,0,0,0,2\n", "field SCALET");
  expect("\n15,8\n", "\n15,8,0,0,0,0,0,5\n", "field SRFILT");
  expect("\n15,8\n", "\n15,8\n100\n", "field K");
  expect("\n15,8\n", "\n15,8\n0\n5,0\n", "field GI");
}

}  // namespace
}  // namespace crumple::deck::test::failing_materials_test
