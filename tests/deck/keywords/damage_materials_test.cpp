// SPDX-License-Identifier: BSD-3-Clause
// Cards of plasticity with damage.
#include <string>
#include <vector>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::damage_materials_test {
namespace {

model::Material material_of(const std::string& text) {
  SmallDeck deck;
  deck.material = text;
  return read_clean(deck.text()).materials.at(0);
}

model::PiecewiseLinearPlasticity law_of(const std::string& text) {
  return std::get<model::PiecewiseLinearPlasticity>(material_of(text).law);
}

TEST(DamageMaterial, WithEveryValue) {
  for (const std::string keyword : {"*MAT_PLASTICITY_WITH_DAMAGE", "*MAT_081"}) {
    const auto material =
        material_of(keyword + "\n1,7.83E-6,200,0.3,0.25,2.0,0.1,2e-4\n40,5,0,0,0.3,1,0,3\n0,0.1\n0.25,0.4\n");
    const auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
    EXPECT_EQ(material.least_step, 2e-4);
    EXPECT_EQ(law.cowper_symonds_rate, 40);
    EXPECT_EQ(law.cowper_symonds_exponent, 5);
    EXPECT_TRUE(law.viscoplastic);
    EXPECT_EQ(law.viscoplastic_base, 0.25);
    EXPECT_EQ(law.yield_stress.at(1), 0.4);
    EXPECT_EQ(law.failure_strain, 0.3);
    EXPECT_EQ(law.failed_points, 3);
    EXPECT_EQ(law.damage_strain, (std::vector<double>{0, 0.1, 0.3}));
    EXPECT_EQ(law.damage, (std::vector<double>{0, 0, 1}));
    EXPECT_TRUE(has_damage(law));
    EXPECT_FALSE(has_strain_limits(law));
  }
}

TEST(DamageMaterial, ByACurve) {
  const std::string curve = "*DEFINE_CURVE\n7\n0,0\n0.1,0.4\n0.2,1\n0.3,1\n";
  const auto behind = law_of("*MAT_081\n1,7.83E-6,200,0.3,0.25,2.0,0.05\n0,0,0,0,,,7,-60\n\n\n" + curve);
  EXPECT_EQ(behind.damage_strain, (std::vector<double>{0, 0.05, 0.05 + 0.1, 0.05 + 0.2}));
  EXPECT_EQ(behind.damage, (std::vector<double>{0, 0, 0.4, 1}));
  EXPECT_EQ(behind.failure_strain, 0.25);
  EXPECT_EQ(behind.failed_share, 0.6);
  const auto at_once = law_of("*MAT_081\n1,7.83E-6,200,0.3,0.25,2.0\n0,0,0,0,0.15,0,7\n\n\n" + curve);
  EXPECT_EQ(at_once.damage_strain, (std::vector<double>{0, 0.1, 0.2}));
  EXPECT_EQ(at_once.damage, (std::vector<double>{0, 0.4, 1}));
  EXPECT_EQ(at_once.failure_strain, 0.15);
}

TEST(DamageMaterial, WithoutDamage) {
  const std::string start = "*MAT_081\n1,7.83E-6,200,0.3,0.25,2.0,";
  const auto never = law_of(start + "1e12\n0,0,0,0,1e14,0,0,1\n");
  EXPECT_FALSE(has_damage(never));
  EXPECT_FALSE(has_strain_limits(never));
  EXPECT_EQ(never.failure_strain, 0);
  // Rupture before softening: the stress goes at once.
  const auto brittle = law_of(start + "0.3\n0,0,0,0,0.2\n");
  EXPECT_EQ(brittle.failure_strain, 0.2);
  EXPECT_EQ(brittle.damage, (std::vector<double>{0}));
  const auto messages = messages_of(start + "\n0,0,0,0,0.2\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("warning: *MAT_081 card 1 field EPPF"), std::string::npos) << messages[0];
}

}  // namespace
}  // namespace crumple::deck::test::damage_materials_test
