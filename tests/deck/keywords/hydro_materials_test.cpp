// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ELASTIC_PLASTIC_HYDRO, *MAT_ELASTIC_PLASTIC_HYDRO_SPALL.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::hydro_materials_test {
namespace {

constexpr const char* polynomial = "*EOS_LINEAR_POLYNOMIAL\n4,0,140,0,0,2,2,0\n0,1\n";

CubeDeck cube(const std::string& material, const char* eos = "4") {
  CubeDeck deck;
  deck.material = material;
  deck.more = polynomial;
  deck.part = std::string("*PART\nblock\n1,1,1,") + eos + "\n";
  return deck;
}
model::HydroPlasticity law_of(const std::string& material) {
  return std::get<model::HydroPlasticity>(read_clean(cube(material).text()).materials.at(0).law);
}

const std::string line = "\n1,8.93E-6,46.0,0.12,0.5,-1.2,0.8,3.0\n";
const std::string spall = "0.02,0.004,3\n";
const std::string points =
    "0,0.01,0.02,0.03,0.04,0.05,0.06,0.07\n0.08,0.09,0.1,0.11,0.12,0.13,0.14,0.15\n"
    "1,2,3,4,5,6,7,8\n9,10,11,12,13,14,15,16\n";

TEST(HydroMaterial, EveryFieldOfTheLine) {
  for (const std::string keyword : {"*MAT_ELASTIC_PLASTIC_HYDRO", "*MAT_010", "*MAT_10"})
    for (const std::string rest : {"", "\n\n\n\n"}) {
      const auto model = read_clean(cube(keyword + line + rest).text());
      EXPECT_EQ(model.materials.at(0).density, 8.93e-6);
      const auto& law = std::get<model::HydroPlasticity>(model.materials[0].law);
      EXPECT_EQ(law.shear_modulus, 46);
      EXPECT_EQ(law.plastic_strain, std::vector<double>{0});
      EXPECT_EQ(law.yield_stress, std::vector<double>{0.12});
      EXPECT_EQ(law.hardening, 0.5);
      EXPECT_EQ(law.least_pressure, -1.2);
      EXPECT_EQ(law.spall, model::Spall::None);
      EXPECT_EQ(law.failure_strain, 0.8);
      EXPECT_EQ(law.pressure_factor, 0);
      // Of G and the equation of state.
      EXPECT_NEAR(law.youngs_modulus, 9 * 140.0 * 46 / (3 * 140 + 46), 1e-12);
      EXPECT_NEAR(law.youngs_modulus / (2 * (1 + law.poissons_ratio)), 46, 1e-12);
    }
}

TEST(HydroMaterial, EveryFieldOfSpall) {
  for (const std::string keyword : {"*MAT_ELASTIC_PLASTIC_HYDRO_SPALL", "*MAT_010_SPALL"}) {
    const auto law = law_of(keyword + line + spall);
    EXPECT_EQ(law.yield_stress, std::vector<double>{0.12});
    EXPECT_EQ(law.pressure_factor, 0.02);
    EXPECT_EQ(law.pressure_square, 0.004);
    EXPECT_EQ(law.spall, model::Spall::Pressure);
  }
  const auto spall_of = [](const std::string& number) {
    return law_of("*MAT_010_SPALL" + line + replaced(spall, ",3", "," + number)).spall;
  };
  EXPECT_EQ(spall_of("0"), model::Spall::None);
  EXPECT_EQ(spall_of("1"), model::Spall::None);
  EXPECT_EQ(spall_of("2"), model::Spall::Stress);
}

TEST(HydroMaterial, EveryPointOfTheTable) {
  const auto expect = [](const model::HydroPlasticity& law) {
    ASSERT_EQ(law.plastic_strain.size(), 16U);
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_EQ(law.plastic_strain[i], static_cast<double>(i) / 100.0);
      EXPECT_EQ(law.yield_stress[i], static_cast<double>(i + 1));
    }
    EXPECT_EQ(law.hardening, 0);
  };
  expect(law_of("*MAT_010" + line + points));
  expect(law_of("*MAT_010_SPALL" + line + "0,0,2\n" + points));
  // Ten points.
  const auto law =
      law_of("*MAT_010" + line + "0,0.01,0.02,0.03,0.04,0.05,0.06,0.07\n0.08,0.09\n1,2,3,4,5,6,7,8\n9,10\n");
  EXPECT_EQ(law.plastic_strain.size(), 10U);
  EXPECT_EQ(law.yield_stress.back(), 10);
}

TEST(HydroMaterial, SeveralUnderOneKeyword) {
  const std::string second = replaced(line.substr(1), "1,", "2,");
  const auto model =
      read_clean(cube("*MAT_010" + line + "\n\n\n\n" + second + "0,0.1\n\n0.2,0.3\n\n").text());
  ASSERT_EQ(model.materials.size(), 2U);
  EXPECT_EQ(std::get<model::HydroPlasticity>(model.materials[1].law).yield_stress,
            (std::vector<double>{0.2, 0.3}));
}

TEST(HydroMaterial, StrengthByPressureAlone) {
  const auto law = law_of("*MAT_010_SPALL" + replaced(line, "0.12", "0") + spall);
  EXPECT_EQ(law.yield_stress, std::vector<double>{0});
}

TEST(HydroMaterial, Faults) {
  const auto expect = [](const std::string& material, const std::string& text) {
    expect_one(cube(material), text);
  };
  const std::string plain = "*MAT_010" + line;
  expect(replaced(plain, "46.0", "0"), "field G");
  expect(replaced(plain, "0.12", "0"), "field SIGY");
  expect(replaced(plain, ",0.5,", ",-0.5,"), "field EH");
  expect(replaced(plain, "-1.2", "1.2"), "field PC");
  expect(replaced(plain, "0.8", "-0.8"), "field FS");
  expect("*MAT_010_SPALL" + line + "0,0,4\n", "field SPALL");
  expect("*MAT_010_SPALL" + line + "0.1,0,2\n" + points, "field A1");
  expect("*MAT_010_SPALL" + line + "0,0.1,2\n" + points, "field A2");
  expect(plain + replaced(points, "0,0.01", "0.001,0.01"), "field EPS1");
  expect(plain + replaced(points, "0.09", "0.01"), "field EPS10");
  expect(plain + replaced(points, ",7,", ",0,"), "field ES7");
  expect(plain + replaced(points, ",16", ",14"), "field ES16");
  expect(plain + "\n\n1\n\n", "one point of EPS and ES");
}

TEST(HydroMaterial, NeedsAnEquationOfStateAndSolids) {
  CubeDeck without = cube("*MAT_010" + line, "0");
  without.more = "";
  expect_one(without, "solids of *MAT_010 have no other pressure");
  SmallDeck shells;
  shells.material = "*MAT_010" + line;
  expect_one(shells, "is there for solids only");
}

}  // namespace
}  // namespace crumple::deck::test::hydro_materials_test
