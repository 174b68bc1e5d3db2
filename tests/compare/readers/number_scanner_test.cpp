// SPDX-License-Identifier: BSD-3-Clause
#include "compare/readers/number_scanner.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace crumple::compare::number_scanner_test {
namespace {

TEST(NumberScanner, ReadsWhatFortranWrites) {
  const std::vector<double> numbers =
      take_numbers("  12 1.5E+03-2.25E-01 3.D2  .5 -7. 1.2345-101 1.2345+101-1.0000E+00 +4 end");
  EXPECT_EQ(numbers, (std::vector<double>{12, 1500, -0.225, 300, 0.5, -7, 1.2345e-101, 1.2345e101, -1, 4}));
}

TEST(NumberScanner, AMinusAfterANumberStartsTheNext) {
  EXPECT_EQ(take_numbers("1234567-1.0000E+00"), (std::vector<double>{1234567, -1}));
  // Three digits and a point are no exponent.
  EXPECT_EQ(take_numbers("1.5-101.5"), (std::vector<double>{1.5, -101.5}));
  EXPECT_EQ(take_numbers("1.5-12"), (std::vector<double>{1.5, -12}));
}

TEST(NumberScanner, StarsAreNoNumberButTakeAPlace) {
  const std::vector<double> numbers = take_numbers("1.0 ******** 2.0");
  ASSERT_EQ(numbers.size(), 3U);
  EXPECT_TRUE(std::isnan(numbers[1]));
}

TEST(NumberScanner, OtherTextStaysWhereItIs) {
  std::string_view text = " x  1.0";
  EXPECT_FALSE(take_number(text));
  EXPECT_EQ(text, " x  1.0");
  EXPECT_FALSE(only_number("1.0 kg"));
  EXPECT_FALSE(only_number(""));
  EXPECT_FALSE(only_number("-"));
  EXPECT_EQ(only_number(" 2.5e-3 "), 0.0025);
  EXPECT_TRUE(std::isinf(*only_number("1e999")));
  EXPECT_EQ(only_number("1e-999"), 0.0);
}

TEST(NumberScanner, LinesEndInEitherWay) {
  std::string_view text = "a\r\nb\n\nc";
  EXPECT_EQ(take_line(text), "a");
  EXPECT_EQ(take_line(text), "b");
  EXPECT_EQ(take_line(text), "");
  EXPECT_EQ(take_line(text), "c");
  EXPECT_TRUE(text.empty());
}

}  // namespace
}  // namespace crumple::compare::number_scanner_test
