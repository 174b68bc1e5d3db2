// SPDX-License-Identifier: BSD-3-Clause
// What messages name instead of a keyword that is not supported.
#include "deck/keywords/nearest_keyword.hpp"

#include <gtest/gtest.h>

#include "deck/keywords/keywords.hpp"

namespace crumple::deck::test::nearest_keyword_test {
namespace {

TEST(NearestKeyword, OfMistypedNames) {
  EXPECT_EQ(nearest_keyword("DATABASE_RWFORCE").keyword, "DATABASE_RWFORC");
  EXPECT_EQ(nearest_keyword("ELEMENT_SHEL").keyword, "ELEMENT_SHELL");
  EXPECT_EQ(nearest_keyword("CONTACT_AUTOMATIC_SINGEL_SURFACE").keyword, "CONTACT_AUTOMATIC_SINGLE_SURFACE");
  EXPECT_EQ(advice_on("NODEE"), "; did you mean *NODE?");
  EXPECT_EQ(advice_on("DATABASE_D3PLOT"), "; did you mean *DATABASE_BINARY_D3PLOT?");
}

TEST(NearestKeyword, OfOtherLawsSaysWhatChanges) {
  for (const char* name : {"MAT_SOIL_AND_FOAM_FAILURE", "MAT_014", "MAT_014_TITLE"}) {
    const NearestKeyword nearest = nearest_keyword(name);
    EXPECT_EQ(nearest.keyword, "MAT_SOIL_AND_FOAM") << name;
    EXPECT_NE(nearest.change.find("strength in tension"), std::string::npos) << name;
  }
  // A number is no mistyped other number.
  EXPECT_EQ(nearest_keyword("MAT_025").keyword, "");
  EXPECT_NE(advice_on("DAMPING_STRUCTURAL").find("damps"), std::string::npos);
}

TEST(NearestKeyword, OfAFormWithMoreOptionsIsThatWithFewer) {
  EXPECT_EQ(nearest_keyword("LOAD_NODE_POINT_RAMPED").keyword, "LOAD_NODE_SET");
  EXPECT_EQ(nearest_keyword("HOURGLASS_SPECIAL").keyword, "HOURGLASS");
}

TEST(NearestKeyword, NoUnrelatedOne) {
  EXPECT_EQ(advice_on("BATTERY_ECHEM_CELL"), "");
}

TEST(NearestKeyword, IsItselfSupported) {
  for (const char* name : {"ELEMENT_SOLID_TET4TOTET10",
                           "MAT_014",
                           "MAT_034",
                           "MAT_058_SOLID",
                           "MAT_163",
                           "MAT_SIMPLIFIED_RUBBER_WITH_FAILURE",
                           "MAT_SPOTWELD_DAIMLERCHRYSLER",
                           "MAT_186",
                           "MAT_240",
                           "MAT_S06",
                           "MAT_ADD_DAMAGE_DIEM",
                           "ELEMENT_SEATBELT",
                           "PART_COMPOSITE_TSHELL",
                           "CONSTRAINED_JOINT_GEARS",
                           "CONSTRAINED_JOINT_REVOLUTE_FAILURE",
                           "AIRBAG_HYBRID",
                           "SECTION_SEATBELT",
                           "CONTACT_ENTITY",
                           "INTERFACE_SSI",
                           "DEFINE_FUNCTION",
                           "DEFORMABLE_TO_RIGID_AUTOMATIC",
                           "LOAD_BLAST",
                           "LOAD_BLAST_CLEARING",
                           "LOAD_BRODE",
                           "BOUNDARY_SPC_LOCAL",
                           "DEFINE_FRICTION_ORIENTATION"}) {
    const NearestKeyword nearest = nearest_keyword(name);
    EXPECT_TRUE(find_keyword(nearest.keyword)) << name << " " << nearest.keyword;
    EXPECT_FALSE(nearest.change.empty()) << name;
  }
}

TEST(FormatKeywords, AreKnown) {
  for (const char* name : {"PARAMETER", "PARAMETER_EXPRESSION", "INCLUDE", "END", "KEYWORD"})
    EXPECT_NE(find_format_keyword(name), nullptr) << name;
  EXPECT_EQ(find_format_keyword("NODE"), nullptr);
}

}  // namespace
}  // namespace crumple::deck::test::nearest_keyword_test
