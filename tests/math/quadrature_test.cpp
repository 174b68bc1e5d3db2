// SPDX-License-Identifier: BSD-3-Clause
#include "math/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace crumple::math::quadrature_test {
namespace {

double integral(const Quadrature& rule, int degree) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.point.size(); ++i) sum += rule.weight[i] * std::pow(rule.point[i], degree);
  return 2 * sum;
}

double exact(int degree) {
  return degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0;
}

/// Exact up to the rule's degree and not one further: that fixes points and weights.
void check_degree(const Quadrature& rule, int degree) {
  for (int d = 0; d <= degree; ++d) EXPECT_NEAR(integral(rule, d), exact(d), 5e-15) << "degree " << d;
  EXPECT_GT(std::fabs(integral(rule, degree + 1) - exact(degree + 1)), 1e-8);
}

TEST(Quadrature, GaussIsExactToItsDegree) {
  for (int n = 1; n <= 10; ++n) check_degree(gauss_rule(n), 2 * n - 1);
}

TEST(Quadrature, LobattoIsExactToItsDegreeAndHoldsTheEnds) {
  for (int n = 2; n <= 10; ++n) {
    const Quadrature rule = lobatto_rule(n);
    EXPECT_EQ(rule.point.front(), -1);
    EXPECT_EQ(rule.point.back(), 1);
    check_degree(rule, 2 * n - 3);
  }
}

TEST(Quadrature, TrapezoidIsExactForStraightLinesAndConverges) {
  for (int n = 2; n <= 20; ++n) {
    const Quadrature rule = trapezoid_rule(n);
    EXPECT_EQ(rule.point.front(), -1);
    EXPECT_EQ(rule.point.back(), 1);
    check_degree(rule, 1);
    // The error of the composite rule for x^2 is h^2/12 times the difference of the slopes at the ends.
    const double spacing = 2.0 / (n - 1);
    EXPECT_NEAR(integral(rule, 2) - exact(2), spacing * spacing / 3, 1e-15);
  }
}

TEST(Quadrature, KnownValues) {
  // Abramowitz & Stegun (1964), tables 25.4 and 25.6.
  EXPECT_NEAR(gauss_rule(5).point[4], 0.906179845938664, 1e-15);
  EXPECT_NEAR(gauss_rule(5).weight[4], 0.236926885056189 / 2, 1e-15);
  EXPECT_NEAR(lobatto_rule(5).point[3], 0.65465367, 1e-8);
  EXPECT_NEAR(lobatto_rule(5).weight[2], 0.71111111 / 2, 1e-8);
}

TEST(Quadrature, SymmetricToTheBit) {
  for (int n = 2; n <= 10; ++n)
    for (const Quadrature& rule : {gauss_rule(n), lobatto_rule(n), trapezoid_rule(n)})
      for (int i = 0; i < n; ++i) {
        EXPECT_EQ(rule.point[i], -rule.point[n - 1 - i]);
        EXPECT_EQ(rule.weight[i], rule.weight[n - 1 - i]);
      }
}

}  // namespace
}  // namespace crumple::math::quadrature_test
