// SPDX-License-Identifier: BSD-3-Clause
// *DEFINE_CURVE_FUNCTION.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "../small_deck.hpp"

namespace crumple::deck::test::curve_function_test {
namespace {

model::Curve curve_of(const std::string& function, const std::string& before = "") {
  const model::Model model =
      read_with(before + "*DEFINE_CURVE_FUNCTION\n         5\n" + function + "\n*LOAD_NODE_POINT\n5,1,5\n");
  return model.curves.empty() ? model::Curve{} : model.curves.at(0);
}

TEST(CurveFunction, FollowsTheFunctionBetweenItsPoints) {
  const model::Curve curve = curve_of("3*sin(2*pi*40*time)*exp(-TIME)");
  EXPECT_EQ(curve.abscissa.front(), 0);
  EXPECT_EQ(curve.abscissa.back(), 2.5);
  double worst = 0;
  for (int i = 0; i <= 9973; ++i) {
    const double t = 2.5 * i / 9973;
    worst = std::max(worst, std::fabs(curve.at(t) - 3 * std::sin(80 * std::numbers::pi * t) * std::exp(-t)));
  }
  EXPECT_LT(worst, 2e-4);
}

TEST(CurveFunction, StraightOnesStayCoarse) {
  const model::Curve curve = curve_of("1 + TIME / 2");
  EXPECT_LT(curve.abscissa.size(), 200U);
  EXPECT_NEAR(curve.at(1.0), 1.5, 1e-12);
}

TEST(CurveFunction, WholeNumbersAreReal) {
  EXPECT_NEAR(curve_of("1/2*TIME**2").at(2), 2, 1e-4);
}

TEST(CurveFunction, SeveralLinesAndParameters) {
  const model::Curve curve = curve_of("&rate*\nTIME + &low", "*PARAMETER\nR rate,4\nR low,-3\n");
  EXPECT_NEAR(curve.at(2), 5, 1e-12);
}

TEST(CurveFunction, WavesThatVanishAtEqualIntervalsAreSeen) {
  // Zero at all of 128 intervals of 2.5.
  const model::Curve curve = curve_of("sin(128*2*pi*TIME/2.5)");
  EXPECT_NEAR(curve.at(2.5 / 128 / 4), 1, 1e-3);
}

TEST(CurveFunction, FastOnesAreFollowedToTheEndOrRefused) {
  const model::Curve curve = curve_of("sin(1000*TIME)");
  double worst = 0;
  for (int i = 0; i <= 99991; ++i) {
    const double t = 2.5 * i / 99991;
    worst = std::max(worst, std::fabs(curve.at(t) - std::sin(1000 * t)));
  }
  EXPECT_LT(worst, 2e-5);
  const std::vector<std::string> refused = messages_with("*DEFINE_CURVE_FUNCTION\n5\nsin(1e6*TIME)\n");
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_NE(refused[0].find("changes too fast"), std::string::npos) << refused[0];
}

// Of an interval, 1/128 of the run, the ends and three places are seen; the widest gap, 0.29 of it, is passed
// by nothing as long as 1/440 of the run, wherever it begins.
TEST(CurveFunction, PulsesOfOnePartIn440AreSeen) {
  constexpr double interval = 2.5 / 128;
  for (const double begin : {40.001, 40.292, 40.502, 40.731}) {
    const double from = begin * interval;
    const double to = from + 2.5 / 440;
    const model::Curve curve = curve_of(fmt::format("sign(0.5, TIME-{}) + sign(0.5, {}-TIME)", from, to));
    EXPECT_NEAR(curve.at(0.5 * (from + to)), 1, 1e-9) << begin;
  }
}

TEST(CurveFunction, JumpsAreKept) {
  const model::Curve curve = curve_of("sign(1, TIME - 1.2345)");
  EXPECT_NEAR(curve.at(1.2344), -1, 1e-12);
  EXPECT_NEAR(curve.at(1.2346), 1, 1e-12);
}

TEST(CurveFunction, ParametersAreNumbersAsInFields) {
  EXPECT_NEAR(curve_of("&rate*TIME", "*PARAMETER\nR rate,1.5+3\n").at(2), 3000, 1e-9);
}

TEST(CurveFunction, ReachesTheEndOfTheRunNotOfTheDeck) {
  SmallDeck deck;
  deck.more = "*DEFINE_CURVE_FUNCTION\n5\nTIME\n*LOAD_NODE_POINT\n5,1,5\n";
  ReadOptions options;
  options.end_time = 10;
  const ReadResult result = read_deck_text(deck.text(), options);
  ASSERT_TRUE(result.model.has_value());
  EXPECT_NEAR(result.model->curves.at(0).at(8), 8, 1e-12);
}

}  // namespace
}  // namespace crumple::deck::test::curve_function_test
