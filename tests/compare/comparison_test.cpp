// SPDX-License-Identifier: BSD-3-Clause
#include "compare/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "base/error.hpp"
#include "compare/comparison_json.hpp"
#include "compare/comparison_page.hpp"
#include "compare/comparison_text.hpp"
#include "nlohmann/json.hpp"

namespace crumple::compare::comparison_test {
namespace {

using Names = std::vector<std::string>;

/// 401 points over the times from 0 to `end`.
Curve curve_of(const Curve& name, double end, const std::function<double(double)>& of) {
  Curve curve = name;
  for (int i = 0; i <= 400; ++i) append_point(curve, end * i / 400, of(end * i / 400));
  return curve;
}

Names names_of(const std::vector<ComparedCurve>& curves) {
  Names names;
  for (const ComparedCurve& curve : curves) names.push_back(name_of(curve.reference));
  return names;
}

double bump(double t) {
  return std::sin(std::numbers::pi * t);
}

CurveSet results(double factor) {
  CurveSet set;
  set.source = "results";
  set.curves = {
      curve_of({"glstat", "kinetic", ""}, 1, [=](double t) { return 1000 * (1 - factor * 0.5 * t); }),
      curve_of({"glstat", "internal", ""}, 1, [=](double t) { return factor * 500 * bump(t); }),
      curve_of({"glstat", "hourglass", ""}, 1, [=](double t) { return factor * factor * 0.1 * bump(t); }),
      curve_of({"rwforc", "fx", "3"}, 1, [=](double t) { return -factor * 7 * bump(t); })};
  return set;
}

TEST(Compare, TheSameResultsArePerfect) {
  const Comparison comparison = compare(results(1), results(1), {});
  EXPECT_EQ(comparison.curves.size(), 3U);
  for (const ComparedCurve& curve : comparison.curves) {
    EXPECT_EQ(curve.difference, 0);
    EXPECT_EQ(curve.relative, 0);
    EXPECT_NEAR(curve.errors.combined, 0, 1e-7);
    EXPECT_DOUBLE_EQ(curve.rating.rating, 1);
    EXPECT_EQ(curve.samples, 401U);
  }
  EXPECT_TRUE(comparison.within(0));
  EXPECT_TRUE(comparison.notes.empty());
}

TEST(Compare, TheWorstComesFirst) {
  const Comparison comparison = compare(results(1), results(1.1), {});
  // 0.05 of 1000, 0.1 of 500 and of 7.
  EXPECT_EQ(comparison.curves.back().reference.quantity, "kinetic");
  EXPECT_NEAR(comparison.curves.back().relative, 0.05, 1e-12);
  EXPECT_EQ(comparison.curves.back().time, 1);
  for (std::size_t place : {0U, 1U}) {
    EXPECT_NEAR(comparison.curves[place].relative, 0.1, 1e-12);
    EXPECT_NEAR(comparison.curves[place].time, 0.5, 1e-12);
    EXPECT_NEAR(comparison.curves[place].errors.magnitude, 0.1, 1e-12);
    // Warping of time finds equal values beside the peak: less is lost than the 0.2 of 10 % everywhere.
    EXPECT_GT(comparison.curves[place].rating.magnitude, 0.8);
    EXPECT_LT(comparison.curves[place].rating.magnitude, 1);
  }
  EXPECT_TRUE(comparison.within(0.11));
  EXPECT_FALSE(comparison.within(0.09));
}

TEST(Compare, WhatIsSmallBesideItsKindIsNotRated) {
  ComparisonSettings settings;
  EXPECT_EQ(names_of(compare(results(1), results(1.1), settings).negligible), (Names{"glstat.hourglass"}));
  settings.floor = 0;
  EXPECT_EQ(compare(results(1), results(1.1), settings).curves.front().reference.quantity, "hourglass");
  // Alone it is the largest of its kind.
  settings = {};
  settings.quantities = {"hourglass"};
  EXPECT_EQ(names_of(compare(results(1), results(1.1), settings).curves), (Names{"glstat.hourglass"}));
}

TEST(Compare, ZeroCurves) {
  CurveSet zero = results(1);
  for (Curve& curve : zero.curves) curve.values.assign(curve.values.size(), 0.0);
  EXPECT_EQ(compare(zero, zero, {}).negligible.size(), 4U);
  const Comparison from_zero = compare(zero, results(1), {});
  EXPECT_TRUE(std::isinf(from_zero.curves.front().relative));
  EXPECT_FALSE(from_zero.within(1e9));
  // Infinity has no place in JSON.
  const auto json = comparison_json(from_zero, zero, results(1), {});
  EXPECT_TRUE(nlohmann::ordered_json::parse(json.dump())["curves"][0]["relative"].is_null());
}

TEST(Compare, QuantitiesAreChosenByAnyOfTheirNames) {
  const auto chosen = [](const std::string& name) {
    ComparisonSettings settings;
    settings.quantities = {name};
    return names_of(compare(results(1), results(1), settings).curves);
  };
  EXPECT_EQ(chosen("fx"), (Names{"rwforc.fx[3]"}));
  EXPECT_EQ(chosen("rwforc"), (Names{"rwforc.fx[3]"}));
  EXPECT_EQ(chosen("glstat.kinetic"), (Names{"glstat.kinetic"}));
  EXPECT_EQ(chosen("rwforc.fx[3]"), (Names{"rwforc.fx[3]"}));
  EXPECT_EQ(chosen("nothing"), Names{});
}

TEST(Compare, WhatOnlyOneSideHasIsListed) {
  CurveSet less = results(1);
  less.curves.erase(less.curves.begin());
  less.curves[0].quantity = "other";
  const Comparison comparison = compare(results(1), less, {});
  EXPECT_EQ(comparison.only_reference, (Names{"glstat.kinetic", "glstat.internal"}));
  EXPECT_EQ(comparison.only_other, (Names{"glstat.other"}));
}

TEST(Compare, PairsBringDifferentNamesTogether) {
  CurveSet other = results(1);
  other.curves[3] = curve_of({"th", "wall 1 FNX", ""}, 1, [](double t) { return -7 * bump(t); });
  ComparisonSettings settings;
  settings.quantities = {"nothing else"};
  settings.pairs = {{"rwforc.fx[3]", "th.wall 1 FNX"}};
  const Comparison comparison = compare(results(1), other, settings);
  ASSERT_EQ(comparison.curves.size(), 1U);
  EXPECT_EQ(comparison.curves[0].relative, 0);
  EXPECT_EQ(comparison_json(comparison, results(1), other, settings)["curves"][0]["other_name"],
            "th.wall 1 FNX");
  settings.pairs = {{"rwforc.fx[3]", "th.wall 2 FNX"}};
  EXPECT_THROW(compare(results(1), other, settings), Error);
}

TEST(Compare, SumsAreComparedWithWhatOthersWriteAsOne) {
  const auto energy = [](const char* name, double size, bool derived) {
    Curve curve = curve_of({"glstat", name, ""}, 1, [=](double t) { return size * bump(t); });
    curve.derived = derived;
    return curve;
  };
  CurveSet ours;
  ours.curves = {energy("contact", 1, false), energy("friction", 2, false),
                 energy("sliding_interface", 3, true)};
  CurveSet theirs;
  theirs.curves = {energy("sliding_interface", 3, false)};
  EXPECT_EQ(names_of(compare(theirs, ours, {}).curves), (Names{"glstat.sliding_interface"}));
  // With the terms on both sides the sums say nothing more.
  EXPECT_EQ(names_of(compare(ours, ours, {}).curves), (Names{"glstat.contact", "glstat.friction"}));
}

TEST(Compare, AnInterfaceWithOneSideIsTheSameInBothSpellings) {
  CurveSet ours;
  ours.curves = {curve_of({"rcforc", "fx", "1 single"}, 1, bump)};
  CurveSet theirs;
  theirs.curves = {curve_of({"rcforc", "fx", "1 first"}, 1, bump)};
  EXPECT_EQ(compare(ours, theirs, {}).curves.size(), 1U);
  EXPECT_EQ(compare(theirs, ours, {}).curves.size(), 1U);
  EXPECT_TRUE(compare(theirs, ours, {}).only_other.empty());
}

TEST(Compare, PlacesGiveWayToDisplacements) {
  CurveSet set;
  set.curves = {curve_of({"nodout", "ux", "7"}, 1, bump),
                curve_of({"nodout", "x", "7"}, 1, [](double t) { return 100 + bump(t); }),
                curve_of({"nodout", "y", "7"}, 1, bump)};
  EXPECT_EQ(names_of(compare(set, set, {}).curves), (Names{"nodout.ux[7]", "nodout.y[7]"}));
}

TEST(Compare, TimesThatDifferAreSaid) {
  CurveSet longer;
  longer.curves = {curve_of({"glstat", "kinetic", ""}, 2, bump)};
  CurveSet shorter;
  shorter.curves = {curve_of({"glstat", "kinetic", ""}, 1, bump)};
  const Comparison comparison = compare(longer, shorter, {});
  EXPECT_EQ(comparison.curves[0].end, 1);
  ASSERT_EQ(comparison.notes.size(), 1U);
  EXPECT_NE(comparison.notes[0].find("goes on to 2 in the reference"), std::string::npos);
  CurveSet later;
  later.curves = {{"glstat", "kinetic", "", false, {5, 6}, {1, 1}}};
  EXPECT_TRUE(compare(longer, later, {}).curves.empty());
  EXPECT_NE(compare(longer, later, {}).notes[0].find("no common time"), std::string::npos);
}

TEST(Compare, TheFilterWorksOnBothOrOnNone) {
  const auto noisy = [](double phase) {
    CurveSet set;
    Curve curve{"rwforc", "fx", "1"};
    for (int i = 0; i <= 4000; ++i)
      append_point(curve, i * 1e-5,
                   bump(25 * i * 1e-5) + 0.5 * std::sin(2 * std::numbers::pi * 5000 * i * 1e-5 + phase));
    set.curves = {curve};
    return set;
  };
  ComparisonSettings settings;
  EXPECT_GT(compare(noisy(0), noisy(1), settings).curves[0].errors.combined, 0.1);
  settings.cfc = 60;
  // The rest is at the ends, which the filter keeps in their places.
  EXPECT_LT(compare(noisy(0), noisy(1), settings).curves[0].errors.combined, 0.05);
  CurveSet coarse;
  coarse.curves = {{"rwforc", "fx", "1", false, {0, 0.02, 0.04}, {0, 1, 0}}};
  const Comparison comparison = compare(noisy(0), coarse, settings);
  ASSERT_EQ(comparison.notes.size(), 1U);
  EXPECT_NE(comparison.notes[0].find("CFC 60"), std::string::npos);
  EXPECT_EQ(comparison.curves[0].reference.values, noisy(0).curves[0].values);
}

TEST(LargestDifference, LiesAtAPointOfEither) {
  const Curve flat{"a", "b", "", false, {0, 10}, {-2, -2}};
  const Curve peak{"a", "b", "", false, {0, 3, 4, 10}, {-2, 5, -2, -2}};
  const LargestDifference largest = largest_difference(flat, peak, 0, 10);
  EXPECT_EQ(largest.time, 3);
  EXPECT_EQ(largest.difference, 7);
  EXPECT_EQ(largest.peak, 2);
  // Only what lies between the two times counts; at their ends the lines are cut.
  EXPECT_NEAR(largest_difference(flat, peak, 3.5, 9).difference, 3.5, 1e-12);
  EXPECT_EQ(largest_difference(flat, peak, 3.5, 9).time, 3.5);
}

TEST(ComparisonTable, HasTheScoresAndASummary) {
  const Comparison comparison = compare(results(1), results(1.1), {});
  const std::string text = comparison_table(comparison, results(1), results(1.1), {0, 0.06, 0});
  EXPECT_NE(text.find("glstat.kinetic"), std::string::npos);
  EXPECT_NE(text.find("401 samples by linear interpolation"), std::string::npos);
  EXPECT_NE(text.find("excellent"), std::string::npos);
  EXPECT_NE(text.find("2 of them beyond 6 % of the peak"), std::string::npos);
  EXPECT_NE(text.find("glstat.hourglass"), std::string::npos);
  const std::string short_text = comparison_table(comparison, results(1), results(1.1), {1, std::nullopt, 0});
  EXPECT_NE(short_text.find("and 2 more"), std::string::npos);
  EXPECT_EQ(short_text.find("beyond"), std::string::npos);
}

TEST(ComparisonJson, HasAllScores) {
  const auto json = comparison_json(compare(results(1), results(1.1), {}), results(1), results(1.1), {});
  EXPECT_EQ(json["curves"].size(), 3U);
  const auto& worst = json["curves"][0];
  EXPECT_NEAR(worst["relative"].get<double>(), 0.1, 1e-12);
  EXPECT_NEAR(worst["sprague_geers"]["magnitude"].get<double>(), 0.1, 1e-12);
  EXPECT_EQ(worst["iso_18571"]["phase"], 1);
  EXPECT_EQ(worst["samples"], 401);
  EXPECT_NEAR(worst["interval"].get<double>(), 0.0025, 1e-15);
  EXPECT_EQ(json["not_rated"][0]["name"], "glstat.hourglass");
  EXPECT_TRUE(json["cfc"].is_null());
}

TEST(ComparisonPayload, KeepsPeaksOfLongCurves) {
  CurveSet set;
  Curve curve{"rwforc", "fx", "<1>"};
  for (int i = 0; i < 50000; ++i) append_point(curve, i, i == 33333 ? 99.0 : std::sin(0.01 * i));
  set.curves = {curve};
  const std::string text = comparison_payload(compare(set, set, {}), set, set, {}, 0.5);
  EXPECT_TRUE(text.starts_with("<script type=\"application/json\" id=\"crumple-comparison\">{"));
  const std::size_t start = text.find('{');
  const std::size_t end = text.rfind('}') + 1;
  // Nothing of the data may end the element.
  EXPECT_EQ(text.find('<', start), text.find("</script>", start));
  const auto json = nlohmann::json::parse(text.substr(start, end - start));
  EXPECT_EQ(json["curves"][0]["item"], "<1>");
  EXPECT_EQ(json["tolerance"], 0.5);
  const auto& times = json["drawn"][0]["reference"][0];
  const auto& values = json["drawn"][0]["reference"][1];
  EXPECT_EQ(times.size(), values.size());
  EXPECT_LE(times.size(), 1000U);
  EXPECT_NE(std::find(values.begin(), values.end(), 99.0), values.end());
}

}  // namespace
}  // namespace crumple::compare::comparison_test
