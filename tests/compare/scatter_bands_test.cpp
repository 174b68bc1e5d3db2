// SPDX-License-Identifier: BSD-3-Clause
#include "compare/scatter_bands.hpp"
#include "compare/comparison.hpp"
#include "compare/curves/quantity_names.hpp"

#include <gtest/gtest.h>

namespace crumple::compare::scatter_bands_test {
namespace {

CurveSet one_curve(double slope) {
  CurveSet set;
  set.curves.push_back({"glstat", "kinetic", "", false, {0, 1, 2}, {0, slope, 2 * slope}});
  return set;
}

TEST(ScatterBands, QuantilesLieOnStraightLinesBetweenTheNumbers) {
  const std::vector<double> numbers{0, 10, 20, 30, 40};
  EXPECT_DOUBLE_EQ(quantile(numbers, 0.5), 20);
  EXPECT_DOUBLE_EQ(quantile(numbers, 0.05), 2);
  EXPECT_DOUBLE_EQ(quantile(numbers, 0.95), 38);
  EXPECT_DOUBLE_EQ(quantile({3}, 0.95), 3);
}

TEST(ScatterBands, BandOfRunsIsReadBackAndTellsWhatIsInside) {
  const std::vector<Band> bands =
      bands_of({one_curve(20), one_curve(0), one_curve(40), one_curve(10), one_curve(30)});
  ASSERT_EQ(bands.size(), 1U);
  EXPECT_EQ(bands[0].name, "glstat.kinetic");
  EXPECT_EQ(bands[0].runs, 5U);
  EXPECT_EQ(bands[0].first, (std::vector<double>{0, 20, 40}));
  EXPECT_DOUBLE_EQ(bands[0].p5[1], 2);
  EXPECT_DOUBLE_EQ(bands[0].p95[2], 76);
  EXPECT_DOUBLE_EQ(relative_width(bands[0]), 72.0 / 40);
  const std::vector<Band> again = read_bands(bands_csv(bands));
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again[0].p95, bands[0].p95);
  EXPECT_EQ(again[0].times, bands[0].times);
  EXPECT_DOUBLE_EQ(share_inside(again[0], one_curve(20).curves[0]).value(), 1);
  EXPECT_DOUBLE_EQ(share_inside(again[0], one_curve(50).curves[0]).value(), 1.0 / 3)
      << "all curves begin at zero";
}

TEST(ScatterBands, ATableOfSomethingElseHasNoBands) {
  EXPECT_TRUE(read_bands("time,kinetic\n0,1\n").empty());
  EXPECT_TRUE(read_bands("").empty());
}

TEST(ScatterBands, MediansAreCurvesWithTheirNames) {
  CurveSet set;
  set.curves.push_back({"rcforc", "fz", "3 first", false, {0, 1}, {0, 2}});
  set.curves.push_back({"glstat", "kinetic", "", false, {0, 1}, {5, 4}});
  const std::vector<Curve> medians = medians_of(bands_of({set, set}));
  ASSERT_EQ(medians.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(medians[i].group, set.curves[i].group);
    EXPECT_EQ(medians[i].quantity, set.curves[i].quantity);
    EXPECT_EQ(medians[i].item, set.curves[i].item);
    EXPECT_EQ(medians[i].values, set.curves[i].values);
  }
}

TEST(ScatterBands, ComparisonTellsHowLongTheOtherIsInTheBand) {
  const std::vector<CurveSet> runs{one_curve(20), one_curve(0), one_curve(40), one_curve(10), one_curve(30)};
  CurveSet reference;
  reference.bands = bands_of(runs);
  reference.curves = medians_of(reference.bands);
  const Comparison outside = compare(reference, one_curve(50), {});
  ASSERT_EQ(outside.curves.size(), 1U);
  EXPECT_DOUBLE_EQ(outside.curves[0].inside_band.value(), 1.0 / 3);
  EXPECT_FALSE(compare(one_curve(20), one_curve(50), {}).curves[0].inside_band.has_value());
}

TEST(ScatterBands, CurvesThatAreComputedOfOthersHaveBandsOfTheirOwn) {
  const auto force = [](double fx, double fy) {
    CurveSet set;
    set.curves.push_back({"rcforc", "fx", "3 first", false, {0}, {fx}});
    set.curves.push_back({"rcforc", "fy", "3 first", false, {0}, {fy}});
    set.curves.push_back({"rcforc", "fz", "3 first", false, {0}, {0}});
    add_derived_curves(set);
    return set;
  };
  const std::vector<Band> bands = bands_of({force(3, 4), force(-3, 4), force(3, -4)});
  ASSERT_EQ(bands.size(), 4U);
  EXPECT_EQ(bands[3].name, "rcforc.resultant[3 first]");
  EXPECT_DOUBLE_EQ(bands[3].p5[0], 5) << "the components scatter, their size does not";
  EXPECT_DOUBLE_EQ(bands[3].p95[0], 5);
}

TEST(ScatterBands, ACurveThatOneRunLacksHasNoBand) {
  EXPECT_TRUE(bands_of({one_curve(1), CurveSet{}}).empty());
  EXPECT_TRUE(bands_of({}).empty());
}

}  // namespace
}  // namespace crumple::compare::scatter_bands_test
