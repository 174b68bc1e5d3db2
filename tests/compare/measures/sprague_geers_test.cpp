// SPDX-License-Identifier: BSD-3-Clause
#include "compare/measures/sprague_geers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace crumple::compare::sprague_geers_test {
namespace {

using std::numbers::pi;

/// 2001 samples over the times from 0 to `end`.
std::vector<double> samples(double end, const std::function<double(double)>& of) {
  std::vector<double> values(2001);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = of(end * static_cast<double>(i) / 2000);
  return values;
}

TEST(SpragueGeers, IdenticalCurvesHaveNoError) {
  const auto curve = samples(1, [](double t) { return 3 * t * t - 1; });
  const SpragueGeers errors = sprague_geers(curve, curve);
  EXPECT_DOUBLE_EQ(errors.magnitude, 0);
  EXPECT_NEAR(errors.phase, 0, 1e-7);  // the arc cosine next to 1 knows half of the digits
  EXPECT_NEAR(errors.combined, 0, 1e-7);
}

TEST(SpragueGeers, AFactorIsMagnitudeAlone) {
  const auto curve = [](double t) { return std::exp(-t) * std::sin(2 * pi * t); };
  for (const double factor : {0.5, 0.8, 1.2, 3.0}) {
    const SpragueGeers errors =
        sprague_geers(samples(3, curve), samples(3, [&](double t) { return factor * curve(t); }));
    EXPECT_NEAR(errors.magnitude, factor - 1, 1e-14);
    EXPECT_NEAR(errors.phase, 0, 1e-7);
  }
}

TEST(SpragueGeers, TheOtherSignIsHalfATurn) {
  const auto curve = [](double t) { return t * (2 - t); };
  const SpragueGeers errors =
      sprague_geers(samples(2, curve), samples(2, [&](double t) { return -curve(t); }));
  EXPECT_NEAR(errors.magnitude, 0, 1e-14);
  EXPECT_DOUBLE_EQ(errors.phase, 1);
}

// Over whole periods the integrals of sines are those of the formula: P is the shift over half a period. The
// trapezoidal rule is exact for them.
TEST(SpragueGeers, AShiftedSineHasItsAngle) {
  for (const double angle : {0.1, 0.5, 1.0, 2.0, 3.0}) {
    const SpragueGeers errors =
        sprague_geers(samples(4, [](double t) { return std::sin(2 * pi * t); }),
                      samples(4, [&](double t) { return 1.3 * std::sin(2 * pi * t - angle); }));
    EXPECT_NEAR(errors.magnitude, 0.3, 1e-12);
    EXPECT_NEAR(errors.phase, angle / pi, 1e-12);
    EXPECT_NEAR(errors.combined, std::hypot(0.3, angle / pi), 1e-12);
  }
}

// m = 1 and c = t over 0 to 1: I_mm = 1, I_cc = 1/3, I_mc = 1/2.
TEST(SpragueGeers, IntegralsOfPolynomials) {
  const SpragueGeers errors =
      sprague_geers(samples(1, [](double) { return 1.0; }), samples(1, [](double t) { return t; }));
  EXPECT_NEAR(errors.magnitude, std::sqrt(1.0 / 3) - 1, 1e-7);
  EXPECT_NEAR(errors.phase, std::acos(std::sqrt(3.0) / 2) / pi, 1e-7);
}

TEST(SpragueGeers, ZeroCurves) {
  const std::vector<double> zero(50, 0.0);
  const std::vector<double> one(50, 1.0);
  EXPECT_EQ(sprague_geers(zero, zero).combined, 0);
  EXPECT_EQ(sprague_geers(one, zero).magnitude, -1);
  EXPECT_EQ(sprague_geers(one, zero).phase, 0);
  EXPECT_TRUE(std::isinf(sprague_geers(zero, one).magnitude));
}

TEST(SpragueGeers, HugeAndTinyValuesDoNotOverflow) {
  const std::vector<double> huge(50, 1e200);
  const std::vector<double> tiny(50, 1e-200);
  EXPECT_DOUBLE_EQ(sprague_geers(huge, huge).combined, 0);
  EXPECT_DOUBLE_EQ(sprague_geers(tiny, tiny).combined, 0);
}

}  // namespace
}  // namespace crumple::compare::sprague_geers_test
