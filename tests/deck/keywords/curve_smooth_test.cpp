// SPDX-License-Identifier: BSD-3-Clause
// *DEFINE_CURVE_SMOOTH.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::curve_smooth_test {
namespace {

model::Curve curve_of(const std::string& card) {
  const model::Model model = read_with("*DEFINE_CURVE_SMOOTH\n" + card + "\n*LOAD_NODE_POINT\n5,1,5\n");
  return model.curves.empty() ? model::Curve{} : model.curves.at(0);
}

double area(const model::Curve& curve) {
  double sum = 0;
  for (std::size_t i = 1; i < curve.abscissa.size(); ++i)
    sum += 0.5 * (curve.ordinate[i] + curve.ordinate[i - 1]) * (curve.abscissa[i] - curve.abscissa[i - 1]);
  return sum;
}

TEST(CurveSmooth, VmaxFollowsFromTend) {
  const model::Curve curve = curve_of("5,0,-30,0.5,2.5,0.4");
  EXPECT_NEAR(area(curve), -30, 1e-12);
  EXPECT_EQ(curve.abscissa.front(), 0);
  EXPECT_EQ(curve.at(0.5), 0);
  EXPECT_NEAR(curve.at(1.5), -30 / 1.6, 1e-12);
  EXPECT_NEAR(curve.at(2.5), 0, 1e-12);
  // Half a cosine, to what a straight line over a 64th of it leaves.
  for (const double t : {0.61, 0.7, 0.83})
    EXPECT_NEAR(curve.at(t), -30 / 1.6 * 0.5 * (1 - std::cos(std::numbers::pi * (t - 0.5) / 0.4)), 6e-3) << t;
}

TEST(CurveSmooth, TendFollowsFromVmax) {
  const model::Curve curve = curve_of("5,0,12,0,0,0.25,10");
  EXPECT_NEAR(curve.abscissa.back(), 0.25 + 12 / 10.0, 1e-12);
  EXPECT_NEAR(area(curve), 12, 1e-12);
  // Two ramps and nothing between them.
  const model::Curve short_curve = curve_of("5,0,2.5,0,0,0.25,10");
  EXPECT_NEAR(area(short_curve), 2.5, 1e-12);
  EXPECT_NEAR(short_curve.abscissa.back(), 0.5, 1e-12);
}

TEST(CurveSmooth, WrongCards) {
  const auto refused = [](const std::string& card, const std::string& part) {
    SmallDeck deck;
    deck.more = "*DEFINE_CURVE_SMOOTH\n" + card + "\n";
    const std::string found = listed(read_deck_text(deck.text()).diagnostics);
    EXPECT_NE(found.find(part), std::string::npos) << found;
  };
  refused("5,0,12,0,0,0.25,0", "two of DIST, TEND and VMAX");
  refused("5,0,0,0,2,0.25,0", "two of DIST, TEND and VMAX");
  refused("5,0,12,0,1,0.75,0", "no time for two ramps");
  refused("5,0,1,0,0,0.25,10", "no time for two ramps");
  refused("5,0,12,0,2,0.25,10", "the area by TEND and VMAX is 17.5");
  refused("5,0,12,0,2,0,10", "TRISE");
}

}  // namespace
}  // namespace crumple::deck::test::curve_smooth_test
