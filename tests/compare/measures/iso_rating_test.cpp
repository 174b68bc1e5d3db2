// SPDX-License-Identifier: BSD-3-Clause
#include "compare/measures/iso_rating.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace crumple::compare::iso_rating_test {
namespace {

using std::numbers::pi;

using Function = std::function<double(double)>;

/// At t = i / count.
std::vector<double> samples(std::size_t count, const Function& of) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = of(static_cast<double>(i) / static_cast<double>(count));
  return values;
}

TEST(IsoRating, IdenticalCurvesArePerfect) {
  for (const Function& of : {Function([](double t) { return std::sin(7 * t); }),
                             Function([](double t) { return t < 0.5 ? 0.0 : t - 0.5; }),
                             Function([](double) { return 2.0; }), Function([](double) { return 0.0; })}) {
    const auto curve = samples(300, of);
    const IsoRating rating = iso_rating(curve, curve);
    EXPECT_EQ(rating.corridor, 1);
    EXPECT_EQ(rating.phase, 1);
    EXPECT_EQ(rating.magnitude, 1);
    EXPECT_EQ(rating.slope, 1);
    EXPECT_DOUBLE_EQ(rating.rating, 1);
    EXPECT_EQ(rating.shift, 0);
    EXPECT_EQ(grade_of(rating.rating), std::string("excellent"));
  }
}

// A constant next to a constant: no shift, no slope, the distance of 0.2 of the norm everywhere. Time warping
// changes nothing: E_M = 1 - 0.2 / 0.5.
TEST(IsoRating, ScoresOfConstants) {
  const IsoRating rating = iso_rating(std::vector<double>(100, 1.0), std::vector<double>(100, 1.2));
  EXPECT_NEAR(rating.corridor, std::pow((0.5 - 0.2) / 0.45, 2), 1e-12);
  EXPECT_EQ(rating.phase, 1);
  EXPECT_NEAR(rating.magnitude, 0.6, 1e-12);
  EXPECT_EQ(rating.slope, 1);
  EXPECT_NEAR(rating.rating, 0.4 * 4.0 / 9.0 + 0.2 * 2.6, 1e-12);
}

// An energy that is conserved, and the same with six digits: noise has no phase and no slope.
TEST(IsoRating, RoundingOfAConstantIsNoDifference) {
  const auto exact = samples(300, [](double t) { return 43835.67 + 0.02 * std::sin(50 * t); });
  const auto rounded = samples(300, [](double t) { return 43835.7 + 0.05 * std::cos(333 * t); });
  const IsoRating rating = iso_rating(exact, rounded);
  EXPECT_EQ(rating.shift, 0);
  EXPECT_EQ(rating.slope, 1);
  EXPECT_GT(rating.rating, 0.9999);
}

TEST(IsoRating, CorridorsAreFiveAndFiftyPercentOfThePeak) {
  const std::vector<double> reference(100, -2.0);
  const auto corridor = [&](double distance) {
    return iso_rating(reference, std::vector<double>(100, -2.0 + distance)).corridor;
  };
  EXPECT_EQ(corridor(0.099), 1);
  EXPECT_NEAR(corridor(0.55), 0.25, 1e-12);
  EXPECT_NEAR(corridor(-0.55), 0.25, 1e-12);
  EXPECT_EQ(corridor(1.01), 0);
}

// A pulse and the same pulse k samples later: the shift is found, what lies over each other is identical.
TEST(IsoRating, APureShiftCostsPhaseAlone) {
  for (const int later : {20, -30, 59}) {
    const auto pulse = [](double t) { return std::exp(-std::pow((t - 0.5) / 0.06, 2)); };
    const auto moved = [&](double t) { return pulse(t - later / 300.0); };
    const IsoRating rating = iso_rating(samples(300, pulse), samples(300, moved));
    EXPECT_EQ(rating.shift, later);
    EXPECT_NEAR(rating.phase, 1 - std::abs(later) / 60.0, 1e-12);
    EXPECT_NEAR(rating.magnitude, 1, 1e-9);
    EXPECT_NEAR(rating.slope, 1, 1e-9);
  }
}

// A straight line 1.5 times as steep has slopes 0.5 off: E_S = 1 - 0.5 / 2.
TEST(IsoRating, SlopesAreComparedRelativeToTheReference) {
  const IsoRating rating =
      iso_rating(samples(200, [](double t) { return t; }), samples(200, [](double t) { return 1.5 * t; }));
  EXPECT_EQ(rating.shift, 0);
  EXPECT_NEAR(rating.slope, 0.75, 1e-12);
}

TEST(IsoRating, WithoutAReferenceThereIsNothingToAgreeWith) {
  const std::vector<double> zero(100, 0.0);
  const IsoRating rating = iso_rating(zero, samples(100, [](double t) { return t; }));
  EXPECT_NEAR(rating.corridor, 0.01, 1e-12);  // the first sample is zero in both
  EXPECT_EQ(rating.phase, 1);
  EXPECT_EQ(rating.magnitude, 0);
  EXPECT_EQ(rating.slope, 0);
}

TEST(IsoRating, Grades) {
  EXPECT_EQ(grade_of(0.95), std::string("excellent"));
  EXPECT_EQ(grade_of(0.94), std::string("good"));
  EXPECT_EQ(grade_of(0.80), std::string("fair"));
  EXPECT_EQ(grade_of(0.58), std::string("poor"));
}

struct Published {
  const char* name;
  std::vector<double> reference;
  std::vector<double> curve;
  long shift;
  double corridor, phase, magnitude, slope, rating;
};

double multitone(double t) {
  return 0.65 * std::sin(2 * pi * 3 * t) + 0.25 * std::sin(2 * pi * 7 * t + 0.35) +
         0.10 * std::cos(2 * pi * 11 * t - 0.2);
}
double chirp(double t) {
  return std::sin(2 * pi * (1.5 * t + 10 * t * t));
}
double bell(double t, double centre, double width) {
  return std::exp(-0.5 * std::pow((t - centre) / width, 2));
}
double pulses(double t) {
  return bell(t, 0.18, 0.012) - 0.75 * bell(t, 0.41, 0.025) + 0.55 * bell(t, 0.73, 0.018);
}
double steps(double t) {
  return 0.75 * std::tanh((t - 0.38) / 0.025) - 0.45 * std::tanh((t - 0.68) / 0.035);
}
double demo_reference(double t) {
  return 0.65 * std::sin(2 * pi * 3 * t) + 0.20 * std::sin(2 * pi * 9 * t + 0.25) +
         0.10 * std::tanh((t - 0.42) / 0.035);
}
double demo_curve(double t) {
  const double s = t - 0.012;
  return 0.62 * std::sin(2 * pi * 3 * s) + 0.18 * std::sin(2 * pi * 9 * s + 0.25) +
         0.09 * std::tanh((t - 0.44) / 0.04) + 0.025;
}

// What the algorithm of the Python package objective-rating-metrics (TU Graz, OpenVT; its authors verified it
// with the standard's data) gives for curves of formulas, computed apart from this program with numpy.
TEST(IsoRating, AgreesWithTheOpenImplementation) {
  const auto later = [](double (*of)(double), double by) {
    return samples(512, [=](double t) { return of(t - by); });
  };
  const std::vector<Published> cases = {
      {"two sines and a step", samples(600, demo_reference), samples(600, demo_curve), 7, 0.6528907168993214,
       0.9416666666666667, 0.9506540192911956, 0.9566865092308937, 0.8309577257974798},
      {"three sines", later(multitone, 0), later(multitone, 0.02), 10, 0.552182037821968, 0.90234375,
       0.9801311774581773, 0.9903208641910538, 0.7954319734586335},
      {"chirp", later(chirp, 0), later(chirp, 0.05), 26, 0.17050486216676555, 0.74609375, 0.8916583458048465,
       0.9665813654097359, 0.5890686371096228},
      {"pulses", later(pulses, 0), later(pulses, 0.1), 51, 0.6442064272411482, 0.501953125,
       0.9647338462782324, 0.9862134465701562, 0.748262654466137},
      {"steps", later(steps, 0), later(steps, 0.18), 92, 0.5552571282689793, 0.10156250000000006,
       0.996984521306626, 0.9946122997828509, 0.6407347155254871},
      {"earlier and larger pulses", later(pulses, 0),
       samples(512, [](double t) { return 1.2 * pulses(t + 0.05); }), -26, 0.6933037656033096, 0.74609375,
       0.8678959209714674, 0.8967990877971442, 0.7794792579950462},
  };
  for (const Published& one : cases) {
    const IsoRating rating = iso_rating(one.reference, one.curve);
    EXPECT_EQ(rating.shift, one.shift) << one.name;
    EXPECT_NEAR(rating.corridor, one.corridor, 1e-10) << one.name;
    EXPECT_NEAR(rating.phase, one.phase, 1e-10) << one.name;
    EXPECT_NEAR(rating.magnitude, one.magnitude, 1e-10) << one.name;
    EXPECT_NEAR(rating.slope, one.slope, 1e-10) << one.name;
    EXPECT_NEAR(rating.rating, one.rating, 1e-10) << one.name;
  }
}

}  // namespace
}  // namespace crumple::compare::iso_rating_test
