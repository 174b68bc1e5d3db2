// SPDX-License-Identifier: BSD-3-Clause
#include "deck/build/units.hpp"

#include <cmath>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::units_test {
namespace {

struct Solid {
  const char* name;
  double density;  ///< [kg/m^3]
  double modulus;  ///< [Pa]
  bool yields;     ///< is modelled by a plastic law, too
};

// Handbook values, to a digit or two: the lightest, heaviest, softest, stiffest that shells are made of.
constexpr Solid solids[] = {
    {"steel", 7830, 2.07e11, true},
    {"aluminium", 2700, 7e10, true},
    {"magnesium", 1780, 4.5e10, true},
    {"titanium", 4430, 1.14e11, true},
    {"lead", 11340, 1.6e10, true},
    {"tungsten", 19300, 4.1e11, true},
    {"beryllium", 1850, 3.0e11, true},
    {"ABS", 1050, 2.3e9, true},
    {"soft polyethylene", 920, 2e8, true},
    {"rubber hose", 1200, 1e7, true},
    {"expanded polypropylene", 50, 1e7, true},
    {"soft foam", 30, 2e5, true},
    {"structural foam", 80, 1e8, true},
    {"aluminium foam", 400, 3e9, true},
    {"oak", 700, 1.1e10, true},
    {"steel, mass scaled a hundred times", 7.83e5, 2.07e11, true},
    {"polypropylene with ten times its mass", 9000, 1.2e9, true},
    {"balsa", 155, 4e9, false},
    {"glass", 2500, 7e10, false},
    {"alumina", 3950, 3.9e11, false},
    {"carbon fibres of high modulus", 2150, 9e11, false},
    {"diamond", 3520, 1.05e12, false},
    {"airbag fabric", 800, 2e8, false},
    {"rubber", 1100, 1e6, false},
    {"bitumen layer", 2400, 1e7, false},
    {"gelatine", 1000, 1e5, false},
    {"soft tissue", 1050, 3e3, false},
};

struct Units {
  const char* name;
  double mass, length, time;  ///< in kg, m, s
};

constexpr Units units[] = {
    {"kg, m, s", 1, 1, 1},
    {"t, mm, s", 1e3, 1e-3, 1},
    {"kg, mm, ms", 1, 1e-3, 1e-3},
    {"g, mm, ms", 1e-3, 1e-3, 1e-3},
    {"g, cm, us", 1e-3, 1e-2, 1e-6},
    {"g, cm, s", 1e-3, 1e-2, 1},
    {"g, cm, ms", 1e-3, 1e-2, 1e-3},
    {"g, mm, s", 1e-3, 1e-3, 1},
    {"kg, mm, s", 1, 1e-3, 1},
    {"kg, cm, s", 1, 1e-2, 1},
    {"kg, cm, ms", 1, 1e-2, 1e-3},
    {"kg, cm, us", 1, 1e-2, 1e-6},
    {"t, m, s", 1e3, 1, 1},
    {"g, mm, us", 1e-3, 1e-3, 1e-6},
    {"lbf s^2/in, in, s", 4.448222 / 0.0254, 0.0254, 1},
    {"slug, ft, s", 4.448222 / 0.3048, 0.3048, 1},
    {"kgf s^2/mm, mm, s", 9806.65, 1e-3, 1},
};

model::Material in_units(const Solid& solid, const Units& u, bool plastic) {
  model::Material material;
  material.id = 1;
  material.density = solid.density * std::pow(u.length, 3) / u.mass;
  const double modulus = solid.modulus * u.length * u.time * u.time / u.mass;
  if (plastic)
    material.law = model::PlasticKinematic{.youngs_modulus = modulus, .poissons_ratio = 0.3};
  else
    material.law = model::Elastic{modulus, 0.3};
  return material;
}

TEST(Units, OfWhatThereIsAreNeverDoubted) {
  for (const Units& u : units)
    for (const Solid& solid : solids)
      for (const bool plastic : {false, true}) {
        if (plastic && !solid.yields) continue;
        model::Model model;
        model.materials = {in_units(solid, u, plastic)};
        EXPECT_EQ(unit_doubts(model)[0], "") << solid.name << " in " << u.name;
      }
}

TEST(Units, OfAMetalAreFoundInEverySystem) {
  for (const Units& u : units)
    for (const std::size_t metal : {0, 1, 2, 3}) {
      model::Model model;
      model.materials = {in_units(solids[metal], u, true)};
      EXPECT_EQ(guess_units(model), u.name) << solids[metal].name;
    }
}

/// Beside steel even gel may be given a plastic law.
TEST(Units, OfAMetalAreThoseOfTheRest) {
  for (const Units& u : units) {
    model::Model model;
    model.materials = {in_units(solids[0], u, true), in_units({"gel", 1000, 1e5, true}, u, true)};
    EXPECT_EQ(unit_doubts(model), (std::vector<std::string>{"", ""})) << u.name;
  }
  model::Model gel;
  gel.materials = {in_units({"gel", 1000, 1e5, true}, units[0], true)};
  EXPECT_NE(unit_doubts(gel)[0], "") << "alone it is more likely a mistake";
}

TEST(Units, ThatDoNotGoTogetherAreToldWithTheirPlace) {
  const auto messages = messages_of("*MAT_ELASTIC\n1,7850.0,210000.0,0.3\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0],
            "deck.k:21: warning: *MAT_ELASTIC card 1: the density 7850 and the modulus 210000 go together in "
            "no usual system of units; steel has the density 7.83e+03 where its modulus is 2.07e+11 (kg, m, "
            "s), and 7.83e-09 where it is 2.07e+05 (t, mm, s)");
}

TEST(Units, UsualMistakesAreFound) {
  for (const char* numbers : {
           "7850.0,210000.0",   // kg/m^3 with MPa
           "2700.0,70000.0",    // the same of aluminium
           "7850.0,210.0",      // kg/m^3 with GPa
           "7.85E-9,210.0",     // t/mm^3 with GPa
           "7.85E-6,210000.0",  // kg/mm^3 with MPa
           "2.7E-6,70000.0",    // the same of aluminium
           "7.85E-6,2.1E11",    // kg/mm^3 with Pa
           "7.85E-9,2.1E11",    // t/mm^3 with Pa
       })
    EXPECT_EQ(messages_of(std::string("*MAT_PLASTIC_KINEMATIC\n1,") + numbers + ",0.3,0.1\n\n").size(), 1U)
        << numbers;
}

/// An impactor of steel's stiffness has the density that gives it its mass; where both numbers point to one
/// system the message names it once.
TEST(Units, OfRigidBodiesMayHaveAnyDensity) {
  const auto messages = messages_of("*MAT_RIGID\n1,5.5E6,2.1E11,0.3\n\n\n");
  for (const std::string& message : messages)
    EXPECT_EQ(message.find("the density"), std::string::npos) << message;
  model::Model model;
  model.materials = {{.id = 1, .title = "", .density = 5.5e6, .law = model::Elastic{2.1e11, 0.3}}};
  const std::string doubt = unit_doubts(model)[0];
  EXPECT_NE(doubt.find("(kg, m, s)"), std::string::npos) << doubt;
  EXPECT_EQ(doubt.find("(kg, m, s)"), doubt.rfind("(kg, m, s)")) << doubt;
  model.materials[0].rigid.emplace();
  EXPECT_EQ(unit_doubts(model)[0], "");
}

/// Rubber that is written as a plastic that never yields, in t, mm and s.
TEST(Units, OfWhatNeverYieldsAreThoseOfElasticMaterials) {
  model::Model model;
  model.materials.resize(1);
  model.materials[0].density = 1.1e-9;
  const auto doubt = [&](double yield_stress) {
    model.materials[0].law =
        model::PlasticKinematic{.youngs_modulus = 1.0, .poissons_ratio = 0.49, .yield_stress = yield_stress};
    return unit_doubts(model)[0];
  };
  EXPECT_NE(doubt(0.1), "");
  EXPECT_EQ(doubt(1e20), "");
}

}  // namespace
}  // namespace crumple::deck::test::units_test
