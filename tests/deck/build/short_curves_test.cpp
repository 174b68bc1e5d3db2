// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::short_curves_test {
namespace {

/// A curve to a time with an ordinate at its end; runs of the small deck end at 2.5.
std::string curve_to(const std::string& time, const std::string& last = "1") {
  return "*DEFINE_CURVE\n1\n0,0\n" + time + "," + last + "\n";
}

const std::string load = "*LOAD_NODE_POINT\n2,3,1,-5.0\n";

TEST(ShortCurves, AreWarnedOfOnce) {
  const auto found = messages_with(curve_to("2") + load + load);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("curve 1 ends at the time 2, and is used until 2.5"), std::string::npos)
      << found[0];
}

TEST(ShortCurves, MayEndWithTheRunOrWithZero) {
  EXPECT_TRUE(messages_with(curve_to("2.5") + load).empty());
  EXPECT_TRUE(messages_with(curve_to("2.4999999") + load).empty());
  EXPECT_TRUE(messages_with(curve_to("2", "0") + load).empty());
}

TEST(ShortCurves, FollowTheEndOfTheRunNotOfTheDeck) {
  ReadOptions options;
  options.end_time = 2;
  EXPECT_TRUE(messages_with(curve_to("2") + load, options).empty());
  options.end_time = 3;
  EXPECT_EQ(messages_with(curve_to("2.5") + load, options).size(), 1U);
}

TEST(ShortCurves, BeginWithTheArrivalOfPressure) {
  EXPECT_TRUE(messages_with(curve_to("2") + "*LOAD_SEGMENT\n1,0.5,0.5,1,2,3\n").empty());
  EXPECT_EQ(messages_with(curve_to("2") + "*LOAD_SEGMENT\n1,0.5,0.4,1,2,3\n").size(), 1U);
}

TEST(ShortCurves, BeginWithTheBirthOfMotionsAndEndWithTheirDeath) {
  const std::string motion = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,3,0,1,1,0,";
  EXPECT_EQ(messages_with(curve_to("2") + motion + "0,0\n").size(), 1U);
  EXPECT_TRUE(messages_with(curve_to("2") + motion + "0,0.5\n").empty());
  EXPECT_TRUE(messages_with(curve_to("2") + motion + "2,0\n").empty());
}

TEST(ShortCurves, OfDisplacementsStayWhereTheyCameTo) {
  EXPECT_TRUE(messages_with(curve_to("2") + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,3,2,1,1\n").empty());
}

}  // namespace
}  // namespace crumple::deck::test::short_curves_test
