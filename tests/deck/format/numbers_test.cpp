// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/numbers.hpp"

#include <gtest/gtest.h>

namespace crumple::deck::numbers_test {
namespace {

TEST(ParseReal, ReadsCAndFortranForms) {
  EXPECT_EQ(parse_real("1.5"), 1.5);
  EXPECT_EQ(parse_real("+1.5"), 1.5);
  EXPECT_EQ(parse_real("-.5"), -0.5);
  EXPECT_EQ(parse_real("5."), 5.0);
  EXPECT_EQ(parse_real("1.5e3"), 1500.0);
  EXPECT_EQ(parse_real("1.5E+3"), 1500.0);
  EXPECT_EQ(parse_real("1.5d3"), 1500.0);
  EXPECT_EQ(parse_real("1.5D-03"), 1.5e-3);
  EXPECT_EQ(parse_real("1.5+3"), 1500.0);
  EXPECT_EQ(parse_real("-1.5-3"), -1.5e-3);
  EXPECT_EQ(parse_real("7"), 7.0);
  EXPECT_EQ(parse_real("1.0E-400"), 0.0);
}

TEST(ParseReal, RefusesEverythingElse) {
  for (const char* text :
       {"",     "abc",     "nan",   "NaN", "inf", "-INF", "1.5e", "1.5e+", "1.2.3",   "1 2",
        "0x10", "1.5e3e2", "1e3+2", "+-1", "--1", ".",    "e5",   "1,5",   "1.0E400", "+"})
    EXPECT_EQ(parse_real(text), std::nullopt) << text;
}

TEST(ParseInteger, ReadsWholeNumbersInAnyForm) {
  EXPECT_EQ(parse_integer("12"), 12);
  EXPECT_EQ(parse_integer("-12"), -12);
  EXPECT_EQ(parse_integer("+12"), 12);
  EXPECT_EQ(parse_integer("2."), 2);
  EXPECT_EQ(parse_integer("0.000E+00"), 0);
  EXPECT_EQ(parse_integer("9223372036854775807"), 9223372036854775807);
}

TEST(ParseInteger, RefusesFractionsAndText) {
  for (const char* text : {"", "1.5", "abc", "+-1", "1e30", "99999999999999999999", "nan"})
    EXPECT_EQ(parse_integer(text), std::nullopt) << text;
}

}  // namespace
}  // namespace crumple::deck::numbers_test
